// What the C++ library of Emscripten 3.1 lacks of C++20: std::bit_cast, and those algorithms of std::ranges that the
// program uses, for arrays and containers. Every source of the build for browsers includes it first
// (cmake/options.cmake).
#pragma once

#if defined(__cplusplus)
#include <algorithm>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <version>

#if !defined(__cpp_lib_bit_cast)
_LIBCPP_BEGIN_NAMESPACE_STD
template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  static_assert(sizeof(To) == sizeof(From));
  return __builtin_bit_cast(To, from);
}
_LIBCPP_END_NAMESPACE_STD
#endif

#if !defined(__cpp_lib_ranges)
_LIBCPP_BEGIN_NAMESPACE_STD
namespace ranges {

// X(NAME): std::NAME(first, last, test) with a projection.
#define COASTER_TESTS(X) X(all_of) X(any_of) X(none_of) X(find_if) X(count_if)
#define X(name)                                                                                                   \
  template <class Range, class Test, class Projection = std::identity>                                            \
  constexpr auto name(Range&& range, Test test, Projection projection = {}) {                                     \
    return std::name(std::begin(range), std::end(range),                                                          \
                     [&](const auto& item) -> bool { return std::invoke(test, std::invoke(projection, item)); }); \
  }
COASTER_TESTS(X)
#undef X
#undef COASTER_TESTS

template <class Range, class Value, class Projection = std::identity>
constexpr auto find(Range&& range, const Value& value, Projection projection = {}) {
  return std::find_if(std::begin(range), std::end(range),
                      [&](const auto& item) { return std::invoke(projection, item) == value; });
}
template <class Range, class Visit>
constexpr void for_each(Range&& range, Visit&& visit) {
  for (auto&& item : range) std::invoke(visit, item);
}
template <class Range>
constexpr auto adjacent_find(Range&& range) {
  return std::adjacent_find(std::begin(range), std::end(range));
}
template <class Range, class Less = std::less<>, class Projection = std::identity>
constexpr void sort(Range&& range, Less less = {}, Projection projection = {}) {
  std::sort(std::begin(range), std::end(range), [&](const auto& a, const auto& b) -> bool {
    return std::invoke(less, std::invoke(projection, a), std::invoke(projection, b));
  });
}
template <class Range, class Less = std::less<>, class Projection = std::identity>
constexpr void stable_sort(Range&& range, Less less = {}, Projection projection = {}) {
  std::stable_sort(std::begin(range), std::end(range), [&](const auto& a, const auto& b) -> bool {
    return std::invoke(less, std::invoke(projection, a), std::invoke(projection, b));
  });
}
template <class A, class B, class Test = std::equal_to<>, class OfA = std::identity, class OfB = std::identity>
constexpr bool equal(const A& a, const B& b, Test test = {}, OfA of_a = {}, OfB of_b = {}) {
  return std::equal(std::begin(a), std::end(a), std::begin(b), std::end(b), [&](const auto& x, const auto& y) -> bool {
    return std::invoke(test, std::invoke(of_a, x), std::invoke(of_b, y));
  });
}
template <class Range, class Value>
constexpr void fill(Range&& range, const Value& value) {
  std::fill(std::begin(range), std::end(range), value);
}
template <class Range, class Value>
constexpr auto count(Range&& range, const Value& value) {
  return std::count(std::begin(range), std::end(range), value);
}
template <class Range, class Less = std::less<>, class Projection = std::identity>
constexpr auto min_element(Range&& range, Less less = {}, Projection projection = {}) {
  return std::min_element(std::begin(range), std::end(range), [&](const auto& a, const auto& b) -> bool {
    return std::invoke(less, std::invoke(projection, a), std::invoke(projection, b));
  });
}
template <class Range, class Less = std::less<>, class Projection = std::identity>
constexpr auto max_element(Range&& range, Less less = {}, Projection projection = {}) {
  return std::max_element(std::begin(range), std::end(range), [&](const auto& a, const auto& b) -> bool {
    return std::invoke(less, std::invoke(projection, a), std::invoke(projection, b));
  });
}
template <class Range>
constexpr auto minmax_element(Range&& range) {
  return std::minmax_element(std::begin(range), std::end(range));
}
template <class Range, class Value, class Less = std::less<>, class Projection = std::identity>
constexpr auto lower_bound(Range&& range, const Value& value, Less less = {}, Projection projection = {}) {
  return std::lower_bound(std::begin(range), std::end(range), value, [&](const auto& item, const auto& wanted) -> bool {
    return std::invoke(less, std::invoke(projection, item), wanted);
  });
}
template <class Range, class Value, class Less = std::less<>, class Projection = std::identity>
constexpr auto upper_bound(Range&& range, const Value& value, Less less = {}, Projection projection = {}) {
  return std::upper_bound(std::begin(range), std::end(range), value, [&](const auto& wanted, const auto& item) -> bool {
    return std::invoke(less, wanted, std::invoke(projection, item));
  });
}

}  // namespace ranges
_LIBCPP_END_NAMESPACE_STD
#endif
#endif
