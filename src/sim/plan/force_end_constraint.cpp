// Sequential linear least squares: a step goes to the least sum of squares among the additions that, to first order,
// lead to the end. The problem without bounds has the KKT equations  W c = J^T m,  J dx = -h,  with W diagonal.
#include "sim/plan/force_end_constraint.h"

#include <algorithm>
#include <cmath>

#include "base/numerics.h"
#include "base/portable_math.h"
#include "curve/frames.h"
#include "sim/plan/force_end_sensitivities.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

// P(u) by the values and first two derivatives at u = 0 and 1.
class Quintic {
 public:
  Quintic(const TrackEnd& from, const TrackEnd& to, double size)
      : p_{from.position, size * from.forward, 0.5 * size * size * from.curvature} {
    const dvec3 place = to.position - p_[0] - p_[1] - p_[2], rate = size * to.forward - p_[1] - 2.0 * p_[2],
                bend = size * size * to.curvature - 2.0 * p_[2];
    p_[3] = 10.0 * place - 4.0 * rate + 0.5 * bend;
    p_[4] = -15.0 * place + 7.0 * rate - bend;
    p_[5] = 6.0 * place - 3.0 * rate + 0.5 * bend;
  }
  dvec3 at(double u) const { return p_[0] + u * (p_[1] + u * (p_[2] + u * (p_[3] + u * (p_[4] + u * p_[5])))); }
  dvec3 rate(double u) const {
    return p_[1] + u * (2.0 * p_[2] + u * (3.0 * p_[3] + u * (4.0 * p_[4] + u * 5.0 * p_[5])));
  }
  dvec3 second(double u) const { return 2.0 * p_[2] + u * (6.0 * p_[3] + u * (12.0 * p_[4] + u * 20.0 * p_[5])); }

 private:
  std::array<dvec3, 6> p_;
};

// A cubic roll by arc length against the frame of least rotation: angle and spin at both ends.
struct CubicRoll {
  double length, first, last, twist;  // m, rad/m, rad/m, rad
  double square() const { return (3 * twist / length - 2 * first - last) / length; }
  double cube() const { return (first + last - 2 * twist / length) / (length * length); }
  double angle(double s) const { return s * (first + s * (square() + s * cube())); }
  double spin(double s) const { return first + s * (2 * square() + s * 3 * cube()); }
  double slope(double s) const { return 2 * square() + s * 6 * cube(); }
};

// A place of the curve: the train there, what a program that leads along it wants, and where that is on the keys' axis.
struct BridgePoint {
  ForceState state;
  dvec3 curvature{0};
  std::array<double, 3> has{};  // of what a program wants
  double at = 0;                // m or s
};

// Returns places half a metre apart with frames of least rotation; none where the curve has a cusp.
std::vector<BridgePoint> places_of(const Quintic& curve, const TrackEnd& from, double size) {
  constexpr double kStep = 0.5;  // m
  const auto steps = static_cast<std::size_t>(std::ceil(size / kStep)) + 1;
  std::vector<BridgePoint> places;
  for (std::size_t i = 0; i <= steps; ++i) {
    const double u = static_cast<double>(i) / static_cast<double>(steps);
    const dvec3 rate = curve.rate(u);
    const double square = glm::dot(rate, rate);
    if (!(square > 1e-6)) return {};
    BridgePoint here;
    ForceState& state = here.state;
    state.position = curve.at(u), state.tangent = rate / std::sqrt(square);
    here.curvature = curve::across(curve.second(u), state.tangent) / square;
    state.up = curve::perpendicular(state.tangent, i == 0 ? from.up : places.back().state.up);
    if (i > 0) {
      const ForceState& before = places.back().state;
      state.length = before.length + glm::distance(before.position, state.position);
    }
    places.push_back(here);
  }
  return places;
}

// Rolls the frames and rides along; false where the train is too slow.
bool ride(const ForceTask& task, const ForceLaw& law, const CubicRoll& roll, std::vector<BridgePoint>& places) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    ForceState& state = places[i].state;
    const ForceState& before = i > 0 ? places[i - 1].state : state;
    const double s = state.length, step = s - before.length;
    state.square = i > 0 ? before.square + 2 * step * law.along(before) : law.start().square;
    state.braking = i > 0 ? before.braking : law.start().braking;
    law.settle(before, state);
    if (law.too_slow(state)) return false;
    state.time = before.time + step / std::sqrt(std::max(state.square, 1e-6));
    state.up = curve::rotate(state.up, state.tangent, roll.angle(s));
    ForceRates track{places[i].curvature, roll.spin(s), roll.slope(s)};
    track.along = law.along(state);
    places[i].has = law.has(state, track);
    places[i].at = task.program.over == world::ForceDomain::distance ? s : state.time;
  }
  return true;
}

