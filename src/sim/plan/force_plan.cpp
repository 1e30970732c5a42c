#include "sim/plan/force_plan.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/text.h"
#include "curve/continuity.h"
#include "curve/frames.h"
#include "sim/plan/elements.h"
#include "sim/plan/force_hold.h"
#include "sim/ride/train.h"

namespace coaster::sim {
namespace {

using world::ForceOver;

constexpr double kShortestPlan = 1;  // m

}  // namespace

std::size_t ForcePlan::point_at(double at) const {
  const auto above = std::upper_bound(path.points.begin(), path.points.end(), at,
                                      [](double place, const ForcePoint& point) { return place < point.at; });
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
                               task.program.of == world::ForceOf::forces ? "forces" : "curvatures");
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
  if (const world::Cart* const cart = document.entities.find<world::Cart>(world::first_cart(document)))
    task.losses = resistance_of(document, cart->mass), task.cars = cart->cars, task.spacing = cart->spacing;
  return task;
}

std::string unmet_text(const ForcePlan& plan) {
  const world::ForceProgram& program = plan.task.program;
  const bool bends = program.of == world::ForceOf::curvature;
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
  return program.of == world::ForceOf::curvature ? fmt::format(" at {} m/s", base::to_text(world::kCurvatureSpeed))
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

bool ForceMemo::has(const ForceTask& task) const {
  return std::any_of(plans_.begin(), plans_.end(), [&](const ForcePlan& plan) { return plan.task == task; });
}

void ForceMemo::make_room(std::size_t sections) { most_ = std::max(most_, 2 * sections); }

const ForcePlan& ForceMemo::plan(const ForceTask& task) {
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

}  // namespace coaster::sim
