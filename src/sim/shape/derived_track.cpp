// Positions and frames along the derived track.
#include "sim/shape/derived_track.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/bits.h"
#include "base/cancellable_job.h"
#include "base/check.h"
#include "base/portable_math.h"
#include "curve/carried_frame.h"
#include "sim/shape/shape_distance.h"

namespace coaster::sim {
namespace {

void build_shape(const ShapeKey& key, SegmentShape& shape) {
  shape.key = key;
  shape.curve = curve::prepare(key.cubic);
  shape.arc = curve::ArcLengthMap(key.cubic);
  build_frames(shape);
}

ShapeKey key_of(const world::Document& document, const world::Segment& segment) {
  const world::Knot &from = world::knot(document, segment.from), &to = world::knot(document, segment.to);
  return {{from.position, world::out_handle(from), world::in_handle(to), to.position},
          from.up,
          to.up,
          segment.turns,
          from.tangent,
          to.tangent,
          from.spin,
          to.spin,
          world::rails_height(document),
          document.kind};
}

// The work on one segment, and its cost.
struct SegmentRebuild {
  std::size_t index = 0;
  SegmentShape* shape = nullptr;
  ShapeKey key;
  bool reshape = false, measure = false, evaluate = false, refit = false;
  double seconds = 0;  // in the evaluator's polyline function
};

void work_on(const world::Evaluation& evaluation, const Clock& clock, Polyline& polyline, SegmentRebuild& job) {
  SegmentShape& shape = *job.shape;
  if (job.reshape) build_shape(job.key, shape);
  if (job.measure) shape.measured_length = base::row_of(evaluation.arc_length).length(job.key.cubic, evaluation.steps);
  if (!job.evaluate) return;
  shape.polyline_key = {evaluation.evaluator, evaluation.steps};
  const double before = clock ? clock() : 0.0;
  evaluate_polyline(shape, polyline);
  if (clock) job.seconds = clock() - before;
  shape.deviation = deviation_of(shape.key.cubic, polyline.points);
}

// True if every segment must be compared or rebuilt.
bool all_anew(const world::Document& document, const world::Evaluation& evaluation, bool moved,
              const DerivedTrack& derived) {
  return moved || derived.made.knots.size() != document.track.knots.size() ||
         !(derived.made.evaluation == evaluation) || derived.made.rails != world::rails_height(document) ||
         derived.made.kind != document.kind;
}

// Calls visit(i) for each knot that differs from made.knots[i], and copies it there. If the pool has the knots in the
// track's order, as after loading, skips blocks that are equal bit by bit.
void take_knots(const world::Document& document, DerivedTrack& derived, const auto& visit) {
  constexpr std::size_t kBlock = 64;
  const auto& pool = document.entities.pool<world::Knot>();
  const std::vector<world::Entity>& order = document.track.knots;
  std::vector<world::Knot>& copies = derived.made.knots;
  copies.resize(order.size());
  const bool in_order = base::same_bits(pool.entities(), order);
  for (std::size_t begin = 0; begin < order.size(); begin += kBlock) {
    const std::size_t end = std::min(begin + kBlock, order.size());
    if (in_order && base::same_bits(std::span(pool.items()).subspan(begin, end - begin),
                                    std::span<const world::Knot>(copies).subspan(begin, end - begin)))
      continue;
    derived.compared += end - begin;
    for (std::size_t i = begin; i < end; ++i) {
      const world::Knot& knot = in_order ? pool.items()[i] : pool.get(order[i]);
      if (!(copies[i] == knot)) visit(i);
      base::copy_bits(knot, copies[i]);
    }
  }
}

// Records the inputs of the segments. Returns the indices of those whose inputs changed, ascending.
std::vector<std::size_t> take_changes(const world::Document& document, bool all, DerivedTrack& derived) {
  DerivedTrack::BuiltInputs& made = derived.made;
  const std::size_t count = derived.order.size();
  std::vector<std::size_t> changed;
  take_knots(document, derived, [&](std::size_t i) {
    if (i < count) changed.push_back(i);
    if (i > 0) changed.push_back(i - 1);
    else if (document.track.closed && count > 0) changed.push_back(count - 1);
  });
  made.turns.resize(count), made.fitted.resize(count);
  const auto& segments = document.entities.pool<world::Segment>();
  const bool in_order = base::same_bits(segments.entities(), derived.order);
  for (std::size_t i = 0; i < count; ++i) {
    const std::int32_t turns = (in_order ? segments.items()[i] : segments.get(derived.order[i])).turns;
    if (std::exchange(made.turns[i], turns) != turns) changed.push_back(i);
  }
  if (const auto& equipment = document.entities.pool<world::Equipment>(); all || !(made.equipment == equipment)) {
    made.equipment = equipment;
    for (std::size_t i = 0; i < count; ++i) {
      const world::Equipment* const found = equipment.find(derived.order[i]);
      const auto fitted = found ? std::optional(found->kind) : std::nullopt;
      if (std::exchange(made.fitted[i], fitted) != fitted) changed.push_back(i);
    }
  }
  if (all) {
    changed.resize(count);
    std::iota(changed.begin(), changed.end(), std::size_t{0});
    return changed;
  }
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  return changed;
}

// Returns the work to be done; the shapes stay at their addresses.
std::vector<SegmentRebuild> jobs_of(const world::Document& document, std::span<const std::size_t> changed,
                                    const world::Evaluation& evaluation, DerivedTrack& derived) {
  const bool on_processor = base::row_of(evaluation.evaluator).evaluated_by == curve::EvaluatedBy::processor;
  const PolylineKey polyline{evaluation.evaluator, evaluation.steps};
  std::vector<SegmentRebuild> jobs;
  for (const std::size_t i : changed) {
    const world::Entity entity = derived.order[i];
    SegmentShape& shape = derived.segments.get(entity);
    SegmentRebuild job{i, &shape, key_of(document, world::segment(document, entity))};
    job.reshape = shape.shape_build == 0 || !(shape.key == job.key);
    job.measure = job.reshape || shape.measured_by != evaluation.arc_length || shape.measured_steps != evaluation.steps;
    job.evaluate = on_processor && (job.reshape || !(shape.polyline_key == polyline));
    job.refit = shape.fitted != derived.made.fitted[i];
    shape.fitted = derived.made.fitted[i];
    shape.measured_by = evaluation.arc_length, shape.measured_steps = evaluation.steps;
    if (!on_processor) shape.polyline_key = {}, shape.deviation = 0;
    jobs.push_back(job);
  }
  return jobs;
}

// Numbers the rebuilds and sums over the segments in the track's order, independent of the order of the work.
void gather(std::span<const SegmentRebuild> jobs, DerivedTrack& derived) {
  const std::size_t count = derived.order.size();
  DerivedTrack::BuiltInputs& made = derived.made;
  for (auto* const column : {&made.lengths, &made.twists, &made.measured_lengths, &made.deviations})
    column->resize(count);
  for (const SegmentRebuild& job : jobs) {
    SegmentShape& shape = *job.shape;
    if (job.reshape) {
      shape.shape_build = ++derived.last_build;
      made.changes.push_back({shape.shape_build, job.index});
    }
    if (job.evaluate) {
      shape.polyline_build = ++derived.last_build;
      derived.evaluated_vertices += derived.steps + 1;
      derived.evaluation_seconds += job.seconds;
    }
    if (job.reshape || job.evaluate) ++derived.rebuilds;
    made.lengths[job.index] = shape.arc.length(), made.twists[job.index] = shape.roll.twist;
    made.measured_lengths[job.index] = shape.measured_length, made.deviations[job.index] = shape.deviation;
  }
  derived.starts.resize(count + 1), derived.twists.resize(count + 1);
  double start = 0, twist = 0, measured = 0, deviation = 0;
  for (std::size_t i = 0; i < count; ++i) {
    derived.starts[i] = start, derived.twists[i] = twist;
    start += made.lengths[i], twist += made.twists[i], measured += made.measured_lengths[i];
    deviation = std::max(deviation, made.deviations[i]);
  }
  derived.starts.back() = start, derived.twists.back() = twist;
  derived.measured_length = measured, derived.deviation = deviation;
  derived.vertices = static_cast<std::int64_t>(count) * (derived.steps + 1);
  derived.length = derived.starts.back();
}

// Refits the tree to new cubics. Rebuilds it if segments were added, removed or reordered, or most of them moved.
void update_tree(bool reordered, std::span<const SegmentRebuild> reshaped, DerivedTrack& derived) {
  if (!reordered && reshaped.empty()) return;
  if (reordered || reshaped.size() > derived.order.size() / 2) {
    std::vector<curve::Cubic> cubics;
    cubics.reserve(derived.order.size());
    for (const world::Entity e : derived.order) cubics.push_back(derived.shape(e).key.cubic);
    return build_tree(std::move(cubics), derived.tree);
  }
  std::vector<std::size_t> indices;
  for (const SegmentRebuild& job : reshaped)
    indices.push_back(job.index), derived.tree.cubics[job.index] = job.key.cubic;
  refit_tree(indices, derived.tree);
}

}  // namespace

void evaluate_polyline(const SegmentShape& shape, Polyline& polyline) {
  polyline.points.clear(), polyline.tangents.clear();
  if (shape.polyline_key.steps == 0) return;
  polyline.points.resize(static_cast<std::size_t>(shape.polyline_key.steps) + 1);
  polyline.tangents.resize(polyline.points.size());
  base::row_of(shape.polyline_key.evaluator).polyline(shape.curve, polyline.points, polyline.tangents);
}

std::optional<std::span<const ShapeChange>> DerivedTrack::changes_since(std::uint64_t build) const {
  if (build < made.known_since || build > last_build) return std::nullopt;
  const auto first = std::ranges::upper_bound(made.changes, build, {}, &ShapeChange::build);
  return std::span(made.changes).subspan(static_cast<std::size_t>(first - made.changes.begin()));
}

void derive(const world::Document& document, const world::Settings& settings, const Clock& clock, DerivedTrack& derived,
            unsigned workers) {
  const world::Evaluation& evaluation = *settings.evaluation;
  const bool reordered = !base::same_bits(derived.order, document.track.segments);
  const bool moved = reordered || derived.closed != document.track.closed;
  const bool all = all_anew(document, evaluation, moved, derived);
  if (reordered) {
    derived.order = document.track.segments;
    derived.segments.keep_those_of(document.entities.pool<world::Segment>());
    derived.segments.reserve(derived.order.size());
    for (const world::Entity e : derived.order) derived.segments.obtain(e);
  }
  derived.closed = document.track.closed;
  derived.evaluated_by = base::row_of(evaluation.evaluator).evaluated_by;
  derived.steps = evaluation.steps;
  derived.compared = 0, derived.rebuilds = 0, derived.evaluation_seconds = 0, derived.evaluated_vertices = 0;
  derived.made.evaluation = evaluation, derived.made.rails = world::rails_height(document);
  derived.made.kind = document.kind;

  std::vector<SegmentRebuild> jobs = jobs_of(document, take_changes(document, all, derived), evaluation, derived);
  constexpr std::size_t kPart = 64;  // segments
  base::in_parts(jobs.size(), kPart, workers, [&](std::size_t begin, std::size_t end) {
    Polyline polyline;
    for (std::size_t i = begin; i < end && !base::interrupted(); ++i) work_on(evaluation, clock, polyline, jobs[i]);
  });
  gather(jobs, derived);
  const bool unlisted = moved || std::ranges::any_of(jobs, &SegmentRebuild::refit);
  if (unlisted || derived.made.changes.size() > derived.order.size()) {
    derived.made.changes.clear();
    derived.made.known_since = unlisted ? ++derived.last_build : derived.last_build;
  }
  std::erase_if(jobs, [](const SegmentRebuild& job) { return !job.reshape; });
  update_tree(reordered, jobs, derived);
}

Roll roll_of(const world::Document& document, world::Entity segment) {
  SegmentShape shape;
  build_shape(key_of(document, world::segment(document, segment)), shape);
  return shape.roll;
}

DerivedTrack shapes_of(const world::Document& document) {
  world::Settings settings;
  settings.evaluation->steps = 1;
  DerivedTrack derived;
  derive(document, settings, {}, derived);
  return derived;
}

namespace {

using glm::dvec3;

using Frames = std::array<curve::Frame, kFrameIntervals + 1>;

double at_uniform(int i) { return static_cast<double>(i) / kFrameIntervals; }

// Finds the intervals that need several steps. Replaces the frames unless those of single steps are within the bound.
void refine(const curve::Cubic& cubic, Frames& frames, std::uint32_t& tight) {
  constexpr double kSpare = 0.25 * curve::kFrameBound;  // for the step from a stored frame to a place in its interval
  const curve::CoefficientsD c = curve::coefficients_d(cubic);
  double off = 0;
  for (int i = 0; i < kFrameIntervals; ++i) {
    const double error = curve::step_error(c, at_uniform(i), 1.0 / kFrameIntervals);
    off += error;
    if (!(error <= kSpare)) tight |= 1u << i;
  }
  if (curve::cusps(cubic).count > 0) tight = ~0u;
  if (tight == 0 && off <= 0.5 * curve::kFrameBound) return;
  off = 0;
  Frames fine = frames;
  for (int i = 0; i < kFrameIntervals; ++i) {
    fine[i + 1] = curve::carried(cubic, fine[i], at_uniform(i), at_uniform(i + 1));
    off = std::max(off, glm::length(fine[i + 1].up - frames[i + 1].up));
  }
  if (off > curve::kFrameBound - kSpare) frames = fine;
}

}  // namespace

void build_frames(SegmentShape& shape) {
  const ShapeKey& key = shape.key;
  const curve::Cubic& c = key.cubic;
  Frames frames;
  dvec3 last = curve::point(c, 0.0);
  const dvec3 start = curve::unit_tangent(c, 0.0);
  frames[0] = {start, curve::perpendicular(start, dvec3(key.up_from))};
  for (int i = 1; i <= kFrameIntervals; ++i) {
    const double t = at_uniform(i);
    const dvec3 here = curve::point(c, t);
    frames[i] = curve::transport(frames[i - 1], last, here, curve::unit_tangent(c, t));
    last = here;
  }
  shape.tight = 0;
  if (!(curve::steps_error(c, kFrameIntervals) <= 0.5 * curve::kFrameBound)) refine(c, frames, shape.tight);
  const curve::Frame& end = frames.back();
  const dvec3 wanted = curve::perpendicular(end.forward, dvec3(key.up_to));
  const double twist = curve::signed_angle(end.up, wanted, end.forward) + key.turns * 2.0 * base::kPi;
  shape.roll = {shape.arc.length(), twist, key.spin_from, key.spin_to};
  for (int i = 0; i <= kFrameIntervals; ++i) {
    dvec3& up = shape.ups[i];
    up = frames[i].up;
    if (i == 0 || !(shape.roll.length > 0)) continue;
    const double angle = i == kFrameIntervals ? twist : shape.roll.angle(shape.arc.distance(at_uniform(i)));
    up = curve::rotate(up, frames[i].forward, angle);
  }
}

TrackPlace place_at(const DerivedTrack& derived, double distance) {
  COASTER_CHECK(!derived.order.empty(), "a place needs a segment");
  distance = within_lap(distance, derived.length, derived.closed);
  if (derived.closed && distance >= derived.length) distance = 0;
  distance = std::clamp(distance, 0.0, derived.length);
  const auto above = std::upper_bound(derived.starts.begin(), derived.starts.end(), distance);
  std::size_t index = static_cast<std::size_t>(above - derived.starts.begin());
  index = std::min(index == 0 ? 0 : index - 1, derived.order.size() - 1);
  return {index, distance - derived.starts[index]};
}

bool has_cusp(const SegmentShape& shape) { return shape.tight != 0 && curve::cusps(shape.key.cubic).count > 0; }

bool has_cusp(const DerivedTrack& derived) {
  return std::ranges::any_of(derived.order, [&](world::Entity e) { return has_cusp(derived.shape(e)); });
}

curve::Frame frame_at(const SegmentShape& shape, double s) { return frame_at(shape, s, shape.arc.parameter(s)); }

curve::Frame frame_at(const SegmentShape& shape, double s, double t) {
  const curve::Cubic& c = shape.key.cubic;
  const double length = shape.arc.length();
  if (!(s > 0)) return shape.frame(0);
  if (s >= length) return shape.frame(kFrameIntervals);
  const int below = std::min(static_cast<int>(t * kFrameIntervals), kFrameIntervals - 1);
  const double t0 = at_uniform(below);
  const double rolled = shape.roll.angle(shape.arc.distance(t0));
  curve::Frame frame = shape.frame(below);
  if ((shape.tight >> below & 1u) != 0) {
    // Without the roll, whose sense a cusp reverses with the direction of travel.
    frame.up = curve::rotate(frame.up, frame.forward, -rolled);
    frame = curve::carried(c, frame, t0, t);
    frame.up = curve::rotate(frame.up, frame.forward, shape.roll.angle(s));
    return frame;
  }
  frame = curve::transport(frame, curve::point(c, t0), curve::point(c, t), curve::unit_tangent(c, t));
  frame.up = curve::rotate(frame.up, frame.forward, shape.roll.angle(s) - rolled);
  return frame;
}

}  // namespace coaster::sim