// Returns about how long a curve between the ends is, as an arc of a circle; nothing for none.
std::optional<double> size_between(const TrackEnd& from, const TrackEnd& to) {
  const double chord = glm::distance(from.position, to.position), cos = glm::dot(from.forward, to.forward);
  if (!(chord > 1) || !(cos > -0.9)) return std::nullopt;
  const double half = base::arc_tangent(std::sqrt(std::max(0.0, (1 - cos) / 2)), std::sqrt((1 + cos) / 2));
  return half > 1e-6 ? chord * half / base::sin_cos(half).sin : chord;
}

}  // namespace

std::optional<ForceBridge> force_bridge(const ForceTask& task, std::size_t parts) {
  const TrackEnd& to = *task.held;
  const std::optional<double> size = size_between(task.end, to);
  if (!size) return std::nullopt;
  std::vector<BridgePoint> places = places_of(Quintic(task.end, to, *size), task.end, *size);
  if (places.empty()) return std::nullopt;
  const ForceState& last = places.back().state;
  const double twist = curve::signed_angle(last.up, curve::perpendicular(last.tangent, to.up), last.tangent);
  const ForceLaw law(task);
  if (!ride(task, law, {last.length, task.end.spin, to.spin, twist}, places)) return std::nullopt;
  ForceBridge bridge{places.back().at, {}};
  std::size_t k = 0;
  for (std::size_t i = 0; i <= parts; ++i) {
    const double at = bridge.length * static_cast<double>(i) / static_cast<double>(parts);
    while (k + 2 < places.size() && places[k + 1].at < at) ++k;
    const double share = (at - places[k].at) / (places[k + 1].at - places[k].at);
    const ProgramValues wanted = law.wanted(at);
    const std::array<double, 3> keys{wanted.up.value, wanted.side.value, wanted.roll.value};
    std::array<double, 3>& more = bridge.more.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) more[c] = std::lerp(places[k].has[c], places[k + 1].has[c], share) - keys[c];
  }
  return bridge;
}

namespace {

using End = EndMiss;  // of the conditions: place (3), direction (2), bend (2), roll, spin
constexpr std::size_t kEnd = End{}.size();

constexpr double kNodeGap = 5;  // m between keys of what is added, about
constexpr std::size_t kFewestNodes = 6, kMostNodes = 24;
constexpr double kCoarse = 1, kFine = 0.25;  // m, steps on the way to the end and of the path itself (force_path.cpp)
constexpr double kMostStep = 5;              // g, changes by more in one step lead nowhere

double size_of(const End& end) {
  double square = 0;
  for (const double value : end) square += value * value;
  return std::sqrt(square);
}

// Returns the rotation from one frame to the other as axis times angle, rad; nothing near half a turn, where the axis
// is any. Unlike the products of single axes it is 0 for no other frame.
std::optional<dvec3> turn_between(const TrackEnd& from, const ForceState& to) {
  constexpr double kOpposite = -0.98;
  const dvec3 left = glm::cross(from.up, from.forward), to_left = glm::cross(to.up, to.tangent);
  const dvec3 twice = glm::cross(from.forward, to.tangent) + glm::cross(from.up, to.up) + glm::cross(left, to_left);
  const double cos = (glm::dot(from.forward, to.tangent) + glm::dot(from.up, to.up) + glm::dot(left, to_left) - 1) / 2,
               sin = glm::length(twice) / 2;
  if (!(cos > kOpposite)) return std::nullopt;
  return sin > 0 ? base::arc_tangent(sin, cos) / (2 * sin) * twice : dvec3(0);
}

double metres_per_unit(const world::ForceProgram& program) {
  return program.over == world::ForceDomain::distance ? 1.0 : program.speed;
}
// Returns by channel what counts as much as 1 g.
std::array<double, 3> units_of(const world::ForceProgram& program) {
  const double one = program.of == world::ForceQuantity::curvature ? kCurvaturePerG : 1.0;
  return {one, one, kRollPerG * metres_per_unit(program)};
}

// The unknowns: what is added at each node but the first, by channel, and the length.
struct KeyAdditions {
  std::vector<double> nodes;  // in g, or what counts as much; channel by channel
  double length = 0;          // m or s
};

class HeldEndSolver {
 public:
  explicit HeldEndSolver(const ForceTask& task)
      : task_(task), metres_(metres_per_unit(task.program)), units_(units_of(task.program)) {
    const double length = task.program.length * metres_;
    nodes_ = std::clamp(static_cast<std::size_t>(length / kNodeGap), kFewestNodes, kMostNodes);
  }

