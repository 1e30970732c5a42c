#include "exchange/fvd/fvd.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "curve/frames.h"
#include "world/motion.h"

namespace coaster::exchange {
namespace {

// Shifts the middle of a piece, and makes it steeper in its middle or at its ends.
double warped(const FvdPiece& piece, double x) {
  constexpr double kNone = 0.0005;
  if (piece.centre > 0) x = std::pow(x, std::exp2(piece.centre / 2));
  if (piece.centre < 0) x = 1 - std::pow(1 - x, std::exp2(-piece.centre / 2));
  const double t = piece.tension, hurry = 2 * (x - 0.5);
  if (t > kNone) return 0.5 * (std::sinh(t * hurry) / std::sinh(t) + 1);
  if (t < -kNone) return 0.5 * (std::asinh(std::sinh(t) * hurry) / t + 1);
  return x;
}

// Goes from 0 over two extrema back to 0, with slope 0 at both ends, and is 0 at `zero`; one extremum is 1.
double two_humps(double x, double form) {
  const double zero = std::abs(form) / 10, root = std::sqrt(9 + 16 * zero * (zero - 1));
  const auto humps = [&](double at) { return at * at * (at - 1) * (at - 1) * (at - zero); };
  const double peak = humps((3 + 4 * zero + (form > 0 ? root : -root)) / 10);
  return peak == 0 ? 0 : humps(x) / peak;
}

// True if the piece returns to its start value, with which the next piece begins.
bool returns(const FvdPiece& piece) {
  switch (piece.shape) {
    case FvdShape::quadratic: return std::abs(piece.form) < 0.5;
    case FvdShape::quartic: return piece.form < 0;
    case FvdShape::quintic: return std::abs(piece.form) > 0.005;
    case FvdShape::plateau: return true;
    default: return false;
  }
}

// Returns the fraction of the change at a fraction x of the piece.
double shape_at(const FvdPiece& piece, double x) {
  const double y = 1 - x, form = piece.form;
  switch (piece.shape) {
    case FvdShape::quadratic:
      if (returns(piece)) return 4 * x * y;
      return form < 0 ? 1 - y * y : x * x;
    case FvdShape::cubic: return x * x * (3 - 2 * x);
    case FvdShape::quartic:
      if (returns(piece)) return 16 * x * x * y * y;
      return x * x * (x * (4 * form + 4) - 6 * form - 3 * x * x) /
             (std::abs(1 - 2 * form) < 1e-3 ? 1e-3 : 1 - 2 * form);
    case FvdShape::quintic:
      if (returns(piece)) return two_humps(x, form);
      return x * x * x * (10 + x * (6 * x - 15));
    case FvdShape::sinusoidal: return 0.5 * (1 - base::sin_cos(base::kPi * x).cos);
    case FvdShape::plateau: {
      const double side = 1 - std::abs(2 * x - 1);
      return 1 - std::exp(-15 * form * side * side * side);
    }
    default: return x;
  }
}

// Returns a quartic that begins with the rate and its slope, ends with both 0, and turns by -roll in total.
double to_horizon(const FvdPiece& piece, double x, const FvdLevelling& from) {
  const double rate = piece.start, mean = -from.roll / std::max(piece.to - piece.from, 1e-6), slope = from.slope;
  const double quartic = -2.5 * (slope + 6 * (rate - 2 * mean)), cubic = 6 * slope + 32 * rate - 60 * mean,
               square = -4.5 * slope - 18 * rate + 30 * mean;
  return rate + x * (slope + x * (square + x * (cubic + x * quartic)));
}

double end_of(const FvdPiece& piece) {
  if (piece.shape == FvdShape::to_zero) return 0;
  return piece.start + (returns(piece) ? 0 : piece.change);
}

// Adds keys strictly between two, where their curve differs from f.
void refine(const std::function<double(double)>& f, const world::ForceKey& from, const world::ForceKey& to,
            double tolerance, double gap, std::vector<world::ForceKey>& keys) {
  constexpr int kChecks = 8;
  const double length = to.at - from.at;
  if (length < 2 * gap || keys.size() > world::kMostForceKeys) return;
  double worst = 0;
  for (int i = 1; i < kChecks; ++i) {
    const double u = i / double(kChecks), v = 1 - u;
    const double curve = from.value * v * v * (1 + 2 * u) + to.value * u * u * (3 - 2 * u) +
                         length * u * v * (from.slope * v - to.slope * u);
    worst = std::max(worst, std::abs(curve - f(from.at + u * length)));
  }
  if (worst <= tolerance) return;
  const double middle = (from.at + to.at) / 2, step = std::min(length / 20, 1e-3);
  const world::ForceKey key{middle, f(middle), (f(middle + step) - f(middle - step)) / (2 * step)};
  refine(f, from, key, tolerance, gap, keys);
  keys.push_back(key);
  refine(f, key, to, tolerance, gap, keys);
}

using glm::dvec3;
constexpr double kStep = 0.05, kPointStep = 0.25, kShortestLead = 1;  // m
constexpr double kNoLead = 1e-9;                                      // m
constexpr double kSlowest = 1;                                        // m/s
constexpr double kGravityThere = 9.80665;                             // m/s^2
constexpr double kMostLift = 0.9;     // share of the train's speed by which hearts above a turn may be slower
constexpr double kSpeedHeight = 0.9;  // of the heartline, from the hearts down to the point that has the train's energy
constexpr dvec3 kUp{0, 1, 0};

struct FvdTrainState {
  dvec3 position, forward, up;
  double square;         // m^2/s^2, the speed squared
  dvec3 right;           // level: the axis of pitch, which stays on its side through the vertical
  double s = 0, at = 0;  // m of the hearts; m, s or degrees of the section's functions
  double rails = 0;      // m of the rails, which swing aside as the train rolls about its hearts
};

// By metre of the hearts.
struct Rates {
  dvec3 forward{0};           // unit
  dvec3 curvature{0};         // 1/m
  double twist = 0;           // rad/m to the right
  double yaw = 0;             // rad/m of a geometric section's heading to the left
  double per_metre = 1;       // of `at`
  double way = 1, rails = 1;  // m that the train's speed covers; m of the rails
  bool folded = false;        // the turn is too tight for the heartline
};

// Returns degrees of heading to the left per metre.
double yaw_of(dvec3 forward, dvec3 curvature) {
  const double level = forward.x * forward.x + forward.z * forward.z;
  return level > 1e-6 ? base::degrees(glm::dot(curvature, glm::cross(kUp, forward)) / level) : 0.0;
}

// Returns a level vector across a direction, on the side of `before`; that itself near the vertical.
dvec3 level_right(dvec3 forward, dvec3 before) {
  const dvec3 right = glm::cross(forward, kUp);
  if (!(glm::length(right) > 0.05)) return before;
  return glm::dot(right, before) < 0 ? -right : right;
}

dvec3 right_at(const FvdStart& start) {
  const dvec3 right = glm::cross(start.forward, kUp);
  return glm::length(right) > 1e-6 ? right : glm::cross(start.forward, start.up);
}

class FvdIntegration {
 public:
  FvdIntegration(const FvdTrack& track, FvdSection& section, const FvdStart& start)
      : track_(track),
        section_(section),
        gravity_(track.heart == 0 ? world::kGravity : kGravityThere),
        start_{start.forward, start.up},
        train_{start.position, start.forward, start.up, start.speed * start.speed, right_at(start)} {
    if (!section.free_speed) train_.square = section.speed * section.speed;
    const bool forced = section.kind == FvdKind::forced || section.kind == FvdKind::geometric;
    const std::array<const FvdFunction*, 3> all{&section.roll, &section.vertical, &section.lateral};
    length_ = forced ? shared_length(all) : section.roll.back().to;  // locks mean nothing in straights and curves
    for (FvdFunction* const function : {&section.roll, &section.vertical, &section.lateral}) {
      if (function->empty()) continue;
      join_pieces(*function, function->front().start, length_);
      for (const FvdPiece& piece : *function) corners_.push_back(piece.from);
    }
    // A turn of a small angle has room for shorter leads only: one turns by half of its length over the radius.
    // Without a lead a train with a heartline bends at once, as there.
    const double radius = std::max(section.radius, 1e-3), turn = base::radians(length_);
    const double shortest = track.heart == 0 ? kShortestLead : 0;
    lead_in_ = std::max(1.997 * radius * base::radians(section.lead_in), std::min(shortest, radius * turn));
    lead_out_angle_ = std::max(section.lead_out, base::degrees(std::min(shortest / radius, turn) / 2));
    lead_in_ = std::max(lead_in_, kNoLead);
    if (section.kind == FvdKind::curved && track.heart != 0) corners_.push_back(length_ - lead_out_angle_);
    std::ranges::sort(corners_);
  }

