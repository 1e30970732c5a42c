// Bitwise comparison and copying of plain data.
#pragma once

#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace coaster::base {

// True if both have the same size and the same bits, padding included: 0 differs from -0, and a NaN equals itself.
// Equal values may differ in bits. About as fast as reading memory.
template <class T>
bool same_bits(std::span<const T> a, std::span<const T> b) {
  static_assert(std::is_trivially_copyable_v<T>);
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
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
