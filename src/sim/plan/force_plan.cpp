#include "sim/plan/force_plan.h"

#include <cmath>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "base/text.h"
#include "curve/continuity.h"
#include "curve/frames.h"
#include "sim/plan/element_plan.h"
#include "sim/plan/force_end_constraint.h"
#include "sim/ride/train.h"

namespace coaster::sim {
namespace {

using world::ForceDomain;

constexpr double kShortestPlan = 1;  // m

}  // namespace

std::size_t ForcePlan::point_at(double at) const {
  const auto above = std::ranges::upper_bound(path.points, at, {}, &ForcePoint::at);
  return above == path.points.begin() ? 0 : static_cast<std::size_t>(above - path.points.begin()) - 1;
}

std::string too_slow_text(double speed) {
  return fmt::format(
      "the train is at {:.1f} m/s there, and forces need {} m/s: add a launch or a lift hill before them", speed,
      world::kSlowestForce);
}

ForcePlan plan_force(const ForceTask& task) {
  ForcePlan plan;
  plan.task = task;
  if (const auto wrong = world::broken(task.program)) {
    plan.refusal = *wrong;
    return plan;
  }
  if (world::needs_speed(task.program) && task.program.speed < world::kSlowestForce) {
    plan.refusal = too_slow_text(task.program.speed);
    return plan;
  }
  std::optional<ForceTask> held;
  if (task.held && !(held = hold_end(task))) {
    plan.refusal = fmt::format("its ends stay, and no {} near those of its keys lead from the one to the other",
                               task.program.of == world::ForceQuantity::forces ? "forces" : "curvatures");
    return plan;
  }
  const ForceTask& as = held ? *held : task;
  plan.path = force_path(as);
  plan.length = plan.path.curve.length();
  plan.end_speed = std::sqrt(std::max(plan.path.points.back().square, 0.0));
  if (held && !plan.path.stopped.empty()) plan.refusal = fmt::format("its ends stay, and {}", stop_text(plan));
  else if (plan.length < kShortestPlan) plan.refusal = plan.path.stopped + " at once";
  else plan.fit = fit_force(as, plan.path);
  for (const ForcePoint& point : plan.path.points)
    if (const double most = std::max(std::abs(point.added[0]), std::abs(point.added[1])); most > plan.unmet)
      plan.unmet = most, plan.unmet_at = point.at;
  return plan;
}

TrackEnd start_of(const world::Document& document, const world::SectionRun& run) {
  TrackEnd start = end_at(document, run.first);
  const std::vector<world::Entity>& segments = document.track.segments;
  const world::Entity before = segments[(run.first + segments.size() - 1) % segments.size()];
  const bool completed =
      document.track.closed &&
      world::section(document, world::segment(document, before).section).kind == world::SectionKind::complete;
  if (completed)
    start.curvature =
        curve::across(curve::curvature_vector(world::cubic_of(document, segments[run.first]), 0.0), start.forward);
  return start;
}

std::optional<TrackEnd> held_end(const world::Document& document, const world::SectionRun& run) {
  const std::vector<world::Entity>& segments = document.track.segments;
  if (!document.track.closed && run.end() == segments.size()) return std::nullopt;
  TrackEnd end = end_at(document, run.end() % document.track.knots.size());
  const curve::Cubic next = world::cubic_of(document, segments[run.end() % segments.size()]);
  end.curvature = curve::across(curve::curvature_vector(next, 0.0), end.forward);
  return end;
}

namespace {

struct EquipmentOn {
  const world::Equipment* first = nullptr;  // null: nothing on any part
  bool same = false;                        // on all of the section
};
EquipmentOn equipment_on(const world::Document& document, const world::SectionRun& run) {
  EquipmentOn on{nullptr, true};
  for (std::size_t i = run.first; i < run.end(); ++i) {
    const auto* const here = document.entities.find<world::Equipment>(document.track.segments[i]);
    if (on.first == nullptr) on.same = i == run.first && here != nullptr, on.first = here;
    else if (here == nullptr || *here != *on.first) on.same = false;
  }
  return on;
}

}  // namespace

std::string uncounted_text(const world::Document& document, const world::SectionRun& run,
                           const world::ForceProgram& program) {
  const EquipmentOn on = equipment_on(document, run);
  if (on.first == nullptr || !world::needs_speed(program)) return {};
  if (!on.same)
    return "Equipment on part of a force section is not in its planned speed: its segments change with the keys.";
  if (on.first->kind != world::EquipmentKind::station) return {};
  return "The station is not in the planned speed: where trains stand, forces do not shape the track.";
}

ForceTask force_task(const world::Document& document, const world::SectionRun& run,
                     const world::ForceProgram& program) {
  ForceTask task = force_task(document, start_of(document, run), program);
  if (program.hold) task.held = held_end(document, run);
  if (const EquipmentOn on = equipment_on(document, run); on.same) task.equipment = *on.first;
  return task;
}

ForceTask force_task(const world::Document& document, const TrackEnd& end, const world::ForceProgram& program) {
  ForceTask task{end, program, document.resistance, world::rails_height(document), world::riders_height(document)};
  task.digs = !document.park.plain();
  if (const world::Train* const cart = document.entities.find<world::Train>(world::first_cart(document)))
    task.losses = resistance_of(document, cart->mass), task.cars = cart->cars, task.spacing = cart->spacing;
  return task;
}

std::string unmet_text(const ForcePlan& plan) {
  const world::ForceProgram& program = plan.task.program;
  const bool bends = program.of == world::ForceQuantity::curvature;
  if (plan.unmet < 0.005 * (bends ? kCurvaturePerG : 1.0)) return {};
  const std::array<double, 3>& added = plan.path.points[plan.point_at(plan.unmet_at)].added;
  const auto channel =
      std::abs(added[0]) >= std::abs(added[1]) ? world::ForceChannel::vertical : world::ForceChannel::lateral;
  return fmt::format("Both ends stay: at {:.1f} {} {} {:.{}f} {} {} than the {} keys say.", plan.unmet_at,
                     world::unit_of(program.over), bends ? "the track bends" : "riders feel", plan.unmet, bends ? 4 : 2,
                     world::unit_of(program, channel), added[static_cast<std::size_t>(channel)] > 0 ? "more" : "less",
                     base::name_of(channel));
}

std::string judged_text(const world::ForceProgram& program) {
  return program.of == world::ForceQuantity::curvature
             ? fmt::format(" at {} m/s", base::to_text(world::kCurvatureSpeed))
             : "";
}

std::string missed_text(const ForcePlan& plan) {
  if (plan.fit.within) return {};
  return fmt::format("riders feel up to {:.2f} g more or less than the keys say{}, at {:.1f} m", plan.fit.felt_error,
                     judged_text(plan.task.program), plan.fit.felt_at);
}

std::string stop_text(const ForcePlan& plan) {
  if (plan.path.stopped.empty()) return {};
  return fmt::format("the section ends at {:.1f} m: {} there", plan.length, plan.path.stopped);
}

bool ForcePlanCache::has(const ForceTask& task) const {
  return std::any_of(plans_.begin(), plans_.end(), [&](const ForcePlan& plan) { return plan.task == task; });
}

void ForcePlanCache::make_room(std::size_t sections) { most_ = std::max(most_, 2 * sections); }

const ForcePlan& ForcePlanCache::plan(const ForceTask& task) {
  const auto found = std::find_if(plans_.begin(), plans_.end(), [&](const ForcePlan& p) { return p.task == task; });
  if (found != plans_.end()) {
    std::rotate(found, found + 1, plans_.end());
    return plans_.back();
  }
  if (plans_.size() >= most_) plans_.erase(plans_.begin());
  plans_.push_back(plan_force(task));
  plans_.back().serial = ++serial_;
  return plans_.back();
}

namespace {

using world::ForceKey, world::ForceQuantity, world::ForceDomain, world::ForceProgram;

double speed_at(const ForcePoint& point) {
  return std::sqrt(std::max(point.square, world::kSlowestForce * world::kSlowestForce));
}
bool is_rate(const ForceProgram& program, std::size_t channel) {
  return program.of == ForceQuantity::forces && static_cast<world::ForceChannel>(channel) == world::ForceChannel::roll;
}

// Values at the plan's points.
struct Samples {
  std::vector<double> at, values, slopes;
  // Returns the key of the curve there.
  ForceKey key(const ForcePlan& plan, double place) const {
    const auto of = [&](const std::vector<double>& list) {
      return between_points(plan, place, [&](std::size_t i) { return list[i]; });
    };
    return {place, of(values), of(slopes)};
  }
};

Samples samples_of(const ForcePlan& plan, ForceQuantity of, std::size_t channel) {
  Samples samples;
  double angle = 0;
  for (std::size_t i = 0; i < plan.path.points.size(); ++i) {
    const ForcePoint& point = plan.path.points[i];
    const ElementPoint& on = plan.path.curve.points[i];
    if (i > 0) {
      const ElementPoint& before = plan.path.curve.points[i - 1];
      angle += base::degrees((before.spin + on.spin) / 2 * (on.s - before.s));
    }
    const double rate = base::degrees(on.spin) * (plan.task.program.over == ForceDomain::time ? speed_at(point) : 1.0);
    const std::array<double, 3> forces{point.up, point.side, rate},
        bends{glm::dot(on.curvature, on.up), glm::dot(on.curvature, glm::cross(on.up, on.tangent)), angle};
    samples.at.push_back(point.at), samples.values.push_back((of == ForceQuantity::forces ? forces : bends)[channel]);
  }
  for (std::size_t i = 0; i < samples.at.size(); ++i) {
    const std::size_t low = i == 0 ? 0 : i - 1, high = std::min(i + 1, samples.at.size() - 1);
    const double gap = samples.at[high] - samples.at[low];
    samples.slopes.push_back(gap > 0 ? (samples.values[high] - samples.values[low]) / gap : 0.0);
  }
  return samples;
}

ForceKey limited(const ForceProgram& program, world::ForceChannel channel, ForceKey key) {
  const double limit = world::channel_of(program.of, channel).limit;
  key.value = std::clamp(key.value, -limit, limit);
  key.slope = std::clamp(key.slope, -world::kMostForceSlope, world::kMostForceSlope);
  return key;
}

// Puts keys of the samples at the places, and more where the curve between them is off by more than `unit`.
void put_keys(const ForcePlan& plan, const Samples& samples, world::ForceChannel channel, double unit,
              ForceProgram& program) {
  std::vector<ForceKey>& keys = program.keys(channel);
  const double gap = world::key_gap_of(program.over);
  for (ForceKey& key : keys) key = limited(program, channel, samples.key(plan, key.at));
  const auto put = [&](double at) {
    const auto next = std::find_if(keys.begin(), keys.end(), [&](const ForceKey& key) { return key.at > at - gap; });
    if (next != keys.end() && next->at < at + gap) return false;
    keys.insert(next, limited(program, channel, samples.key(plan, at)));
    return true;
  };
  put(0), put(samples.at.back());
  std::vector<double> tried;
  while (keys.size() < world::kMostForceKeys) {
    const ForceCurve curve(program, channel);
    double most = unit;
    std::size_t worst = 0;
    for (std::size_t i = 1; i + 1 < samples.at.size(); ++i) {
      const double off = std::abs(curve.at(samples.at[i]).value - samples.values[i]);
      if (off <= most || std::find(tried.begin(), tried.end(), samples.at[i]) != tried.end()) continue;
      most = off, worst = i;
    }
    if (worst == 0) break;
    if (!put(samples.at[worst])) tried.push_back(samples.at[worst]);
  }
}

}  // namespace

world::ForceProgram over_other_axis(const ForcePlan& plan) {
  const world::ForceProgram& from = plan.task.program;
  world::ForceProgram to = from;
  const bool by_time = from.over == ForceDomain::distance;
  to.over = by_time ? ForceDomain::time : ForceDomain::distance;
  const ForcePoint& last = plan.path.points.back();
  const auto speed = [&](double at) {
    return between_points(plan, at, [&](std::size_t i) { return speed_at(plan.path.points[i]); });
  };
  const auto place = [&](double at) {
    const double here = between_points(
        plan, at, [&](std::size_t i) { return by_time ? plan.path.points[i].time : plan.path.curve.points[i].s; });
    const double beyond = std::max(at - last.at, 0.0);  // at the last speed
    return here + (by_time ? beyond / speed(at) : beyond * speed(at));
  };
  const double longest = world::longest_of(to.over);
  to.length = std::clamp(place(from.length), world::shortest_of(to.over), longest);
  for (std::size_t c = 0; c < to.channels.size(); ++c)
    for (world::ForceKey& key : to.channels[c]) {
      const double v = speed(key.at), unit = by_time ? 1 / v : v;  // of the new axis per unit of the old one
      if (is_rate(from, c)) key.value /= unit, key.slope /= unit;
      key.at = std::min(place(key.at), longest);
      key.slope = std::clamp(key.slope / unit, -world::kMostForceSlope, world::kMostForceSlope);
      key.before = std::min(key.before * unit, longest), key.after = std::min(key.after * unit, longest);
    }
  return to;
}

ForceProgram of_other_quantity(const ForcePlan& plan) {
  constexpr double kUnits[] = {0.005, 0.005, 0.01};  // g, g, degrees per metre
  constexpr double kAngle = 0.1;                     // degrees
  ForceProgram to = plan.task.program;
  const bool bends = to.of == ForceQuantity::forces;
  to.of = bends ? ForceQuantity::curvature : ForceQuantity::forces;
  to.length = plan.task.length();
  for (std::size_t c = 0; c < to.channels.size(); ++c) {
    const bool roll = c == 2;
    double unit = kUnits[c];
    if (bends) unit = roll ? kAngle : unit * kCurvaturePerG;
    else if (roll && to.over == ForceDomain::time) unit *= plan.task.program.speed;
    std::erase_if(to.channels[c], [&](const ForceKey& key) { return key.at > plan.path.points.back().at; });
    put_keys(plan, samples_of(plan, to.of, c), static_cast<world::ForceChannel>(c), unit, to);
  }
  return to;
}

std::array<double, 3> curvature_at(const DerivedTrack& derived, std::size_t first, double distance) {
  const TrackPlace place = place_at(derived, std::min(distance, std::nextafter(derived.length, 0.0)));
  const SegmentShape& shape = derived.shape_at(place.index);
  const double t = shape.arc.parameter(place.s);
  const curve::Frame frame = frame_at(shape, place.s, t);
  const glm::dvec3 bend = curve::curvature_vector(shape.key.cubic, t);
  double angle = shape.roll.angle(place.s);
  for (std::size_t i = first; i < place.index; ++i) angle += derived.shape_at(i).roll.twist;
  return {glm::dot(bend, frame.up), glm::dot(bend, frame.left()), base::degrees(angle)};
}

}  // namespace coaster::sim
