// 64-bit hashes of state (XXH64, seed 0): for determinism checks, never for security.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>

#include <glm/glm.hpp>

namespace coaster::base {

// Hashes values in order; equal sequences of values give equal digests on every compiler and build. -0.0 counts as
// +0.0, as in operator==. Numbers are hashed as little-endian.
class Hasher {
 public:
  Hasher();
  ~Hasher();
  Hasher(const Hasher&) = delete;
  Hasher& operator=(const Hasher&) = delete;

  void bytes(const void* data, std::size_t size);
  template <class T>
  requires std::is_integral_v<T> || std::is_enum_v<T>
  void add(T value) {
    const auto wide = static_cast<std::int64_t>(value);
    bytes(&wide, sizeof wide);
  }
  void add(float value) { add_bits(value == 0.0f ? 0.0f : value); }
  void add(double value) { add_bits(value == 0.0 ? 0.0 : value); }
  void add(glm::vec3 v) { add(v.x), add(v.y), add(v.z); }
  void add(std::string_view text) { add(text.size()), bytes(text.data(), text.size()); }
  std::uint64_t digest() const;

 private:
  template <class T>
  void add_bits(T value) {
    bytes(&value, sizeof value);
  }
  struct State;
  std::unique_ptr<State> state_;
};

// Returns the digest of a file's contents.
std::uint64_t content_hash(std::string_view bytes);

// Returns 16 lower-case hexadecimal digits.
std::string hex16(std::uint64_t value);

}  // namespace coaster::base
