// Enumerations whose values have names. Each enumeration has one table, declared beside it, with one row per value in
// the order of the enumerators:
//
//   enum class Style : std::uint8_t { day, dusk };
//   inline constexpr base::NameRow kStyles[] = {{"day", "Day", "The sun is high."}, {"dusk", "Dusk", "Long shadows."}};
//   constexpr std::span<const base::NameRow> rows_of(Style) { return kStyles; }
//
// A table may have rows of its own type, provided they have a `name`. Commands, files, queries, combo boxes and help
// read the rows through the functions below.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/check.h"

namespace coaster::base {

struct NameRow {
  std::string_view name;        // in scripts and files
  std::string_view label = {};  // in panels; empty where no panel shows it
  std::string_view help = {};   // one line for the tooltip
};

// True for enumerations with a function rows_of() in their own namespace.
template <class E>
concept Named = std::is_enum_v<E> && requires(E value) {
  rows_of(value)[0].name;
};

template <Named E>
constexpr std::size_t count_of() {
  return rows_of(E{}).size();
}

// False for numbers that are not a value of the enumeration, such as a cast from untrusted input.
template <Named E>
constexpr bool has_row(E value) {
  return static_cast<std::size_t>(value) < count_of<E>();
}

// Returns the row of a value; the value must be valid (COASTER_CHECK).
template <Named E>
constexpr const auto& row_of(E value) {
  COASTER_CHECK(has_row(value), "every value of a named enumeration has its row");
  return rows_of(value)[static_cast<std::size_t>(value)];
}
template <Named E>
constexpr std::string_view name_of(E value) {
  return row_of(value).name;
}

// Returns the value with this name; nothing for any other word.
template <Named E>
std::optional<E> value_named(std::string_view name) {
  for (std::size_t i = 0; i < count_of<E>(); ++i)
    if (rows_of(E{})[i].name == name) return static_cast<E>(i);
  return std::nullopt;
}

// Returns the value after this one; after the last one, the first.
template <Named E>
constexpr E next_of(E value) {
  return static_cast<E>((static_cast<std::size_t>(value) + 1) % count_of<E>());
}

// Returns the names of a table, in the order of its rows.
template <class Rows>
std::vector<std::string> names_in(const Rows& rows) {
  std::vector<std::string> names;
  for (const auto& row : rows) names.emplace_back(row.name);
  return names;
}
template <Named E>
std::vector<std::string> names_of() {
  return names_in(rows_of(E{}));
}

// Returns "a, b or c"; with quote '"': "\"a\", \"b\" or \"c\"".
inline std::string alternatives(std::span<const std::string> names, std::string_view quote = {}) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text.append(i == 0 ? "" : i + 1 < names.size() ? ", " : " or ").append(quote).append(names[i]).append(quote);
  return text;
}
template <Named E>
std::string alternatives_of(std::string_view quote = {}) {
  return alternatives(names_of<E>(), quote);
}

}  // namespace coaster::base