  FvdPath run() {
    enter_piece(train_);
    enter_lead_out(train_);
    record(train_);
    path_.curve.breaks = {0};
    double recorded = 0;
    std::size_t corner = 0;
    while (path_.stopped.empty()) {
      const Rates now = rates(train_);
      const double left = rest(train_, now);
      if (left < 1e-6) break;
      double by = std::min({kStep, 0.005 * std::sqrt(train_.square), left});
      while (corner < corners_.size() && corners_[corner] <= train_.at + 1e-9) ++corner;
      const bool at_corner = corner < corners_.size() && (corners_[corner] - train_.at) / now.per_metre <= by;
      if (at_corner) by = std::max((corners_[corner] - train_.at) / now.per_metre, 1e-9);
      train_ = moved(train_, rates(moved(train_, now, by / 2)), by);
      if (train_.square < kSlowest * kSlowest) path_.stopped = fmt::format("the train falls below {} m/s", kSlowest);
      else if (rates(train_).folded) path_.stopped = "the turn is too tight for the heartline";
      else if (!(train_.s < kLongestFvd)) path_.stopped = fmt::format("it is longer than {} m", kLongestFvd);
      else if (!(glm::length(train_.position) < world::kMaxCoordinate)) path_.stopped = "it leaves the world";
      if (!path_.stopped.empty()) break;
      enter_lead_out(train_);
      enter_piece(train_);
      if (at_corner || train_.s - recorded >= kPointStep - 1e-9 || rest(train_, rates(train_)) < 1e-6) {
        record(train_), recorded = train_.s;
        if (at_corner) path_.curve.breaks.push_back(path_.curve.points.size() - 1);
      }
    }
    if (train_.s > recorded + 1e-6 && path_.stopped.empty()) record(train_);
    if (path_.curve.breaks.back() + 1 != path_.curve.points.size())
      path_.curve.breaks.push_back(path_.curve.points.size() - 1);
    path_.speed = std::sqrt(train_.square);
    return std::move(path_);
  }