  std::optional<ForceTask> run() {
    const KeyAdditions none{std::vector<double>(3 * nodes_, 0.0), task_.program.length};
    std::optional<KeyAdditions> found = led_from(none, 1);
    const std::optional<KeyAdditions> bridge = found ? std::nullopt : of_bridge();
    if (!found && bridge) found = led_from(*bridge, 1);
    if (!found) found = led_from(none, kShortestStage);
    if (!found && bridge) found = led_from(*bridge, kShortestStage);
    return found ? exact(*found) : std::nullopt;
  }

 private:
  static constexpr double kShortestStage = 1.0 / 64, kLeastPart = 1.0 / 8, kShrinks = 0.8;
  static constexpr int kMostRounds = 120;               // in all: some 0.06 s for 100 m
  static constexpr double kNear = 0.01, kThere = 1e-6;  // of the conditions, in about metres

  // Returns what a bridge needs more than the keys ask for.
  std::optional<KeyAdditions> of_bridge() const {
    const std::optional<ForceBridge> bridge = force_bridge(task_, nodes_);
    if (!bridge) return std::nullopt;
    KeyAdditions x{{}, bridge->length};
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 1; i <= nodes_; ++i) x.nodes.push_back(bridge->more[i][c] / units_[c]);
    return x;
  }

  // Leads the end from where these additions take it to where it is held, and the additions to the least ones, in as
  // few stages as go well, none shorter than that part of the way.
  std::optional<KeyAdditions> led_from(KeyAdditions now, double shortest) {
    const std::optional<End> first = missed(now, kCoarse);
    if (!first) return std::nullopt;
    first_ = *first, from_ = now.nodes;
    double done = 0;
    for (double by = 1; done < 1;) {
      const double share = std::min(done + by, 1.0);
      if (std::optional<KeyAdditions> next = led(now, 1 - share)) now = std::move(*next), done = share, by *= 2;
      else if ((by /= 2) < shortest) return std::nullopt;
    }
    return now;
  }

  // Returns the stage at which `rest` of the first misses and of the first additions is left, from one near to it.
  std::optional<KeyAdditions> led(KeyAdditions x, double rest) {
    const bool last = rest == 0;
    const int rounds = last ? 30 : 6;
    const double settled = last ? 5e-4 : 0.02, near = last ? kNear : 0.2;  // g, m
    std::vector<double> towards = from_;
    for (double& value : towards) value *= rest;
    std::optional<End> off = left_of(x, rest);
    // The steps leave out how the slopes bend. Where that makes them overshoot, none is shorter than the one before,
    // and a part of each leads on.
    double part = 1, before = kMostStep;
    for (int round = 0; off && round < rounds && rounds_ < kMostRounds; ++round, ++rounds_) {
      set_slopes(x);
      const std::optional<KeyAdditions> by = step_from(x, *off, towards);
      if (!by) return std::nullopt;
      part = most_of(*by) > kShrinks * before ? std::max(part / 2, kLeastPart) : std::min(1.5 * part, 1.0);
      before = most_of(*by);
      if (!(before < kMostStep)) return std::nullopt;
      add(x, *by, part);
      off = left_of(x, rest);
      if (off && before < settled && size_of(*off) < near) return x;
    }
    return std::nullopt;
  }
  std::optional<End> left_of(const KeyAdditions& x, double rest) const {
    std::optional<End> off = missed(x, kCoarse);
    for (std::size_t e = 0; off && e < kEnd; ++e) (*off)[e] -= rest * first_[e];
    return off;
  }

  // Returns the task whose path ends in place, with additions within 0.001 g of those.
  std::optional<ForceTask> exact(KeyAdditions x) const {
    for (int round = 0; round < 20; ++round) {
      const std::optional<End> off = missed(x, kFine);
      if (!off) return std::nullopt;
      if (size_of(*off) <= kThere) return with(x);
      const std::optional<KeyAdditions> by = step_from(x, *off, x.nodes);
      if (!by || !(most_of(*by) < kMostStep)) return std::nullopt;
      add(x, *by, 1);
    }
    return std::nullopt;
  }

  static double most_of(const KeyAdditions& by) {
    double most = 0;
    for (const double node : by.nodes) most = std::max(most, std::abs(node));
    return most;
  }
  static void add(KeyAdditions& x, const KeyAdditions& by, double part) {
    for (std::size_t k = 0; k < x.nodes.size(); ++k) x.nodes[k] += part * by.nodes[k];
    x.length += part * by.length;
  }

  // Returns the task with these additions: keys at equal distances with the slopes of parabolas, level at both ends.
  ForceTask with(const KeyAdditions& x) const {
    ForceTask task = task_;
    world::ForceProgram& added = task.added.emplace();
    added.over = task.program.over, added.length = x.length, added.speed = task.program.speed;
    const double gap = x.length / static_cast<double>(nodes_);
    for (std::size_t c = 0; c < 3; ++c) {
      const double unit = units_[c];
      std::vector<world::ForceKey>& keys = added.channels[c];
      keys.resize(nodes_ + 1);
      for (std::size_t i = 1; i <= nodes_; ++i)
        keys[i].at = i == nodes_ ? x.length : gap * static_cast<double>(i),
        keys[i].value = unit * x.nodes[c * nodes_ + i - 1];
      for (std::size_t i = 1; i < nodes_; ++i) keys[i].slope = (keys[i + 1].value - keys[i - 1].value) / (2 * gap);
    }
    return task;
  }

