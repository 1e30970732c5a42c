// A value that follows from a key, kept while the key is the same.
#pragma once

#include <optional>

namespace coaster::base {

template <class Key, class Value>
struct Kept {
  std::optional<Key> key;
  Value value{};
  // The value for `wanted`: the kept one, or what `make()` returns, which is kept from now on.
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
