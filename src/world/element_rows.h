// The elements of the palette as plain data, and their parameters with units, defaults and limits. To add one: an
// enumerator, a row and its parameters here, and its shape in the table of sim/plan/element_shapes.cpp, or for a force
// element its keys in that of sim/plan/force_elements.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "base/enum_names.h"
#include "world/element.h"
#include "world/equipment_rows.h"

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

struct ElementParameter {
  std::string_view name;   // in scripts and recordings: "radius"
  std::string_view label;  // in the panel
  std::string_view unit;   // "" if there is none
  double usual;            // default value
  double low, high;        // values beyond are clamped with a notice
  std::string_view help;
  std::span<const base::NameRow> names = {};  // not empty: a choice, the value is the number of its row
};

struct ElementRow {
  std::string_view name;   // in scripts and recordings: "element curve ..."
  std::string_view label;  // in the panel
  std::string_view help;
  bool sided;  // has a left and a right form
  std::span<const ElementParameter> parameters;
  std::string_view icon;         // its name in ui/widgets/icons.cpp
  std::string_view button = {};  // on the palette's button; empty: the label
  bool proper = false;           // a proper name: keeps its capital in sentences
};

namespace element_rows {
inline constexpr std::string_view kSpeedHelp =
    "Banks for this speed: riders feel no lateral g at the tightest place. 0: use Bank.";
// None, then the kinds of equipment.
inline constexpr auto kEquipmentChoices = [] {
  std::array<base::NameRow, 1 + std::size(kEquipmentKinds)> rows{{{"none", "None", "Plain track."}}};
  for (std::size_t i = 1; i < rows.size(); ++i)
    rows[i] = {kEquipmentKinds[i - 1].name, kEquipmentKinds[i - 1].label, kEquipmentKinds[i - 1].help};
  return rows;
}();
inline constexpr ElementParameter kEquipment{
    "equipment",      "Equipment", "", 0, 0, kEquipmentChoices.size() - 1, "Equipment of the whole element.",
    kEquipmentChoices};
inline constexpr ElementParameter kEquipmentSpeed{
    "speed", "Speed", "m/s", 4, 0, 150, "Speed of the chain, of the dispatch, or behind a launch or brake."};
inline constexpr ElementParameter kStraight[] = {
    {"length", "Length", "m", 30, 2, 2000, "Length of the straight."},
    {"roll", "Roll", "deg", 0, -1440, 1440,
     "Roll along it, positive to the rider's right. 0 levels out, 360 is an inline twist."},
    kEquipment,
    kEquipmentSpeed,
    {"acceleration", "Acceleration", "m/s²", 3, 0.1, 60, "Acceleration of a launch, deceleration of a brake."},
};
inline constexpr ElementParameter kCurve[] = {
    {"radius", "Radius", "m", 25, 3, 1000, "Radius of the circle between the two ramps of curvature."},
    {"angle", "Angle", "deg", 90, 1, 1080, "Change of direction."},
    {"bank", "Bank", "deg", 40, -30, 110,
     "Roll towards the inside at the tightest place. Ignored when a speed is set."},
    {"speed", "For speed", "m/s", 0, 0, 150, kSpeedHelp},
    {"ramp", "Ramps", "m", 0, 0, 200,
     "Length of the roll-in and of the roll-out: the ramps over which curvature and bank rise and fall. 0: a quarter "
     "of "
     "the angle each, at most 30 degrees."},
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
    kEquipment,
    kEquipmentSpeed,
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
inline constexpr ElementParameter kSBend[] = {
    {"radius", "Radius", "m", 25, 3, 1000, "Radius of both circles."},
    {"angle", "Angle", "deg", 45, 1, 170, "Change of direction of each of the two turns."},
    {"bank", "Bank", "deg", 40, -30, 110, "Roll towards the inside of each turn. Ignored when a speed is set."},
    {"speed", "For speed", "m/s", 0, 0, 150, kSpeedHelp},
};
inline constexpr ElementParameter kOverbankedTurn[] = {
    {"radius", "Radius", "m", 20, 8, 1000, "Radius in plan, between the two ramps of curvature."},
    {"angle", "Angle", "deg", 180, 90, 360, "Change of direction."},
    {"height", "Height", "m", 14, 0, 150, "Height of the top above both ends."},
    {"bank", "Bank", "deg", 110, 0, 160, "Roll towards the inside at the top. Ignored when a speed is set."},
    {"speed", "At speed", "m/s", 0, 0, 60,
     "Speed at the start for which it banks: riders feel no lateral g anywhere. 0: use Bank."},
};
inline constexpr std::string_view kFloatSpeedHelp =
    "Speed at the start at which riders are weightless over every crest, a parabola.";
inline constexpr ElementParameter kBunnyHops[] = {
    {"hops", "Hops", "", 3, 1, 12, "Number of hills."},
    {"height", "Height", "m", 4, 1, 30, "Height of the crests above the start."},
    {"speed", "At speed", "m/s", 16, 7, 70, kFloatSpeedHelp},
    {"radius", "Radius", "m", 14, 3, 200, "Smallest radius of the feet and of the valleys."},
};
inline constexpr ElementParameter kZeroGRoll[] = {
    {"height", "Height", "m", 20, 4, 150, "Height of the crest above the foot."},
    {"speed", "At speed", "m/s", 28, 10, 100,
     "Speed at the foot at which riders are weightless while they are rolled over the crest, a parabola."},
    {"radius", "Radius", "m", 25, 3, 500, "Smallest radius of the bends at its feet."},
};
inline constexpr std::string_view kRollSlopeHelp =
    "Slope of the parabola at both ends of the half roll. Larger: a longer roll.";
inline constexpr ElementParameter kImmelmann[] = {
    {"height", "Height", "m", 16, 4, 80, "Rise from start to end."},
    {"speed", "At speed", "m/s", 26, 7, 100, "Speed at the start at which riders are weightless during the half roll."},
    {"angle", "Slope", "deg", 32, 15, 60, kRollSlopeHelp},
    {"radius", "Radius", "m", 18, 5, 100, "Smallest radius of the bend that levels out after the roll."},
};
inline constexpr ElementParameter kDiveLoop[] = {
    {"height", "Height", "m", 16, 4, 80, "Drop from start to end."},
    {"speed", "At speed", "m/s", 19, 7, 100, "Speed at the start at which riders are weightless during the half roll."},
    {"angle", "Slope", "deg", 32, 15, 60, kRollSlopeHelp},
    {"radius", "Radius", "m", 18, 5, 100, "Smallest radius of the bend that climbs to the roll."},
};
inline constexpr ElementParameter kCobraRoll[] = {
    {"height", "Height", "m", 18, 5, 60, "Height of the two tops above the foot."},
    {"top", "Top", "deg", 90, 0, 180, "Angle of the circle at each top. Clothoids widen it before and after."},
};
inline constexpr ElementParameter kBrakeRun[] = {
    {"brakes", "Brakes", "m", 45, 5, 500, "Length of the brakes."},
    {"station", "Station", "m", 30, 5, 500, "Length of the station after them, at least the train's."},
    {"speed", "Speed", "m/s", 4, 0.5, 50, "Speed after the brakes."},
    {"acceleration", "Deceleration", "m/s²", 6, 0.1, 60, "Deceleration of the brakes."},
};
inline constexpr ElementParameter kPull{
    "pull", "Pull", "g", 3, 1.5, 6, "Vertical g of the bends at its feet, at most."};
inline constexpr base::NameRow kHillEnds[] = {{"level", "Level", "Ends level, after a bend like that at its start."},
                                              {"falling", "Falling", "Ends where riders stop floating."}};
inline constexpr ElementParameter kForceHill[] = {
    {"seconds", "Float", "s", 1.5, 0.2, 8, "Time that riders float over the crest."},
    {"g", "Crest", "g", 0, -1.5, 0.8, "Vertical g over the crest. 0: weightless."},
    kPull,
    {"ends", "Ends", "", 0, 0, 1, "How the hill ends.", kHillEnds},
};
inline constexpr ElementParameter kForceValley[] = {
    {"g", "Vertical", "g", 3.5, -2, 8, "Vertical g, at most. Below 1 the track bends down."},
    {"slope", "End slope", "deg", 0, -75, 75, "Slope where it ends. Below 0 the track falls."},
};
inline constexpr ElementParameter kForceTurn[] = {
    {"g", "Vertical", "g", 2.5, 1.1, 6, "Vertical g all through the turn. More banks it farther."},
    {"angle", "Angle", "deg", 180, 10, 720, "Change of direction."},
};
inline constexpr ElementParameter kForceRoll[] = {
    {"seconds", "Float", "s", 2, 1.4, 8, "Time that riders float while they are rolled by 360 degrees."},
    kPull,
};
inline constexpr ElementParameter kForceHeartline[] = {
    {"seconds", "Time", "s", 2.5, 1.4, 10, "Time of the roll by 360 degrees."},
};
inline constexpr ElementParameter kForceLoop[] = {
    {"g", "Vertical", "g", 4, 2.2, 6, "Vertical g all around the loop."},
    {"shift", "Shift", "m", 3.5, 2.5, 10, "Sideways distance between entry and exit, so that the loop clears itself."},
};
inline constexpr ElementParameter kForceBrakes[] = {
    {"speed", "Speed", "m/s", 4, 0.5, 50, "Speed after the brakes."},
    {"acceleration", "Deceleration", "m/s²", 6, 0.1, 60, "Deceleration of the brakes."},
};
}  // namespace element_rows

inline constexpr ElementRow kElements[] = {
    {"straight", "Straight", "A straight. It can roll.", false, element_rows::kStraight, "straight"},
    {"curve", "Banked curve",
     "A banked turn with roll-in and roll-out: curvature and bank rise, stay and fall. It keeps the slope it starts "
     "with.",
     true, element_rows::kCurve, "curve", "Curve"},
    {"helix", "Helix", "A rising or descending helix that ends level.", true, element_rows::kHelix, "helix"},
    {"climb", "Climb", "A climb that ends level, for lifts.", false, element_rows::kClimb, "climb"},
    {"dive", "Dive", "A drop that ends level.", false, element_rows::kDive, "dive"},
    {"camelback", "Camelback", "A hill with airtime: a parabola between clothoids.", false, element_rows::kCamelback,
     "camelback"},
    {"loop", "Loop",
     "A clothoid (teardrop) loop: its curvature grows from the foot to the top, which limits g at the foot.", true,
     element_rows::kLoop, "loop"},
    {"corkscrew", "Corkscrew",
     "An inversion around a horizontal axis. It ends upright, in the same direction, shifted sideways.", true,
     element_rows::kCorkscrew, "corkscrew"},
    {"s_bend",
     "S-bend",
     "Two banked turns, one to each side, without a straight between them. It ends in the same direction.",
     true,
     element_rows::kSBend,
     "s_bend",
     {},
     true},
    {"overbanked_turn", "Overbanked",
     "Overbanked turn: it rises and falls while it turns, banked beyond the vertical at the top. It starts and ends "
     "level.",
     true, element_rows::kOverbankedTurn, "overbanked_turn", "Overbank"},
    {"bunny_hops", "Bunny hops", "Low hills in a row, each with airtime: parabolas between valleys.", false,
     element_rows::kBunnyHops, "bunny_hops"},
    {"zero_g_roll", "Zero-g roll", "A hill over whose crest riders float while they are rolled by 360 degrees.", true,
     element_rows::kZeroGRoll, "zero_g_roll"},
    {"immelmann",
     "Immelmann",
     "Half a loop upwards, then half a roll on which riders float. It ends upright in the opposite direction, higher.",
     true,
     element_rows::kImmelmann,
     "immelmann",
     {},
     true},
    {"dive_loop", "Dive loop",
     "Half a roll on which riders float, then half a loop downwards. It ends upright in the opposite direction, lower.",
     true, element_rows::kDiveLoop, "dive_loop"},
    {"cobra_roll", "Cobra roll",
     "Two inversions: up a half loop, twisted down into a valley across the entry, and the same mirrored. It ends in "
     "the opposite direction, shifted sideways.",
     true, element_rows::kCobraRoll, "cobra_roll"},
    {"brake_run", "Brake run", "Level brakes, then a station: the end of a ride. A sloping end is levelled first.",
     false, element_rows::kBrakeRun, "brake_run"},
    {"force_hill", "Float hill", "A hill over which riders float for some seconds, between bends of constant g.", false,
     element_rows::kForceHill, "forces"},
    {"force_valley", "Valley", "A bend of constant g up or down to a slope: a valley, a pull-up or a crest.", false,
     element_rows::kForceValley, "forces"},
    {"force_turn", "Turn", "A level turn at constant g, banked so that riders feel no lateral g.", true,
     element_rows::kForceTurn, "forces"},
    {"force_roll", "Float roll", "A hill over which riders float while they are rolled by 360 degrees.", true,
     element_rows::kForceRoll, "forces"},
    {"force_heartline", "Heartline", "A roll by 360 degrees about the riders' straight path.", true,
     element_rows::kForceHeartline, "forces"},
    {"force_loop", "Force loop", "A loop at constant g: a teardrop, tighter towards the top. It ends level.", true,
     element_rows::kForceLoop, "forces"},
    {"force_brakes", "Brakes", "Straight brakes, as long as the train needs to slow down.", false,
     element_rows::kForceBrakes, "forces"},
};
static_assert(std::size(kElements) == 1 + static_cast<std::size_t>(ElementKind::force_brakes));
constexpr std::span<const ElementRow> rows_of(ElementKind) { return kElements; }
// Elements with a fixed shape; and those that are placed as force sections (sim/plan/force_elements.h).
constexpr std::span<const ElementRow> elements() {
  return rows_of(ElementKind{}).first(static_cast<std::size_t>(ElementKind::force_hill));
}
constexpr std::span<const ElementRow> force_elements() { return rows_of(ElementKind{}).subspan(elements().size()); }

// Returns the value of the parameter "equipment" for a kind; 0 is none.
constexpr double equipment_choice(EquipmentKind kind) { return 1 + static_cast<double>(kind); }

}  // namespace coaster::world
