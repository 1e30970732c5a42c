// The table of kinds. Steel has the numbers that the program had before there were others.
#include "sim/solids/coaster_form.h"

#include <algorithm>
#include <array>

#include "base/check.h"

namespace coaster::sim {
namespace {

using glm::dvec2;

constexpr int kRailSides = 8, kSpineSides = 12;
constexpr double kRail = 0.5 * kGauge;

constexpr Tube rail(double side, double radius = kRailRadius) {
  return {{side * kRail, 0}, radius, kRailSides, kRailSides / 2, Material::rail, {}};
}
constexpr Tube spine(double up, double radius) {
  return {{0, up}, radius, kSpineSides, kSpineSides / 3, Material::spine, {}};
}
// Returns the outline of a rectangle.
constexpr std::array<dvec2, 4> box(dvec2 low, dvec2 high) {
  return {low, dvec2(high.x, low.y), high, dvec2(low.x, high.y)};
}
// Steel: arms from both rails to a round spine below.
constexpr double kSteelSpine = 0.62, kSteelRadius = 0.28;
constexpr Tube kSteelTubes[] = {rail(1), rail(-1), spine(-kSteelSpine, kSteelRadius)};
constexpr ArmForm kSteelArms{0.06, 0.15, {0.06, -kSteelSpine + 0.04}};

// Wood: each rail a stack of planks with a strap of steel on it; ties that carry a walkway with a handrail on both
// sides.
constexpr double kStackInner = 0.42, kStackOuter = 0.76, kWalk = 1.25;
constexpr BeamForm kWoodenBeams[] = {{{kStackInner, -0.36}, {kStackOuter, 0.05}, Material::spine},
                                     {{-kStackOuter, -0.36}, {-kStackInner, 0.05}, Material::spine},
                                     {{kRail - 0.14, 0.05}, {kRail + 0.14, kRailRadius}, Material::rail},
                                     {{-kRail - 0.14, 0.05}, {-kRail + 0.14, kRailRadius}, Material::rail},
                                     {{kWalk - 0.16, -0.36}, {kWalk + 0.16, -0.31}, Material::plank, false},
                                     {{-kWalk - 0.16, -0.36}, {-kWalk + 0.16, -0.31}, Material::plank, false},
                                     {{kWalk + 0.12, 0.62}, {kWalk + 0.20, 0.70}, Material::handrail},
                                     {{-kWalk - 0.20, 0.62}, {-kWalk - 0.12, 0.70}, Material::handrail}};
constexpr auto kSleeper = box({-1.45, -0.54}, {1.45, -0.36}),
               kLeftPost = box({kWalk + 0.125, -0.36}, {kWalk + 0.195, 0.62}),
               kRightPost = box({-kWalk - 0.195, -0.36}, {-kWalk - 0.125, 0.62});
constexpr PlateForm kWoodenTies[] = {{kSleeper, 0.10, Material::timber},
                                     {kLeftPost, 0.035, Material::handrail},
                                     {kRightPost, 0.035, Material::handrail}};

// Inverted: the spine above the rails, and arms around the outside of the train's wheels.
constexpr double kInvertedSpine = 0.90, kInvertedRadius = 0.32;
constexpr Tube kInvertedTubes[] = {rail(1), rail(-1), spine(kInvertedSpine, kInvertedRadius)};
constexpr ArmForm kInvertedArms{0.07, 0.20, {0.10, kInvertedSpine - 0.06}};

// Mine train: thin rails, two tubes below them, and wide ties of timber.
constexpr Tube kMineTubes[] = {rail(1),
                               rail(-1),
                               {{0.42, -0.42}, 0.10, 8, 4, Material::spine, {}},
                               {{-0.42, -0.42}, 0.10, 8, 4, Material::spine, {}}};
constexpr auto kMineTie = box({-1.05, -0.34}, {1.05, -0.14}), kMineCross = box({-0.42, -0.46}, {0.42, -0.38});
constexpr PlateForm kMineTies[] = {{kMineTie, 0.13, Material::timber}, {kMineCross, 0.05, Material::spine}};

// Kiddie: one box beam, and short flat ties.
constexpr BeamForm kKiddieBeams[] = {{{-0.24, -0.62}, {0.24, -0.20}, Material::spine}};
constexpr Tube kKiddieTubes[] = {rail(1), rail(-1)};
constexpr auto kKiddieTie = box({-kRail, -0.26}, {kRail, -0.05});
constexpr PlateForm kKiddieTies[] = {{kKiddieTie, 0.09, Material::tie}};

constexpr CoasterForm kSteel{.tubes = kSteelTubes,
                             .beams = {},
                             .arms = kSteelArms,
                             .plates = {},
                             .tie_spacing = 1.5,
                             .half_tie = 0.045,
                             .hold = -kSteelSpine,
                             .hold_radius = kSteelRadius,
                             .supports = SupportForm::column,
                             .side = 1,
                             .envelope = {1.6, 0.45},
                             .wheels = 0.38,
                             .riders = {1.1, 1.05},
                             .train = {1.5, 0.45},
                             .track = {0.78, -0.3},
                             .platform = 0.22,
                             .walkway = -0.38,
                             .eye = 1.1,
                             .head = 1.5,
                             .hitch = 0.21,
                             .reach = 1.2};

constexpr CoasterForm wooden() {
  CoasterForm form = kSteel;
  form.tubes = {}, form.beams = kWoodenBeams, form.arms = {}, form.plates = kWoodenTies;
  form.tie_spacing = 0.9, form.half_tie = 0.10;
  form.hold = -0.54, form.hold_radius = 0, form.supports = SupportForm::bent;
  form.envelope = {1.75, 0.45}, form.train = {1.7, 0.45}, form.track = {1.45, -0.05};
  form.walkway = {}, form.reach = 1.7;
  return form;
}

constexpr CoasterForm inverted() {
  CoasterForm form = kSteel;
  form.tubes = kInvertedTubes, form.arms = kInvertedArms;
  form.tie_spacing = 1.8, form.half_tie = 0.06;
  form.hold = kInvertedSpine, form.hold_radius = kInvertedRadius, form.side = -1, form.wheels = 0.43;
  form.envelope = {1.7, -1.0}, form.riders = {1.15, -1.55}, form.train = {1.7, -1.0}, form.track = {0.95, 0.4};
  form.platform = -2.35, form.walkway = 0.2, form.eye = -1.05, form.head = -0.85, form.hitch = -0.28, form.reach = 1.4;
  return form;
}

constexpr CoasterForm mine() {
  CoasterForm form = kSteel;
  form.tubes = kMineTubes, form.arms = {}, form.plates = kMineTies;
  form.tie_spacing = 0.8, form.half_tie = 0.13;
  form.hold = -0.46, form.hold_radius = 0, form.supports = SupportForm::bent;
  form.track = {0.95, -0.2}, form.eye = 1.3;
  return form;
}

constexpr CoasterForm kiddie() {
  CoasterForm form = kSteel;
  form.tubes = kKiddieTubes, form.beams = kKiddieBeams, form.arms = {}, form.plates = kKiddieTies;
  form.tie_spacing = 1.0, form.half_tie = 0.09;
  form.hold = -0.41, form.hold_radius = 0.30;
  form.envelope = {1.45, 0.40}, form.riders = {1.0, 0.95}, form.train = {1.35, 0.40}, form.track = {0.75, -0.25};
  form.eye = 1.1, form.head = 1.4;
  return form;
}

constexpr CoasterForm kForms[] = {kSteel, wooden(), inverted(), mine(), kiddie()};

}  // namespace

const CoasterForm& form_of(world::CoasterKind kind) {
  static_assert(std::size(kForms) == base::count_of<world::CoasterKind>(), "each kind has its form");
  COASTER_CHECK(base::has_row(kind), "kinds are rows of the table");
  return kForms[static_cast<std::size_t>(kind)];
}

TrackRoom track_room(const CoasterForm& form) {
  constexpr double kFloor = 0.4, kWall = 0.9;  // m between what trains need and earth
  const ClearanceTube& tube = form.envelope;
  return {.below = std::max(2.0, tube.radius - tube.lift + kFloor),
          .above = tube.radius + std::max(tube.lift, 0.0),
          .beside = tube.radius,
          .tube = tube.radius + kWall,
          .lift = tube.lift};
}

}  // namespace coaster::sim