 private:
  // Returns the curvature of a turn, which rises and falls as a smooth step of the length.
  double turn_at(const FvdTrainState& train) const {
    double share = lead_in_ > kNoLead ? std::min(train.rails / lead_in_, 1.0) : 1.0;
    if (out_from_) share = std::min(share, std::clamp(1 - (train.rails - *out_from_) / lead_out_, 0.0, 1.0));
    return sim::smooth_step(share) / section_.radius;
  }

  Rates rates(const FvdTrainState& train) const {
    const double speed = std::sqrt(train.square), heart = track_.heart;
    double most = kMostLift;
    Rates r;  // by metre of the train's way, until the end
    r.forward = train.forward;
    if (section_.kind == FvdKind::curved) r.per_metre = std::max(base::degrees(turn_at(train)), 1e-9);
    else if (section_.kind != FvdKind::straight && !section_.by_distance) r.per_metre = 1 / speed;
    const dvec3 left = glm::cross(train.up, train.forward);
    switch (section_.kind) {
      case FvdKind::curved: {
        // The plane of the turn is fixed while the train rolls.
        const base::SinCos to = base::sin_cos(base::radians(section_.direction));
        const dvec3 axis = to.sin * start_.up - to.cos * start_.left();
        r.curvature = turn_at(train) * glm::cross(axis, train.forward);
        break;
      }
      case FvdKind::forced: {
        const dvec3 felt =
            value_at(section_.vertical, train.at) * train.up + value_at(section_.lateral, train.at) * left - kUp;
        r.curvature = gravity_ / train.square * (felt - glm::dot(felt, train.forward) * train.forward);
        // Upwards it is that of the hearts, which have their own speed: k (1 - heart k) = up. That program goes on a
        // little beyond what can be solved.
        const double up = glm::dot(r.curvature, train.up), root = std::sqrt(std::max(1 - 4 * heart * up, 0.0));
        if (heart != 0) r.curvature += (2 / (1 + root) - 1) * up * train.up, most = 0.6;
        break;
      }
      case FvdKind::geometric: {
        const double pitch = value_at(section_.vertical, train.at) * r.per_metre,
                     yaw = value_at(section_.lateral, train.at) * r.per_metre;
        r.curvature = base::radians(pitch) / glm::length(train.right) * glm::cross(train.right, train.forward);
        r.curvature += base::radians(yaw) * glm::cross(kUp, train.forward);
        r.yaw = base::radians(yaw);
        break;
      }
      default: break;
    }
    const FvdPiece& piece = piece_at(section_.roll, train.at);
    double roll = value_of(piece, train.at, levelling_);  // degrees to the left
    roll *= section_.kind == FvdKind::straight || section_.kind == FvdKind::curved ? 1 / speed : r.per_metre;
    if (section_.upright || piece.shape == FvdShape::to_zero)
      roll -= train.forward.y * yaw_of(train.forward, r.curvature);
    r.twist = -base::radians(roll);
    const double lift = heart * glm::dot(r.curvature, train.up),
                 swing = std::sqrt(1 + heart * heart * r.twist * r.twist);
    r.folded = lift > most, r.way = 1 / (1 - std::min(lift, kMostLift)), r.rails = swing * r.way;
    if (section_.by_distance) r.per_metre *= swing;
    r.curvature *= r.way, r.twist *= r.way, r.yaw *= r.way, r.per_metre *= r.way;
    return r;
  }

