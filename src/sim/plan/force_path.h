// What the keys of a force section ask for along it: the curves of its channels, cubic Bézier pieces between the keys,
// curvature and roll that follow from them for a train of a given speed, and the path that these lead along.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "sim/plan/element_shapes.h"
#include "world/force_program.h"
#include "world/motion.h"

namespace coaster::sim {

// One channel of a program as a function of the position.
class ForceCurve {
 public:
  struct Value {
    double value = 0, slope = 0;  // in the channel's unit; the same per metre or second
  };
  ForceCurve(const world::ForceProgram& program, world::ForceChannel channel);
  // Returns the value at x m or s; error below 1e-10 of the largest value. The same bits everywhere.
  Value at(double x) const;
  // Returns the second derivative there.
  double bend_at(double x) const;

 private:
  using ChannelPiece = std::array<glm::dvec2, 4>;
  // Returns the piece that holds x; null before the first and behind the last.
  const ChannelPiece* piece_at(double x) const;

  double before_, after_;  // the values before and after the pieces
  std::vector<ChannelPiece> pieces_;
};

// Adds a key at a position of the section on the channel's curve; the curve keeps its shape (de Casteljau).
void insert_on_curve(world::ForceProgram& program, world::ForceChannel channel, double at);

// Where and how a force section begins, and the train that it is planned for: the mass of its first car.
struct ForceTask {
  TrackEnd end;
  world::ForceProgram program;                     // within its limits (world::broken)
  world::Losses losses;                            // of that train
  double rails = 0, riders = 0;                    // m above the curve
  std::optional<TrackEnd> held = {};               // where it must end
  std::optional<world::Equipment> equipment = {};  // of all of the section
  int cars = 1;                                    // of the train: launches and brakes act on those on the section
  double spacing = 3;                              // m between them
  // What is added to what the keys ask for so that it ends there (force_end_constraint.h), over the length that this
  // takes.
  std::optional<world::ForceProgram> added = {};
  bool digs = false;  // a land is cut or tunnelled where it goes below y = 0; else it may not go there
  double length() const { return added ? added->length : program.length; }  // m or s
  friend bool operator==(const ForceTask&, const ForceTask&) = default;
};

// 1/m of curvature that riders feel as 1 g at world::kCurvatureSpeed.
inline constexpr double kCurvaturePerG = world::kGravity / (world::kCurvatureSpeed * world::kCurvatureSpeed);

// A train on the path, by metres or seconds since the section's start.
struct ForceState {
  glm::dvec3 position{0}, tangent{1, 0, 0}, up{0, 1, 0};  // m, unit, unit
  double square = 0;                                      // m^2/s^2, the speed squared
  double length = 0, time = 0;                            // m, s since the start
  bool braking = false;                                   // by the section's brakes
};

// What a program wants at a position, with the ramp and with what is added.
struct ProgramValues {
  ForceCurve::Value up, side, roll;  // g or 1/m; the rate of roll, deg/m or deg/s, of curvature too
  std::array<double, 3> asked{};     // by channel, in the keys' units, without what is added
  std::array<double, 3> added{};     // by channel: the part of `up`, `side` and `roll` that is added to end as held
};

struct ForceRates {
  glm::dvec3 curvature{0};  // 1/m
  double spin = 0;          // rad/m
  double spin_slope = 0;    // rad/m^2
  double along = 0;         // m/s^2 along the track
  bool folded = false;      // no curvature makes riders at their height feel what is asked for
};

// What riders `riders` m above the curve feel at a position of the track, in g: rates_for() below solves it for the
// curvature.
struct FeltG {
  double up = 1, side = 0;
};
FeltG felt_on(const ForceState& state, const ForceRates& track, double riders);

class ForceLaw {
 public:
  explicit ForceLaw(const ForceTask& task);
  ForceState start() const;
  // Returns over which distance or time (m or s) the start reaches the values of the keys; 0 if it has them already.
  double ramp() const { return ramp_; }
  // Returns by channel what the track's end has. Keys with these values there need no ramp; of curvature, roll has to
  // begin with the spin there, too.
  const std::array<double, 3>& found_at_start() const { return found_; }
  // True if the train is below world::kSlowestForce and its speed shapes the track.
  bool too_slow(const ForceState& state) const {
    return needs_speed_ && !(state.square >= world::kSlowestForce * world::kSlowestForce);
  }
  // Returns where the required curves change their formula: ascending, the section's end last.
  std::vector<double> breaks() const;
  double metres_per_unit(const ForceState& state) const;
  // Returns the acceleration along the track by gravity, losses and the section's equipment, m/s^2. Lifts, launches,
  // brakes and free blocks act as in sim/ride/equipment.h on trains that move, but brakes not below
  // world::kSlowestForce; stations do nothing.
  double along(const ForceState& state) const;
  // After a step: a train that equipment brings to its speed in between is at that speed, and brakes change over.
  void settle(const ForceState& before, ForceState& next) const;
  ProgramValues wanted(double x) const;
  ForceRates rates_for(const ProgramValues& wanted, const ForceState& state) const;
  ForceRates rates(double x, const ForceState& state) const { return rates_for(wanted(x), state); }
  // Returns `up`, `side` and `roll` of what a program wants that has that track.
  std::array<double, 3> has(const ForceState& state, const ForceRates& track) const;
  // Takes a step of classical Runge-Kutta, order 4; the frame stays orthonormal.
  ForceState step(double x, const ForceState& state, double by) const;

