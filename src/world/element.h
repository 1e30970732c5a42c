// The elements of the palette as plain data, with their parameters, units, defaults and limits. To add one: an
// enumerator and a row here, its shape in sim/plan/element_shapes.cpp, its icon in ui/widgets/icons.cpp.
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
  double usual;            // default value
  double low, high;        // values beyond are clamped with a notice
  std::string_view help;
};

inline constexpr std::size_t kMaxElementParameters = 5;

struct ElementRow {
  std::string_view name;   // in scripts and recordings: "element curve ..."
  std::string_view label;  // in the panel
  std::string_view help;
  bool sided;  // has a left and a right form
  std::span<const ElementParameter> parameters;
};

namespace element_rows {
inline constexpr std::string_view kSpeedHelp =
    "Banks for this speed: riders feel no lateral g at the tightest place. 0: use Bank.";
inline constexpr ElementParameter kStraight[] = {
    {"length", "Length", "m", 30, 2, 2000, "Length of the straight."},
    {"roll", "Roll", "deg", 0, -1440, 1440,
     "Roll along it, positive to the rider's right. 0 levels out, 360 is an inline twist."},
};
inline constexpr ElementParameter kCurve[] = {
    {"radius", "Radius", "m", 25, 3, 1000, "Radius of the circle between the two ramps of curvature."},
    {"angle", "Angle", "deg", 90, 1, 1080, "Change of direction."},
    {"bank", "Bank", "deg", 40, -30, 110,
     "Roll towards the inside at the tightest place. Ignored when a speed is set."},
    {"speed", "For speed", "m/s", 0, 0, 150, kSpeedHelp},
};
inline constexpr ElementParameter kHelix[] = {
    {"radius", "Radius", "m", 16, 3, 1000, "Radius in plan, between the two ramps of curvature."},
    {"turns", "Turns", "", 2, 0.25, 12, "Number of turns of 360 degrees."},
    {"height", "Height", "m", -10, -200, 200, "Rise from start to end. Below 0 it descends."},
    {"bank", "Bank", "deg", 50, -30, 110, "Roll towards the inside. Ignored when a speed is set."},
    {"speed", "For speed", "m/s", 0, 0, 150, kSpeedHelp},
};
inline constexpr ElementParameter kClimb[] = {
    {"height", "Height", "m", 25, 0.5, 300, "Rise from start to end."},
    {"angle", "Angle", "deg", 35, 2, 90, "Steepest slope."},
    {"radius", "Radius", "m", 20, 3, 500, "Smallest radius of its bends."},
};
inline constexpr ElementParameter kDive[] = {
    {"height", "Height", "m", 20, 0.5, 300, "Drop from start to end."},
    {"angle", "Angle", "deg", 55, 2, 90, "Steepest slope."},
    {"radius", "Radius", "m", 22, 3, 500, "Smallest radius of its bends."},
};
inline constexpr ElementParameter kCamelback[] = {
    {"height", "Height", "m", 14, 1, 150, "Height of the crest above the foot."},
    {"speed", "At speed", "m/s", 22, 5, 100,
     "Speed at the foot at which riders are weightless over the whole crest, a parabola."},
    {"radius", "Radius", "m", 25, 3, 500, "Smallest radius of the bends at its feet."},
};
inline constexpr ElementParameter kLoop[] = {
    {"height", "Height", "m", 16, 3, 100, "Height of the top above the foot."},
    {"top", "Top", "deg", 90, 0, 240,
     "Angle of the circle at the top. The rest are clothoids that widen towards the foot."},
    {"shift", "Shift", "m", 3.5, 2.5, 30, "Sideways distance between entry and exit, so that the loop clears itself."},
};
inline constexpr ElementParameter kCorkscrew[] = {
    {"height", "Height", "m", 9, 3, 60, "Height of the top above the foot."},
    {"angle", "Axis", "deg", 45, 10, 70, "Angle between the entry and the axis of the helix."},
    {"top", "Top", "deg", 150, 0, 240, "Angle of the turn that is a true helix. It widens before and after."},
};
}  // namespace element_rows

inline constexpr ElementRow kElements[] = {
    {"straight", "Straight", "A straight. It can roll.", false, element_rows::kStraight},
    {"curve", "Curve", "A banked turn: its curvature rises, stays and falls. It keeps the slope it starts with.", true,
     element_rows::kCurve},
    {"helix", "Helix", "A rising or descending helix that ends level.", true, element_rows::kHelix},
    {"climb", "Climb", "A climb that ends level, for lifts.", false, element_rows::kClimb},
    {"dive", "Dive", "A drop that ends level.", false, element_rows::kDive},
    {"camelback", "Camelback", "A hill with airtime: a parabola between clothoids.", false, element_rows::kCamelback},
    {"loop", "Loop",
     "A clothoid (teardrop) loop: its curvature grows from the foot to the top, which limits g at the foot.", true,
     element_rows::kLoop},
    {"corkscrew", "Corkscrew",
     "An inversion around a horizontal axis. It ends upright, in the same direction, shifted sideways.", true,
     element_rows::kCorkscrew},
};
constexpr std::span<const ElementRow> elements() { return kElements; }
constexpr std::span<const ElementRow> rows_of(ElementKind) { return elements(); }

// One element with its parameters: the first `values` are those of its row, in the row's order; the others are 0.
struct Element {
  ElementKind kind = ElementKind::straight;
  bool right = false;  // false: to the left; always false if the row is not sided
  std::array<double, kMaxElementParameters> values{};
  friend bool operator==(const Element&, const Element&) = default;
};

// Returns an element with the row's default values, to the left.
Element usual_element(ElementKind kind);

// True for a row of the table, a side that it has, values within its limits, and 0 beyond its parameters.
bool within_limits(const Element& element);

// Returns the element with its values brought within their limits.
Element limited(Element element);

// Returns the value of a parameter that the element's row has (COASTER_CHECK).
double value_of(const Element& element, std::string_view parameter);

}  // namespace coaster::world
