// The components of a document: plain structs. To add one, add the struct and its fields (world/component_fields.h),
// and list it at the end of this file.
#pragma once

#include <cstdint>
#include <string>

#include <glm/glm.hpp>

#include "world/component_fields.h"
#include "world/element.h"
#include "world/entity.h"
#include "world/force_program.h"
#include "world/paint.h"
#include "world/registry.h"

namespace coaster::world {

// Limits of a document. Files beyond them are rejected; edits are clamped with a notice.
inline constexpr float kMaxCoordinate = 100'000.0f;  // m, of positions
inline constexpr float kMinHandle = 0.01f;           // m
inline constexpr float kMaxHandle = 10'000.0f;       // m
inline constexpr std::size_t kMaxNameBytes = 200;    // of a track's name and a section's title
inline constexpr int kMaxTurns = 16;                 // whole turns of roll within a segment
inline constexpr float kMaxSpin = 20.0f;             // rad/m, of a knot
inline constexpr double kMaxSpeed = 150.0;           // m/s, of the start speed
inline constexpr std::size_t kMaxKnots = 1'000'000;
inline constexpr std::size_t kMaxCarts = 10'000;
inline constexpr int kMaxCars = 32;                              // of a train
inline constexpr float kMinSpacing = 1.0f, kMaxSpacing = 20.0f;  // m between the centres of neighbouring cars
inline constexpr float kMaxAcceleration = 60.0f;                 // m/s^2, of lifts, launches and brakes
inline constexpr float kMaxRolling = 1.0f, kMaxDrag = 0.1f;      // of resistance; 1, 1/m
inline constexpr double kMaxHeartline = 5.0;                     // m above the rails
inline constexpr float kMinAcceleration = 0.1f;                  // m/s^2
inline constexpr float kMaxDwell = 600.0f;                       // s, of stations

// smooth: equal handle lengths (C1). aligned: a common tangent line (G1). automatic: direction and lengths follow from
// the neighbours (as Catmull-Rom: along the chord between them, a third of each side's chord).
enum class JointKind : std::uint8_t { smooth, aligned, automatic };
inline constexpr base::NameRow kJointKinds[] = {
    {"smooth", "Smooth (C1)", "Equal handle lengths, so equal first derivatives."},
    {"aligned", "Aligned (G1)", "One tangent line, independent handle lengths."},
    {"automatic", "Automatic", "Direction and lengths from the neighbouring knots (Catmull-Rom)."}};
constexpr std::span<const base::NameRow> rows_of(JointKind) { return kJointKinds; }

// automatic: from the twists of the segments on both sides (sim/shape/roll.h), computed again when one of them is
// edited by roll, turns, insertion or removal; a move keeps it. set: only by the user.
enum class SpinKind : std::uint8_t { automatic, set };
inline constexpr base::NameRow kSpinKinds[] = {
    {"automatic", "Automatic", "Follows the roll of the neighbouring knots without overshoot."},
    {"set", "Set", "Stays as it was set."}};
constexpr std::span<const base::NameRow> rows_of(SpinKind) { return kSpinKinds; }

// A point on the track. Knots own the geometry, so every joint has a common tangent line (G1), and the roll rate, so
// that it is continuous over every joint.
struct Knot {
  glm::vec3 position{0};       // m, |coordinate| <= kMaxCoordinate
  glm::vec3 tangent{1, 0, 0};  // unit, direction of travel
  glm::vec3 up{0, 1, 0};       // unit, perpendicular to tangent: direction of the riders' heads
  float in_length = 5;         // m, from the knot back to the handle before it; kMinHandle..kMaxHandle
  float out_length = 5;        // m, to the handle after it
  JointKind joint = JointKind::smooth;
  float spin = 0;  // rad/m, rate of `up` about the tangent against the rotation-minimising frame, positive to the
                   // rider's right; within +-kMaxSpin
  SpinKind spin_kind = SpinKind::automatic;
  static constexpr void fields(auto visit) {
    visit(Field{"position", 0, kMaxCoordinate}, &Knot::position);
    visit(Field{"tangent"}, &Knot::tangent);
    visit(Field{"up"}, &Knot::up);
    visit(Field{"in", kMinHandle, kMaxHandle}, &Knot::in_length);
    visit(Field{"out", kMinHandle, kMaxHandle}, &Knot::out_length);
    visit(Field{"joint"}, &Knot::joint);
    visit(Field{"spin", -kMaxSpin, kMaxSpin, FilePresence::unusual, 1}, &Knot::spin);
    visit(Field{"spin_kind", 0, 0, FilePresence::unusual, 1}, &Knot::spin_kind);
  }
  friend bool operator==(const Knot&, const Knot&) = default;
};

// A cubic from one knot to the next; its control points follow from the knots (world/document.h: cubic_of).
struct Segment {
  Entity from, to;
  std::int32_t turns = 0;  // whole turns about the tangent added to the smallest twist between the knots' `up`
  Entity section;
  // Not the knots and the section: they follow from the order of travel.
  static constexpr void fields(auto visit) { visit(Field{"turns", -kMaxTurns, kMaxTurns}, &Segment::turns); }
  friend bool operator==(const Segment&, const Segment&) = default;
};

// The plan of a section. A free one was shaped by hand.
enum class SectionKind : std::uint8_t { free, element, complete, force };
inline constexpr base::NameRow kSectionKinds[] = {
    {"free", "Hand-shaped", "Shaped knot by knot."},
    {"element", "Element", "Planned as an element of the palette."},
    {"complete", "Closing section", "Planned to close a circuit, and again when track before it moves."},
    {"force", "Forces", "Planned from what riders should feel, and again when the train's speed changes."}};
constexpr std::span<const base::NameRow> rows_of(SectionKind) { return kSectionKinds; }

inline constexpr double kMostTurned_deg = 720, kWidestTurn = 10'000, kLongestStraight = 1'000;  // deg, m, m
inline constexpr double kHighestWay = 200'000, kFastestPlanned = 10'000;                        // m, m/s

// A closing section as plain data, from which a section that completes a circuit is planned again: straight, turn,
// straight, turn, straight in plan, with the heights and the speed of the plan.
struct ClosingPlan {
  double first = 0, second = 0;  // deg, of the two turns; positive to the right
  double radius = 1;             // m, of both
  double before = 0, after = 0;  // m, of the straights before the first and after the second turn
  bool level = false;            // it has a level part; false: one constant slope
  double height = 0;             // m, of the level part; 0 without one
  bool tight = false;            // with the smaller radii of crests and valleys
  double speed = 10;             // m/s, at the start
  bool coasts = true;            // the speed follows from the energy; false: it is constant
  static constexpr void fields(auto visit) {
    visit(Field{"first", -kMostTurned_deg, kMostTurned_deg}, &ClosingPlan::first);
    visit(Field{"second", -kMostTurned_deg, kMostTurned_deg}, &ClosingPlan::second);
    visit(Field{"radius", 1, kWidestTurn}, &ClosingPlan::radius);
    visit(Field{"before", 0, kLongestStraight}, &ClosingPlan::before);
    visit(Field{"after", 0, kLongestStraight}, &ClosingPlan::after);
    visit(Field{"level"}, &ClosingPlan::level);
    visit(Field{"height", -kHighestWay, kHighestWay}, &ClosingPlan::height);
    visit(Field{"tight"}, &ClosingPlan::tight);
    visit(Field{"speed", 0, kFastestPlanned}, &ClosingPlan::speed);
    visit(Field{"coasts"}, &ClosingPlan::coasts);
  }
  friend bool operator==(const ClosingPlan&, const ClosingPlan&) = default;
};

// A run of consecutive segments that the builder treats as one part of the ride. Unless it is free, its knots are as
// planned, or moved as a whole.
// What is done to the land where a section runs below it.
enum class Earthwork : std::uint8_t { automatic, cut, tunnel, none };
inline constexpr base::NameRow kEarthworks[] = {
    {"automatic", "Automatic", "A tunnel under much earth, else an open cut."},
    {"cut", "Open cut", "The land is cut open, however deep."},
    {"tunnel", "Tunnel", "A tunnel wherever earth covers the train."},
    {"none", "None", "The land stays as it is."}};
constexpr std::span<const base::NameRow> rows_of(Earthwork) { return kEarthworks; }

struct Section {
  std::string title;  // UTF-8, at most kMaxNameBytes; empty: the kind is shown
  SectionKind kind = SectionKind::free;
  Element element = {};      // element and parameters, if it was planned as one; else the default
  ClosingPlan closing = {};  // if it completes a circuit; else the default
  ForceProgram force = {};   // if it is a force section; else the default
  Paint paint = {};          // where it differs from the track's
  Earthwork earthwork = Earthwork::automatic;
  // Not the plan: files and hashes use the names of kind and parameters.
  static constexpr void fields(auto visit) {
    visit(Field{"title"}, &Section::title);
    visit(Field{"", 0, 0, FilePresence::unusual, 1}, &Section::paint);
    visit(Field{"earthwork", 0, 0, FilePresence::unusual, 2}, &Section::earthwork);
  }
  std::size_t list_bytes() const { return force.list_bytes(); }
  friend bool operator==(const Section&, const Section&) = default;
};

inline constexpr float kCarLength = 2.2f;  // m
inline constexpr float kCarMass = 500.0f;  // kg: the car mass for which drag is given
inline constexpr float kMinCarLength = 0.5f, kMaxCarLength = 20.0f, kMinCarMass = 1.0f, kMaxCarMass = 100'000.0f;

// The design of a train: the start position of its first car, and its number of cars. All cars have the same mass, so
// without losses the motion depends only on positions; drag slows heavy cars less.
struct Train {
  Entity segment;
  double fraction = 0;        // of the segment's arc length, [0,1)
  std::int32_t cars = 1;      // 1..kMaxCars
  float spacing = 3.0f;       // m of rail between the centres of neighbouring cars
  float length = kCarLength;  // m of a car's body
  float mass = kCarMass;      // kg of a car with its riders
  // Length for drawing and collisions, limited so that cars of one train do not overlap, m.
  float body() const { return length < spacing ? length : spacing; }
  // Length of rail from the first car's centre to the last one's, m.
  double behind() const { return (cars - 1) * double{spacing}; }
  static constexpr void fields(auto visit) {
    visit(Field{"segment"}, &Train::segment);
    visit(Field{"fraction", 0, 1}, &Train::fraction);
    visit(Field{"cars", 1, kMaxCars, FilePresence::unusual, 1}, &Train::cars);
    visit(Field{"spacing", kMinSpacing, kMaxSpacing, FilePresence::unusual, 1}, &Train::spacing);
    visit(Field{"length", kMinCarLength, kMaxCarLength, FilePresence::unusual, 2}, &Train::length);
    visit(Field{"mass", kMinCarMass, kMaxCarMass, FilePresence::unusual, 2}, &Train::mass);
  }
  friend bool operator==(const Train&, const Train&) = default;
};

// Names: world/equipment_rows.h.
// station: stops a train at its end, or where it can bring a short one to its speed; waits `seconds`, and dispatches it
//          at up to `speed`.
// lift:    a chain that pulls up to `speed`, prevents rollback, and does not slow faster trains.
// launch:  accelerates with `acceleration` until `speed` is reached.
// brake:   decelerates with `acceleration`, from above speed + hysteresis until below speed - hysteresis.
// block:   a brake that stops a train at its end until the section after it is free.
enum class EquipmentKind : std::uint8_t { station, lift, launch, brake, block };

// The effect of a segment's rails on trains. A segment without this component is plain track.
struct Equipment {
  EquipmentKind kind = EquipmentKind::lift;
  float speed = 4;          // m/s, 0..kMaxSpeed
  float acceleration = 3;   // m/s^2, above 0, at most kMaxAcceleration
  float hysteresis = 0.5f;  // m/s, brakes and blocks
  float seconds = 5;        // s, stations
  static constexpr void fields(auto visit) {
    visit(Field{"equipment"}, &Equipment::kind);
    visit(Field{"speed", 0, kMaxSpeed, FilePresence::written}, &Equipment::speed);
    visit(Field{"acceleration", kMinAcceleration, kMaxAcceleration, FilePresence::written}, &Equipment::acceleration);
    visit(Field{"hysteresis", 0, kMaxSpeed, FilePresence::unusual}, &Equipment::hysteresis);
    visit(Field{"seconds", 0, kMaxDwell, FilePresence::unusual}, &Equipment::seconds);
  }
  friend bool operator==(const Equipment&, const Equipment&) = default;
};

// Resistance to motion: s'' = ... - sign(v) (rolling g + drag v^2).
struct Losses {
  float rolling = 0;  // coefficient of rolling friction; steel coasters 0.02..0.03
  float drag = 0;     // 1/m; about 2e-5
  static constexpr void fields(auto visit) {
    visit(Field{"rolling", 0, kMaxRolling, FilePresence::unusual, 1}, &Losses::rolling);
    visit(Field{"drag", 0, kMaxDrag, FilePresence::unusual, 1}, &Losses::drag);
  }
  friend bool operator==(const Losses&, const Losses&) = default;
};

// Unknown members of a file's object, kept for saving: the text of a JSON object.
struct UnknownMembers {
  std::string json;
  static constexpr void fields(auto visit) { visit(Field{}, &UnknownMembers::json); }
  friend bool operator==(const UnknownMembers&, const UnknownMembers&) = default;
};

// Components that a segment may have: files store their fields among the segment's, copies of the segment copy them.
using Fittings = ComponentList<Equipment>;
using Entities = RegistryOf<ComponentList<EntityName, Knot, Segment, Train, Section, UnknownMembers>, Fittings>;

}  // namespace coaster::world