 private:
  struct Asked {
    double value, slope, bend;  // bend: of roll of curvature only
  };
  Asked asked(world::ForceChannel channel, double x) const;
  double drive(const ForceState& state, double free) const;
  void set_ramp();

  const ForceTask& task_;
  std::array<ForceCurve, 3> curves_;
  std::vector<ForceCurve> added_;  // by channel, or none
  bool of_curvature_, needs_speed_;
  double ramp_ = 0;
  std::array<double, 3> found_{};
  std::array<double, 3> missing_{};  // by channel: what the track's end has minus the keys there
  double missing_slope_ = 0;         // of roll of curvature: that of the slope
};

// Goes on from a place in steps of at most `step` m that end where the curves change their formula, and calls
// visit(x, state) at the end of each until it returns false. Returns whether it got to the section's end.
template <class Visit>
bool follow_law(const ForceLaw& law, double step, double x, ForceState state, Visit visit) {
  for (const double until : law.breaks())
    while (x < until) {
      const double rest = until - x, wish = step / law.metres_per_unit(state);
      const double by = rest <= wish ? rest : rest < 2 * wish ? rest / 2 : wish;
      state = law.step(x, state, by), x = by == rest ? until : x + by;
      if (!visit(x, state)) return false;
    }
  return true;
}

// A point of the path; arc length, position and frame are those of the curve's point with the same index.
struct ForcePoint {
  double at = 0;                  // m or s: what the keys count in
  double time = 0;                // s since the section's start
  double square = 0;              // m^2/s^2, the speed squared
  double along = 0;               // m/s^2 along the track
  double up = 1, side = 0;        // g that riders feel on it
  std::array<double, 3> keys{};   // by channel: what the keys ask for, as ramped from what the track's end has
  std::array<double, 3> added{};  // by channel: what is added to that so that the section ends as held
  double asked(world::ForceChannel channel) const { return keys[static_cast<std::size_t>(channel)]; }
};

struct ForcePath {
  ElementCurve curve;
  std::vector<ForcePoint> points;
  double ramp = 0;      // m or s, over which the start reaches the values of the keys; 0 if it has them already
  std::string stopped;  // why the path ends before its program does: "the train falls below 3 m/s"; else empty
};

// A turn tighter than this folds rails and cars.
inline constexpr double kTightestForce = 2;  // m, radius
// A path closer than this to its earlier rails collides with itself.
inline constexpr double kOwnRails = 1;  // m

// Integrates by Runge-Kutta 4 in steps of at most 0.25 m that end at each key: position, direction, up, speed, length
// and time. Positions are accurate to a millimetre after 300 m. The same bits everywhere. Takes about a microsecond a
// step.
ForcePath force_path(const ForceTask& task);

}  // namespace coaster::sim
