// The plan of a force section: its path, the spans that follow it, and the required and felt values along it; and its
// keys in the other quantity, forces or curvature.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/plan/force_fit.h"
#include "sim/ride/simulated_ride.h"
#include "sim/shape/derived_track.h"
#include "world/sections.h"

namespace coaster::sim {

struct ForcePlan {
  ForceTask task;
  std::string refusal;       // why there is no track at all; empty if there is any
  ForcePath path;            // path.stopped says why it is shorter than the program
  double unmet = 0;          // g or 1/m, the most that is added to vertical or lateral: 0 if not held
  double unmet_at = 0;       // m or s from the start, where that is
  ForceFit fit;              // fit.spans.knots.front() is the track's end, with its new outgoing handle
  double length = 0;         // m
  double end_speed = 0;      // m/s
  std::uint64_t serial = 0;  // a new number for each plan that a ForcePlanCache makes
  std::size_t spans() const { return fit.spans.knots.empty() ? 0 : fit.spans.knots.size() - 1; }
  // Returns the index of the last point that is at most `at` m or s from the start.
  std::size_t point_at(double at) const;
};

// Returns a value of the plan's points, by index, at a position `at` m or s from the start: linear between points,
// constant beyond the ends, 0 without a path.
template <class Value>
double between_points(const ForcePlan& plan, double at, Value value) {
  const std::vector<ForcePoint>& points = plan.path.points;
  if (points.empty()) return 0;
  const std::size_t i = plan.point_at(at), next = std::min(i + 1, points.size() - 1);
  const double gap = points[next].at - points[i].at;
  return value(i) + (gap > 0 ? std::clamp((at - points[i].at) / gap, 0.0, 1.0) : 0.0) * (value(next) - value(i));
}

// Plans a force section. Takes about 40 us per metre.
ForcePlan plan_force(const ForceTask& task);
// Returns why a train at that speed (m/s) is too slow for forces, and what makes it faster.
std::string too_slow_text(double speed);

// Returns where a section begins: the track's end without the section and those after it. A section before it that
// completes the circuit adapts to its curvature, not the other way round.
TrackEnd start_of(const world::Document& document, const world::SectionRun& run);

// Returns where a section of which both ends stay must end: at the knot behind it, with the bend of the track that
// follows. Nothing where no track follows.
std::optional<TrackEnd> held_end(const world::Document& document, const world::SectionRun& run);

// Returns the task of a section of the document with that program: from start_of(), and to held_end() if it holds it.
ForceTask force_task(const world::Document& document, const world::SectionRun& run, const world::ForceProgram& program);

// Returns why equipment on the section does not count in the speed that it is planned for; empty if all does, or if
// speed does not shape it.
std::string uncounted_text(const world::Document& document, const world::SectionRun& run,
                           const world::ForceProgram& program);

// Returns the task of a section with that program at an end of the document's track, for its first train.
ForceTask force_task(const world::Document& document, const TrackEnd& end, const world::ForceProgram& program);

// Returns "Both ends stay: at 30.5 m riders feel 0.42 g more than the vertical keys say."; of curvature "the track
// bends 0.0103 1/m more". Empty if not held, or for less than 0.005 g.
std::string unmet_text(const ForcePlan& plan);

// Returns " at 20 m/s" if the section's spans are judged at that speed.
std::string judged_text(const world::ForceProgram& program);

// Returns "riders feel up to 0.21 g more or less than the keys say, at 12.3 m"; empty if the spans are within the
// tolerance.
std::string missed_text(const ForcePlan& plan);

// Returns "the section ends at 41.2 m: the train falls below 3 m/s there"; empty if it reaches its end.
std::string stop_text(const ForcePlan& plan);

// Caches the plans of the last tasks.
class ForcePlanCache {
 public:
  // The result is valid until the next call.
  const ForcePlan& plan(const ForceTask& task);
  // True if the task's plan is cached.
  bool has(const ForceTask& task) const;
  // Caches at least twice that many plans from now on, so that a change of all sections keeps the former ones for undo.
  void make_room(std::size_t sections);

 private:
  std::size_t most_ = 32;
  std::vector<ForcePlan> plans_;  // the newest last
  std::uint64_t serial_ = 0;
};

// Returns the program with its keys, length and handles on the other axis: they stay at the same positions of the plan.
world::ForceProgram over_other_axis(const ForcePlan& plan);

// Returns a program of curvature for one of forces, and the other way round, that leads along about the same path: keys
// stay at their positions, with what the path has there, and there are more at both ends and where the curves between
// them would be off by more than 0.005 g (of curvature at world::kCurvatureSpeed), 0.01 degrees of roll per metre or an
// angle of 0.1 degrees. The plan reaches its end.
world::ForceProgram of_other_quantity(const ForcePlan& plan);

// Returns by channel, in the units of keys of curvature, what the track has at a distance (m) from its start, which
// lies on the segment with index `first` or behind it: roll counts from that segment's start.
std::array<double, 3> curvature_at(const DerivedTrack& derived, std::size_t first, double distance);

}  // namespace coaster::sim
