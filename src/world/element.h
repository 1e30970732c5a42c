// The elements of the palette as plain data. To add one: an enumerator and a row here, its parameters in
// element_rows.h, its shape in sim/plan/element_shapes_*.cpp and in the table there, its icon in ui/widgets/icons.cpp;
// for a force element its keys in sim/plan/force_elements.cpp instead.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "base/names.h"
#include "world/element_rows.h"

namespace coaster::world {

// Rows of elements(), in its order, then of force_elements().
enum class ElementKind : std::uint8_t {
  straight,
  curve,
  helix,
  climb,
  dive,
  camelback,
  loop,
  corkscrew,
  s_bend,
  overbanked_turn,
  bunny_hops,
  zero_g_roll,
  immelmann,
  dive_loop,
  cobra_roll,
  brake_run,
  force_hill,
  force_valley,
  force_turn,
  force_roll,
  force_heartline,
  force_loop,
  force_brakes
};
// True for a force element, which is placed as a force section: what riders feel shapes it, and its keys can be edited.
constexpr bool is_of_forces(ElementKind kind) { return kind >= ElementKind::force_hill; }

inline constexpr std::size_t kMaxElementParameters = 5;

struct ElementRow {
  std::string_view name;   // in scripts and recordings: "element curve ..."
  std::string_view label;  // in the panel
  std::string_view help;
  bool sided;  // has a left and a right form
  std::span<const ElementParameter> parameters;
};

inline constexpr ElementRow kElements[] = {
    {"straight", "Straight", "A straight. It can roll.", false, element_rows::kStraight},
    {"curve", "Banked curve",
     "A banked turn with roll-in and roll-out: curvature and bank rise, stay and fall. It keeps the slope it starts "
     "with.",
     true, element_rows::kCurve},
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
    {"s_bend", "S-bend",
     "Two banked turns, one to each side, without a straight between them. It ends in the same direction.", true,
     element_rows::kSBend},
    {"overbanked_turn", "Overbanked",
     "Overbanked turn: it rises and falls while it turns, banked beyond the vertical at the top. It starts and ends "
     "level.",
     true, element_rows::kOverbankedTurn},
    {"bunny_hops", "Bunny hops", "Low hills in a row, each with airtime: parabolas between valleys.", false,
     element_rows::kBunnyHops},
    {"zero_g_roll", "Zero-g roll", "A hill over whose crest riders float while they are rolled by 360 degrees.", true,
     element_rows::kZeroGRoll},
    {"immelmann", "Immelmann",
     "Half a loop upwards, then half a roll on which riders float. It ends upright in the opposite direction, higher.",
     true, element_rows::kImmelmann},
    {"dive_loop", "Dive loop",
     "Half a roll on which riders float, then half a loop downwards. It ends upright in the opposite direction, lower.",
     true, element_rows::kDiveLoop},
    {"cobra_roll", "Cobra roll",
     "Two inversions: up a half loop, twisted down into a valley across the entry, and the same mirrored. It ends in "
     "the opposite direction, shifted sideways.",
     true, element_rows::kCobraRoll},
    {"brake_run", "Brake run", "Level brakes, then a station: the end of a ride. A sloping end is levelled first.",
     false, element_rows::kBrakeRun},
    {"force_hill", "Float hill", "A hill over which riders float for some seconds, between bends of constant g.", false,
     element_rows::kForceHill},
    {"force_valley", "Valley", "A bend of constant g up or down to a slope: a valley, a pull-up or a crest.", false,
     element_rows::kForceValley},
    {"force_turn", "Turn", "A level turn at constant g, banked so that riders feel no lateral g.", true,
     element_rows::kForceTurn},
    {"force_roll", "Float roll", "A hill over which riders float while they are rolled by 360 degrees.", true,
     element_rows::kForceRoll},
    {"force_heartline", "Heartline", "A roll by 360 degrees about the riders' straight path.", true,
     element_rows::kForceHeartline},
    {"force_loop", "Force loop", "A loop at constant g: a teardrop, tighter towards the top. It ends level.", true,
     element_rows::kForceLoop},
    {"force_brakes", "Brakes", "Straight brakes, as long as the train needs to slow down.", false,
     element_rows::kForceBrakes},
};
constexpr std::span<const ElementRow> rows_of(ElementKind) { return kElements; }
// Elements with a fixed shape; and those that are placed as force sections (sim/plan/force_elements.h).
constexpr std::span<const ElementRow> elements() {
  return rows_of(ElementKind{}).first(static_cast<std::size_t>(ElementKind::force_hill));
}
constexpr std::span<const ElementRow> force_elements() { return rows_of(ElementKind{}).subspan(elements().size()); }

// One element with its parameters: the first `values` are those of its row, in the row's order; the others are 0.
struct Element {
  ElementKind kind = ElementKind::straight;
  bool right = false;  // false: to the left; always false if the row is not sided
  std::array<double, kMaxElementParameters> values{};
  friend bool operator==(const Element&, const Element&) = default;
};

// Return an element with the row's default values, to the left; and all such elements, by kind.
Element usual_element(ElementKind kind);
std::array<Element, base::count_of<ElementKind>()> usual_elements();

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
