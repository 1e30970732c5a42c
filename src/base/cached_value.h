// A value that depends on a key, cached while the key is the same.
#pragma once

#include <optional>

namespace coaster::base {

template <class Key, class Value>
struct CachedValue {
  std::optional<Key> key;
  Value value{};
  // Returns the cached value for `wanted`; if the key differs, calls `make()` and caches its result.
  template <class Make>
  const Value& get(const Key& wanted, Make make) {
    if (!key || !(*key == wanted)) {
      value = make();
      key = wanted;
    }
    return value;
  }
};

}  // namespace coaster::base
