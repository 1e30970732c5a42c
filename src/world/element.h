// An element of the palette with the values of its parameters. The elements there are: world/element_rows.h.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace coaster::base {
struct NameRow;
}

namespace coaster::world {

enum class ElementKind : std::uint8_t;  // world/element_rows.h
struct ElementParameter;
inline constexpr std::size_t kMaxElementParameters = 5;

// One element with its parameters: the first `values` are those of its row, in the row's order; the others are 0.
struct Element {
  ElementKind kind{};
  bool right = false;  // false: to the left; always false if the row is not sided
  std::array<double, kMaxElementParameters> values{};
  friend bool operator==(const Element&, const Element&) = default;
};

// Return an element with the row's default values, to the left; all such elements, by kind; and the element and the
// force element with which the palette begins.
Element usual_element(ElementKind kind);
std::vector<Element> usual_elements();
Element first_element();
ElementKind first_of_forces();
// True for a force element, which is placed as a force section: what riders feel shapes it, and its keys can be edited.
bool is_of_forces(ElementKind kind);

// True if the kind is in the table, the side exists, the values are within their limits, and those beyond its
// parameters are 0.
bool within_limits(const Element& element);

// Returns the element with its values clamped to their limits.
Element limited(Element element);

// Returns the row of a parameter's choice.
const base::NameRow& choice_of(const ElementParameter& parameter, double value);

// Returns the value of a parameter; nothing if the element's row does not have it.
std::optional<double> found_value(const Element& element, std::string_view parameter);
// Returns the value of a parameter that the row must have (COASTER_CHECK).
double value_of(const Element& element, std::string_view parameter);
// Sets a parameter, clamped to its limits; no-op if the element's row does not have it.
void set_value(Element& element, std::string_view parameter, double value);

// False for a parameter that has no effect with the other values: a value of the equipment without equipment.
bool counts(const Element& element, const ElementParameter& parameter);

}  // namespace coaster::world
