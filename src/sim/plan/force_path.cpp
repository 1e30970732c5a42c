#include "sim/plan/force_path.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "base/text.h"
#include "curve/frames.h"
#include "sim/ride/equipment.h"
#include "sim/ride/train.h"

namespace coaster::sim {
namespace {

using world::ForceChannel;

using ChannelPiece = std::array<glm::dvec2, 4>;

double value_of(const ChannelPiece& p, int axis, double u) {
  const double rest = 1 - u;
  return rest * rest * (rest * p[0][axis] + 3 * u * p[1][axis]) + u * u * (3 * rest * p[2][axis] + u * p[3][axis]);
}
// Returns a third of the derivative by u.
double rate_of(const ChannelPiece& p, int axis, double u) {
  const double rest = 1 - u;
  return rest * rest * (p[1][axis] - p[0][axis]) + 2 * rest * u * (p[2][axis] - p[1][axis]) +
         u * u * (p[3][axis] - p[2][axis]);
}

// Returns the parameter at which the piece's x, which ascends, has that value: Newton within a bracket.
double parameter_at(const ChannelPiece& p, double x) {
  const double gap = p[3].x - p[0].x;
  double low = 0, high = 1, u = std::clamp((x - p[0].x) / gap, 0.0, 1.0);
  for (int i = 0; i < 60; ++i) {
    const double off = value_of(p, 0, u) - x, rate = 3 * rate_of(p, 0, u);
    if (std::abs(off) <= 1e-13 * gap) break;
    (off > 0 ? high : low) = u;
    const double next = rate > 0 ? u - off / rate : low;
    u = next > low && next < high ? next : 0.5 * (low + high);
  }
  return u;
}

}  // namespace

ForceCurve::ForceCurve(const world::ForceProgram& program, ForceChannel channel)
    : before_(world::channel_of(program.of, channel).usual), after_(before_) {
  const std::vector<world::ForceKey> keys = world::shaping_keys(program, channel);
  if (!keys.empty()) before_ = keys.front().value, after_ = keys.back().value;
  for (std::size_t i = 1; i < keys.size(); ++i) pieces_.push_back(world::curve_between(keys[i - 1], keys[i]));
}

const ForceCurve::ChannelPiece* ForceCurve::piece_at(double x) const {
  auto piece = std::ranges::upper_bound(pieces_, x, {}, [](const ChannelPiece& p) { return p[3].x; });
  if (piece == pieces_.end() && !pieces_.empty() && x == pieces_.back()[3].x) --piece;  // the slope of its end
  return piece == pieces_.end() || x < (*piece)[0].x ? nullptr : &*piece;
}

ForceCurve::Value ForceCurve::at(double x) const {
  const ChannelPiece* const piece = piece_at(x);
  if (piece == nullptr) return {pieces_.empty() || x > pieces_.back()[3].x ? after_ : before_, 0};
  const double u = parameter_at(*piece, x);
  return {value_of(*piece, 1, u), rate_of(*piece, 1, u) / rate_of(*piece, 0, u)};
}

double ForceCurve::bend_at(double x) const {
  const ChannelPiece* const piece = piece_at(x);
  if (piece == nullptr) return 0;
  const ChannelPiece& p = *piece;
  const double u = parameter_at(p, x), rate = rate_of(p, 0, u);
  // A sixth of the second derivatives by u; those by u of the first are thirds.
  const auto second = [&](int axis) {
    return (1 - u) * (p[0][axis] - 2 * p[1][axis] + p[2][axis]) + u * (p[1][axis] - 2 * p[2][axis] + p[3][axis]);
  };
  return 2.0 / 3 * (second(1) * rate - rate_of(p, 1, u) * second(0)) / (rate * rate * rate);
}

void insert_on_curve(world::ForceProgram& program, ForceChannel channel, double at) {
  const ForceCurve::Value there = ForceCurve(program, channel).at(at);
  std::vector<world::ForceKey> keys = world::shaping_keys(program, channel);
  const auto next = std::ranges::upper_bound(keys, at, {}, &world::ForceKey::at);
  world::ForceKey key{at, there.value, there.slope};
  if (next != keys.begin() && next != keys.end()) {
    const ChannelPiece p = world::curve_between(next[-1], *next);
    const double u = parameter_at(p, at);
    const double middle = std::lerp(p[1].x, p[2].x, u);
    next[-1].after = u * (p[1].x - p[0].x), next->before = (1 - u) * (p[3].x - p[2].x);
    key.before = at - std::lerp(std::lerp(p[0].x, p[1].x, u), middle, u);
    key.after = std::lerp(middle, std::lerp(p[2].x, p[3].x, u), u) - at;
  }
  keys.insert(next, key);
  program.keys(channel) = std::move(keys);
}

namespace {

using glm::dvec3;
using world::ForceChannel, world::ForceDomain;

ForceState moved(const ForceState& s, const ForceState& rate, double by) {
  return {s.position + by * rate.position,
          s.tangent + by * rate.tangent,
          s.up + by * rate.up,
          s.square + by * rate.square,
          s.length + by * rate.length,
          s.time + by * rate.time,
          s.braking};
}

}  // namespace

ForceLaw::ForceLaw(const ForceTask& task)
    : task_(task),
      curves_{ForceCurve(task.program, ForceChannel::vertical), ForceCurve(task.program, ForceChannel::lateral),
              ForceCurve(task.program, ForceChannel::roll)},
      of_curvature_(task.program.of == world::ForceQuantity::curvature),
      needs_speed_(world::needs_speed(task.program)) {
  for (const ForceChannel channel : {ForceChannel::vertical, ForceChannel::lateral, ForceChannel::roll})
    if (task.added) added_.emplace_back(*task.added, channel);
  set_ramp();
}

ForceState ForceLaw::start() const {
  const double speed = task_.program.speed;
  ForceState start{task_.end.position, task_.end.forward, task_.end.up, speed * speed};
  settle(start, start);
  return start;
}

std::vector<double> ForceLaw::breaks() const {
  const double length = task_.length();
  std::vector<double> places{length};
  if (ramp_ > 0 && ramp_ < length) places.push_back(ramp_);
  const auto add = [&](const world::ForceProgram& program) {
    for (const auto& keys : program.channels)
      for (const world::ForceKey& key : keys)
        if (key.at > 0 && key.at < length) places.push_back(key.at);
  };
  add(task_.program);
  if (task_.added) add(*task_.added);
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

double ForceLaw::metres_per_unit(const ForceState& s) const {
  return task_.program.over == ForceDomain::distance ? 1.0 : std::sqrt(std::max(s.square, 1e-6));
}

double ForceLaw::along(const ForceState& s) const {
  const double g = world::kGravity, square = std::max(s.square, 1e-6);
  const double free = -g * s.tangent.y - (g * task_.losses.rolling + task_.losses.drag * square);
  return task_.equipment ? free + drive(s, free) : free;
}

// Returns what the equipment adds to the acceleration `free` of a train whose first car is there: what it does on a
// ride (drive_of), but brakes keep the speed of trains that are as slow as a plan may be.
double ForceLaw::drive(const ForceState& s, double free) const {
  const double speed = std::sqrt(std::max(s.square, 0.0));
  if (s.braking && speed <= world::kSlowestForce) return std::max(-free, 0.0);
  const int on = std::min(task_.cars, 1 + static_cast<int>(s.length / task_.spacing));
  const EquipmentSpan span{.equipment = *task_.equipment};
  const Contacts contacts{.on = {{&span, static_cast<double>(on) / task_.cars, false}}};
  ControlState control{.braking = s.braking};
  const TrainPlace train{.front = s.length, .cars = task_.cars, .spacing = task_.spacing};
  const Drive drive = drive_of(contacts, train, {s.length, speed, [free] { return free; }}, true, control);
  return drive.net ? drive.acceleration - free : drive.acceleration;
}

void ForceLaw::settle(const ForceState& before, ForceState& next) const {
  using world::EquipmentKind;
  if (!task_.equipment) return;
  const world::Equipment& e = *task_.equipment;
  const auto square = [](double speed) { return speed * speed; };
  const double to = square(e.speed);
  if (e.kind == EquipmentKind::lift || e.kind == EquipmentKind::launch)
    if ((before.square < to && next.square > to) || (before.square > to && next.square < to)) next.square = to;
  if (e.kind != EquipmentKind::brake && e.kind != EquipmentKind::block) return;
  const double least = world::kSlowestForce, end = e.speed - e.hysteresis;
  if (next.braking && next.square <= square(std::max(end, least)))
    next.square = square(std::max(end, least)), next.braking = end < least;
  if (next.square > square(e.speed + e.hysteresis)) next.braking = true;
}

ForceLaw::Asked ForceLaw::asked(ForceChannel channel, double x) const {
  const auto c = static_cast<std::size_t>(channel);
  const bool angle = of_curvature_ && channel == ForceChannel::roll;
  const ForceCurve::Value keys = curves_[c].at(x);
  Asked asked{keys.value, keys.slope, angle ? curves_[c].bend_at(x) : 0.0};
  if (angle && x > task_.program.length) {  // held farther away: the roll goes on
    asked.slope = curves_[c].at(task_.program.length).slope;
    asked.value += asked.slope * (x - task_.program.length);
  }
  if (x >= ramp_) return asked;
  const double share = x / ramp_, rest = 1 - share;
  asked.value += missing_[c] * (1 - smooth_step(share));
  asked.slope -= missing_[c] * 6 * share * rest / ramp_;
  if (!angle) return asked;
  asked.value += missing_slope_ * x * rest * rest;
  asked.slope += missing_slope_ * rest * (1 - 3 * share);
  asked.bend += (6 * missing_[c] * (2 * share - 1) / ramp_ + missing_slope_ * (6 * share - 4)) / ramp_;
  return asked;
}

FeltG felt_on(const ForceState& s, const ForceRates& track, double d) {
  const double g = world::kGravity, square = std::max(s.square, 1e-6);
  const dvec3 left = glm::cross(s.up, s.tangent);
  const double to_up = glm::dot(track.curvature, s.up), to_left = glm::dot(track.curvature, left);
  return {
      square / g * (to_up - d * (to_up * to_up + track.spin * track.spin)) + s.up.y,
      square / g * (to_left - d * (to_left * to_up + track.spin_slope)) - track.along / g * d * track.spin + left.y};
}

ProgramValues ForceLaw::wanted(double x) const {
  const Asked up = asked(ForceChannel::vertical, x), side = asked(ForceChannel::lateral, x),
              roll = asked(ForceChannel::roll, x);
  ProgramValues wanted{
      {up.value, up.slope}, {side.value, side.slope}, {roll.value, roll.slope}, {up.value, side.value, roll.value}};
  if (of_curvature_) wanted.roll = {roll.slope, roll.bend};
  for (std::size_t c = 0; c < added_.size(); ++c) {
    const ForceCurve::Value by = added_[c].at(x);
    ForceCurve::Value& to = c == 0 ? wanted.up : c == 1 ? wanted.side : wanted.roll;
    to.value += by.value, to.slope += by.slope, wanted.added[c] = by.value;
  }
  return wanted;
}

// Inverts felt g = (s'' h' + s'^2 h'')/g + up (sim/shape/rail_tables.h) for the curvature towards up and left.
ForceRates ForceLaw::rates_for(const ProgramValues& wanted, const ForceState& s) const {
  const double g = world::kGravity, d = task_.riders, square = std::max(s.square, 1e-6);
  const dvec3 left = glm::cross(s.up, s.tangent);
  ForceRates r;
  r.along = along(s);
  r.spin = base::radians(wanted.roll.value), r.spin_slope = base::radians(wanted.roll.slope);
  if (task_.program.over == ForceDomain::time) {
    const double speed = std::sqrt(square);
    r.spin /= speed;
    r.spin_slope = (r.spin_slope / speed - r.spin * r.along / speed) / speed;
  }
  if (of_curvature_) {
    r.curvature = wanted.up.value * s.up + wanted.side.value * left;
    return r;
  }
  const double up = (wanted.up.value - s.up.y) * g / square + d * r.spin * r.spin, root = 1 - 4 * d * up;
  r.folded = !(root > 0);
  const double to_up = 2 * up / (1 + std::sqrt(std::max(root, 0.0)));
  const double to_left =
      ((wanted.side.value - left.y) * g / square + d * (r.along * r.spin / square + r.spin_slope)) / (1 - d * to_up);
  r.curvature = to_up * s.up + to_left * left;
  return r;
}

std::array<double, 3> ForceLaw::has(const ForceState& s, const ForceRates& track) const {
  const double metres = metres_per_unit(s), roll = base::degrees(track.spin) * metres;
  if (of_curvature_)
    return {glm::dot(track.curvature, s.up), glm::dot(track.curvature, glm::cross(s.up, s.tangent)), roll};
  const FeltG felt = felt_on(s, track, task_.riders);
  return {felt.up, felt.side, roll};
}

ForceState ForceLaw::step(double x, const ForceState& s, double by) const {
  const auto slope = [&](double at, const ForceState& here) {
    const ForceRates r = rates(at, here);
    const double metres = metres_per_unit(here);
    const dvec3 left = glm::cross(here.up, here.tangent);
    return ForceState{metres * here.tangent,
                      metres * r.curvature,
                      metres * (-glm::dot(r.curvature, here.up) * here.tangent - r.spin * left),
                      metres * 2 * r.along,
                      metres,
                      metres / std::sqrt(std::max(here.square, 1e-6))};
  };
  const ForceState k1 = slope(x, s), k2 = slope(x + by / 2, moved(s, k1, by / 2)),
                   k3 = slope(x + by / 2, moved(s, k2, by / 2)), k4 = slope(x + by, moved(s, k3, by));
  ForceState next = moved(moved(moved(moved(s, k1, by / 6), k2, by / 3), k3, by / 3), k4, by / 6);
  next.tangent = glm::normalize(next.tangent);
  next.up = curve::perpendicular(next.tangent, next.up);
  settle(s, next);
  return next;
}

// The ramp takes kPerG for each g and a tenth of a second for each 40 degrees per second, at least kShortest; of
// curvature, at kCurvatureSpeed, and more where the angle of roll has far to go. Riders d above the curve swing aside
// while a roll rate w (rad/s) fades within t, with 1.5 d w / t at most. The curvature that balances this has to rise
// and fall slowly enough for spans of some 1 m to follow, so t^2 is at least kPerSwing d w / g.
void ForceLaw::set_ramp() {
  constexpr double kShortest = 0.15, kPerG = 0.12, kPerDegree = 0.0025;  // s
  constexpr double kPerSwing = 0.8;
  constexpr double kMetresPerDegree = 0.4;  // of an angle
  constexpr double kSame = 1e-9;
  const bool by_time = task_.program.over == ForceDomain::time;
  const TrackEnd& end = task_.end;
  const ForceState s = start();
  const double square = std::max(s.square, 1e-6), speed = std::sqrt(square);
  const double along = rates(0, s).along, spin = end.spin;
  const double slope = base::radians(of_curvature_ ? curves_[2].bend_at(0) : curves_[2].at(0).slope);
  const double spin_slope = by_time ? (slope / speed - spin * along / speed) / speed : slope;
  found_ = has(s, {end.curvature, spin, spin_slope, along});
  if (of_curvature_) missing_slope_ = std::exchange(found_[2], 0.0) - curves_[2].at(0).slope;
  for (std::size_t c = 0; c < found_.size(); ++c) missing_[c] = found_[c] - curves_[c].at(0).value;
  const double v = of_curvature_ ? world::kCurvatureSpeed : speed, one = of_curvature_ ? kCurvaturePerG : 1.0;
  const double most = std::max(std::abs(missing_[0]), std::abs(missing_[1])) / one;
  const double unit = !by_time ? v : of_curvature_ ? v / speed : 1.0;  // m or s in a second at the speed v
  const double turn = (by_time ? 1 / unit : unit) * std::abs(of_curvature_ ? missing_slope_ : missing_[2]),
               angle = of_curvature_ ? std::abs(missing_[2]) : 0.0;
  if (std::max({most, turn, angle}) <= kSame) return;
  const double riders = of_curvature_ ? 0.0 : std::abs(task_.riders),
               swing = std::sqrt(kPerSwing * riders * base::radians(turn) / world::kGravity);
  const double seconds = std::max({kShortest, kPerG * most, kPerDegree * turn, swing});
  ramp_ = std::min(std::max(seconds * unit, kMetresPerDegree * angle / (by_time ? speed : 1.0)), task_.length());
}

namespace {

constexpr double kForceStep = 0.25;    // m
constexpr double kLongestPath = 5000;  // m, longest section over time

class Integration {
 public:
  explicit Integration(const ForceTask& task)
      : task_(task), law_(task), above_(!task.digs && rails_height_of(law_.start()) >= 0) {}

  ForcePath run() {
    ForcePath path;
    path.ramp = law_.ramp();
    add(path, law_.start(), 0);
    follow_law(law_, kForceStep, 0, law_.start(), [&](double x, const ForceState& state) {
      path.stopped = stop(path, x, state);
      if (path.stopped.empty()) add(path, state, x);
      return path.stopped.empty();
    });
    return closed(std::move(path));
  }

 private:
  double rails_height_of(const ForceState& s) const { return s.position.y + task_.rails * s.up.y; }

  void add(ForcePath& path, const ForceState& s, double x) const {
    const ProgramValues wanted = law_.wanted(x);
    const ForceRates r = law_.rates_for(wanted, s);
    FeltG felt{wanted.up.value, wanted.side.value};
    if (task_.program.of == world::ForceQuantity::curvature) felt = felt_on(s, r, task_.riders);
    path.curve.points.push_back({s.length, s.position, s.tangent, r.curvature, s.up, r.spin});
    path.points.push_back({x, s.time, s.square, r.along, felt.up, felt.side, wanted.asked, wanted.added});
  }

  static ForcePath closed(ForcePath path) {
    path.curve.breaks = {0, path.curve.points.size() - 1};
    return path;
  }

  // Returns why the path cannot continue to that point; empty if it can.
  std::string stop(const ForcePath& path, double x, const ForceState& s) const {
    if (law_.too_slow(s)) return fmt::format("the train falls below {} m/s", world::kSlowestForce);
    const ForceRates r = law_.rates(x, s);
    if (r.folded || !(glm::length(r.curvature) * kTightestForce <= 1))
      return fmt::format("the turn would be tighter than a radius of {} m", kTightestForce);
    if (!(std::abs(r.spin) <= world::kMaxSpin)) return "the roll would be faster than the limit";
    for (int axis = 0; axis < 3; ++axis)
      if (!(std::abs(s.position[axis]) <= world::kMaxCoordinate))
        return fmt::format("the track would leave the world, {} m from its middle",
                           base::to_text(double{world::kMaxCoordinate}));
    if (above_ && rails_height_of(s) < 0) return "the track would run into the ground";
    if (s.length > kLongestPath) return fmt::format("a section is at most {} m long", kLongestPath);
    return own_rails(path, s);
  }

  std::string own_rails(const ForcePath& path, const ForceState& s) const {
    constexpr double kApart = 8;              // m along the track, within which it cannot collide with itself
    constexpr double kMost = 2 * kForceStep;  // m, largest distance of successive points along the rails
    const std::vector<ElementPoint>& points = path.curve.points;
    const dvec3 here = s.position + task_.rails * s.up;
    for (std::size_t i = 0; i < points.size() && points[i].s < s.length - kApart;) {
      const double off = glm::distance(points[i].position + task_.rails * points[i].up, here);
      if (off < kOwnRails) return "the track would run through itself";
      i += 1 + static_cast<std::size_t>((off - kOwnRails) / kMost);
    }
    return {};
  }

  const ForceTask& task_;
  ForceLaw law_;
  bool above_;
};

}  // namespace

ForcePath force_path(const ForceTask& task) { return Integration(task).run(); }

}  // namespace coaster::sim