  // Returns by what a path misses the end, in units of about a metre.
  std::optional<End> missed_by(const ForceRates& rates, const ForceState& last) const {
    constexpr double kAngle = 10, kBend = 100;  // m per rad, m per 1/m
    const TrackEnd& to = *task_.held;
    const dvec3 left = glm::cross(to.up, to.forward), by = last.position - to.position,
                bend = rates.curvature - to.curvature;
    const std::optional<dvec3> turn = turn_between(to, last);
    if (!turn || rates.folded) return std::nullopt;
    return End{by.x,
               by.y,
               by.z,
               kAngle * glm::dot(*turn, to.forward),
               kAngle * glm::dot(*turn, to.up),
               kAngle * glm::dot(*turn, left),
               kBend * glm::dot(bend, to.up),
               kBend * glm::dot(bend, left),
               kBend * (rates.spin - to.spin)};
  }
  std::optional<End> missed(const KeyAdditions& x, double step) const {
    if (!(x.length > 0 && x.length <= world::longest_of(task_.program.over))) return std::nullopt;
    const ForceTask task = with(x);
    const ForceLaw law(task);
    ForceState last = law.start();
    const bool whole = follow_law(law, step, 0, last, [&](double, const ForceState& there) {
      last = there;
      return !law.too_slow(there);
    });
    return whole ? missed_by(law.rates(x.length, last), last) : std::nullopt;
  }

  // Sets how the misses change with each unknown, the length last; to nothing where that is not known.
  void set_slopes(const KeyAdditions& now) {
    constexpr double kBy = 1e-6;  // of the length
    const ForceTask task = with(now);
    KeyAdditions longer = now;
    longer.length *= 1 + kBy;
    const auto found = end_slopes(ForceLaw(task), now.length, nodes_,
                                  [&](const ForceRates& rates, const ForceState& s) { return missed_by(rates, s); });
    const std::optional<End> here = missed(now, kCoarse), there = missed(longer, kCoarse);
    slopes_.assign(3 * nodes_ + 1, End{});
    if (!found || !here || !there) return;
    for (std::size_t k = 0; k < found->size(); ++k)
      for (std::size_t e = 0; e < kEnd; ++e) slopes_[k][e] = units_[k / nodes_] * (*found)[k][e];
    for (std::size_t e = 0; e < kEnd; ++e)
      slopes_.back()[e] = ((*there)[e] - (*here)[e]) / (longer.length - now.length);
  }

  // The weight of a node: the length that it stands for.
  double weight(std::size_t k) const { return k % nodes_ + 1 == nodes_ ? 0.5 : 1.0; }

  // Returns the step that, to first order, leads to the end, and to the additions nearest to those of `towards`.
  std::optional<KeyAdditions> step_from(const KeyAdditions& now, const End& off,
                                        const std::vector<double>& towards) const {
    std::array<std::array<double, kEnd + 1>, kEnd + 1> a{};
    std::array<double, kEnd + 1> b{};
    for (std::size_t e = 0; e < kEnd; ++e) {
      b[e] = -off[e];
      for (std::size_t k = 0; k < 3 * nodes_; ++k) {
        b[e] += slopes_[k][e] * (now.nodes[k] - towards[k]);
        for (std::size_t f = 0; f < kEnd; ++f) a[e][f] += slopes_[k][e] * slopes_[k][f] / weight(k);
      }
      a[e][kEnd] = a[kEnd][e] = slopes_.back()[e];
    }
    if (!base::solve_linear(a, b)) return std::nullopt;
    KeyAdditions by{towards, b[kEnd]};
    for (std::size_t k = 0; k < 3 * nodes_; ++k) {
      by.nodes[k] -= now.nodes[k];
      for (std::size_t e = 0; e < kEnd; ++e) by.nodes[k] += slopes_[k][e] * b[e] / weight(k);
    }
    return by;
  }

  ForceTask task_;
  double metres_;  // per unit of the axis, at the start
  std::array<double, 3> units_;
  std::size_t nodes_ = 0;
  std::vector<End> slopes_;
  End first_{};               // missed by the additions that a way began with
  std::vector<double> from_;  // and those
  int rounds_ = 0;            // taken in all
};

}  // namespace

std::optional<ForceTask> hold_end(const ForceTask& task) { return HeldEndSolver(task).run(); }

}  // namespace coaster::sim