  // Each piece that levels the roll begins from the present roll.
  void enter_piece(const FvdTrainState& train) {
    constexpr double kBefore = 1e-3;
    std::size_t now = 0;
    while (now + 1 < section_.roll.size() && section_.roll[now].to < train.at + 1e-9) ++now;
    if (now == piece_) return;
    const bool first = piece_ > now;
    piece_ = now;
    FvdPiece& piece = section_.roll[now];
    if (piece.shape != FvdShape::to_zero) return;
    const FvdPiece& before = section_.roll[first ? now : now - 1];
    const double rate = first ? 0 : value_of(before, before.to) - value_of(before, before.to - kBefore);
    levelling_ = {base::degrees(base::arc_tangent(glm::cross(train.forward, train.up).y, train.up.y)), rate / kBefore};
    const Rates r = rates(train);
    if (!section_.upright) piece.start += train.forward.y * yaw_of(train.forward, r.curvature) / r.per_metre;
  }

  void enter_lead_out(const FvdTrainState& train) {
    if (section_.kind == FvdKind::curved && !out_from_ && train.at >= length_ - lead_out_angle_ - 1e-9) {
      out_from_ = train.rails;
      lead_out_ = std::max(1.997 * section_.radius * base::radians(length_ - train.at), kNoLead);
    }
  }

  // Returns the train after a step with the rates of its middle: a turn about a fixed axis.
  FvdTrainState moved(const FvdTrainState& train, const Rates& rates, double by) const {
    FvdTrainState next = train;
    const dvec3 turn = glm::cross(rates.forward, rates.curvature) + rates.twist * rates.forward;
    if (const double size = glm::length(turn); size > 0) {
      next.forward = glm::normalize(curve::rotate(train.forward, turn / size, size * by));
      next.up = curve::perpendicular(next.forward, curve::rotate(train.up, turn / size, size * by));
      next.right = level_right(next.forward, curve::rotate(train.right, kUp, rates.yaw * by));
    }
    const double arc = by * by * glm::dot(rates.curvature, rates.curvature);
    next.position += by * (1 - arc / 24) * rates.forward;  // the chord
    if (section_.free_speed)
      next.square -= 2 * (gravity_ * (energy_height(next) - energy_height(train) + track_.friction * rates.rails * by) +
                          track_.resistance * train.square * rates.way * by);
    next.s += by, next.at += rates.per_metre * by, next.rails += rates.rails * by;
    return next;
  }

  void record(const FvdTrainState& train) {
    const Rates r = rates(train);
    path_.curve.points.push_back({train.s, train.position, train.forward, r.curvature, train.up, r.twist});
    path_.at.push_back(train.at);
    path_.twist.push_back(base::degrees(r.twist) / r.per_metre);
  }

  // Returns the metres to the section's end.
  double rest(const FvdTrainState& train, const Rates& now) const {
    if (section_.kind == FvdKind::curved && lead_out_angle_ > 0)
      return out_from_ ? (*out_from_ + lead_out_ - train.rails) / now.rails : std::numeric_limits<double>::infinity();
    return (length_ - train.at) / now.per_metre;
  }

  double energy_height(const FvdTrainState& train) const {
    return train.position.y - kSpeedHeight * track_.heart * train.up.y;
  }

