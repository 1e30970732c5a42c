// The elements of the palette as plain data: which there are, and their parameters with units, defaults and limits.
// Their geometry is in sim/plan/elements.h.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "base/names.h"

namespace coaster::world {

// Rows of elements(), in its order.
enum class ElementKind : std::uint8_t { straight, curve, helix, climb, dive, camelback, loop, corkscrew };

struct ElementParameter {
  std::string_view name;   // in scripts and recordings: "radius"
  std::string_view label;  // in the panel
  std::string_view unit;   // "" where there is none
  double usual;            // at first
  double low, high;        // what is beyond is clamped with a notice
  std::string_view help;
};

inline constexpr std::size_t kMaxElementParameters = 5;

struct ElementRow {
  std::string_view name;   // in scripts and recordings: "element curve ..."
  std::string_view label;  // in the panel
  std::string_view help;
  bool sided;  // left or right makes a difference
  std::span<const ElementParameter> parameters;
};
std::span<const ElementRow> elements();
inline std::span<const ElementRow> rows_of(ElementKind) { return elements(); }

// One element with its parameters: the first of `values` are those of its row, in the row's order; the others are 0.
struct Element {
  ElementKind kind = ElementKind::straight;
  bool right = false;  // false: to the left; false where the row is not sided
  std::array<double, kMaxElementParameters> values{};
  friend bool operator==(const Element&, const Element&) = default;
};

// The row's usual values, to the left.
Element usual_element(ElementKind kind);

// The value of a parameter that the element's row has (COASTER_CHECK).
double value_of(const Element& element, std::string_view parameter);

}  // namespace coaster::world
