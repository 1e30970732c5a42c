// Bitwise comparison and copying of plain data.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace coaster::base {

// The bits of a type that hold its value: 0xff, and 0 in its padding, which nobody writes. A compiler that cannot tell
// them apart counts all.
template <class T>
const std::array<unsigned char, sizeof(T)>& value_bits() {
  static const std::array<unsigned char, sizeof(T)> bits = [] {
    alignas(T) std::array<unsigned char, sizeof(T)> all;
    all.fill(0xff);
#if defined(__GNUC__) && !defined(__clang__)
    __builtin_clear_padding(reinterpret_cast<T*>(all.data()));
#endif
    return all;
  }();
  return bits;
}

// True if both have the same size and the same bits, without padding: 0 differs from -0, and a NaN equals itself. Equal
// values may differ in bits. About as fast as reading memory.
template <class T>
bool same_bits(std::span<const T> a, std::span<const T> b) {
  static_assert(std::is_trivially_copyable_v<T>);
  if (a.size() != b.size()) return false;
  const std::array<unsigned char, sizeof(T)> bits = value_bits<T>();
  const auto bytes = [](std::span<const T> of) { return reinterpret_cast<const unsigned char*>(of.data()); };
  const unsigned char *x = bytes(a), *y = bytes(b);
  if (std::ranges::find(bits, 0) == bits.end()) return a.empty() || std::memcmp(x, y, a.size_bytes()) == 0;
  unsigned char differs = 0;
  for (std::size_t i = 0; i < a.size(); ++i, x += sizeof(T), y += sizeof(T))
    for (std::size_t k = 0; k < sizeof(T); ++k) differs |= static_cast<unsigned char>((x[k] ^ y[k]) & bits[k]);
  return differs == 0;
}
template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return same_bits(std::span<const T>(a), std::span<const T>(b));
}

// Copies a value with its padding, which an assignment may not copy.
template <class T>
void copy_bits(const T& from, T& to) {
  static_assert(std::is_trivially_copyable_v<T>);
  std::memcpy(static_cast<void*>(&to), &from, sizeof(T));
}

}  // namespace coaster::base