  const FvdTrack& track_;
  FvdSection& section_;
  const double gravity_;  // without a heartline that of force sections, which such a track gets
  const curve::Frame start_;
  FvdTrainState train_;
  double length_ = 0;  // of `at`
  FvdLevelling levelling_;
  std::size_t piece_ = ~std::size_t{0};  // index of the roll's piece; none at first
  std::optional<double> out_from_;       // m where a turn's lead-out begins
  double lead_in_ = 0, lead_out_ = 0;    // m
  double lead_out_angle_ = 0;            // degrees of the turn left where the lead-out begins
  std::vector<double> corners_;          // of `at`
  FvdPath path_;
};

}  // namespace

double value_of(const FvdPiece& piece, double x, const FvdLevelling& levelling) {
  const double length = piece.to - piece.from;
  const double share = length > 0 ? std::clamp((x - piece.from) / length, 0.0, 1.0) : 1.0;
  const double place = warped(piece, share);
  if (piece.shape == FvdShape::to_zero) return to_horizon(piece, place, levelling);
  return piece.start + piece.change * shape_at(piece, place);
}

const FvdPiece& piece_at(const FvdFunction& function, double x) {
  const auto found = std::ranges::find_if(function, [&](const FvdPiece& piece) { return piece.to >= x; });
  return found == function.end() ? function.back() : *found;
}

void join_pieces(FvdFunction& function, double start, double length) {
  for (FvdPiece& piece : function) {
    piece.start = start, start = end_of(piece);
    if (piece.follows) piece.to = std::max(length, piece.from);
  }
}

double shared_length(std::span<const FvdFunction* const> functions) {
  double length = std::numeric_limits<double>::infinity();
  for (const FvdFunction* const function : functions)
    if (std::ranges::none_of(*function, &FvdPiece::follows)) length = std::min(length, function->back().to);
  return std::isfinite(length) ? length : 0;
}

std::vector<world::ForceKey> keys_along(const std::function<double(double)>& f, std::vector<double> corners,
                                        double length, double tolerance, double gap, double limit) {
  std::erase_if(corners, [&](double at) { return !(at > 1.5 * gap && at < length - 1.5 * gap); });
  std::ranges::sort(corners);
  const double step = gap / 50;
  std::vector<world::ForceKey> ends{{0, f(0), (f(step) - f(0)) / step}};
  for (const double at : corners) {
    if (at - ends.back().at < 1.5 * gap) continue;
    const double before = at - 0.51 * gap, after = at + 0.51 * gap;
    const double slope = (f(before) - f(before - step)) / step, next = (f(after + step) - f(after)) / step;
    if (std::abs(f(after) - f(before) - (after - before) * slope) + gap * std::abs(next - slope) < tolerance) {
      ends.push_back({at, f(at), (next + slope) / 2});
    } else {
      ends.push_back({before, f(before), slope});
      ends.push_back({after, f(after), next});
    }
  }
  ends.push_back({length, f(length), (f(length) - f(length - step)) / step});
  std::vector<world::ForceKey> keys;
  do {
    keys = {ends.front()};
    for (std::size_t i = 1; i < ends.size(); ++i) {
      if (ends[i].at - ends[i - 1].at > 1.01 * gap) refine(f, ends[i - 1], ends[i], tolerance, gap, keys);
      keys.push_back(ends[i]);
    }
    tolerance *= 2;
  } while (keys.size() > world::kMostForceKeys && ends.size() <= world::kMostForceKeys);
  if (keys.size() > world::kMostForceKeys) keys.resize(world::kMostForceKeys);
  for (world::ForceKey& key : keys) {
    key.value = std::clamp(key.value, -limit, limit);
    key.slope = std::clamp(key.slope, -world::kMostForceSlope, world::kMostForceSlope);
  }
  const bool level = std::ranges::all_of(keys, [&](const world::ForceKey& key) {
    return std::abs(key.value - keys.front().value) < 1e-9 && std::abs(key.slope) < 1e-9;
  });
  if (level) keys.resize(1), keys.front().slope = 0;
  return keys;
}

FvdPath fvd_path(const FvdTrack& track, FvdSection& section, const FvdStart& start) {
  FvdPath nothing;
  nothing.speed = start.speed;
  const auto stops = [&](std::string why) {
    nothing.stopped = std::move(why);
    return nothing;
  };
  if (section.kind == FvdKind::bezier) return stops("Bezier sections are not read");
  for (const FvdFunction* const function : {&section.roll, &section.vertical, &section.lateral})
    if (std::ranges::any_of(*function, [](const FvdPiece& piece) { return piece.shape == FvdShape::free_form; }))
      return stops("openFVD does not store the points of a free-form piece");
  const bool forced = section.kind == FvdKind::forced || section.kind == FvdKind::geometric;
  if (forced && std::ranges::all_of(std::array{&section.roll, &section.vertical, &section.lateral},
                                    [](const FvdFunction* f) { return std::ranges::any_of(*f, &FvdPiece::follows); }))
    return stops("all of its functions are locked to the end of another");
  if (!section.free_speed && !(section.speed >= kSlowest))
    return stops(fmt::format("it keeps a speed of {} m/s", section.speed));
  if (section.free_speed && !(start.speed >= kSlowest))
    return stops(fmt::format("the train falls below {} m/s", kSlowest));
  if (section.kind == FvdKind::curved && !(section.radius >= kSlowest))
    return stops(fmt::format("its radius is {} m", section.radius));
  return FvdIntegration(track, section, start).run();
}

}  // namespace coaster::exchange
