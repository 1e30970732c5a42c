// The laboratory's pictures over the scene. Only visible track is processed, in steps of a few pixels, so the work does
// not grow with invisible detail.
#include "view/overlay_detail.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/portable_math.h"
#include "curve/bernstein.h"
#include "curve/frames.h"
#include "sim/shape/rails.h"
#include "sim/study/evaluator_benchmark.h"
#include "world/evaluation_settings.h"
#include "world/laboratory_settings.h"

namespace coaster::view {

PixelScale::PixelScale(const View& view)
    : eye_(view.eye),
      forward_(line_of_sight(view)),
      focal_px_(0.5 * static_cast<double>(view.viewport.height) * static_cast<double>(view.projection[1][1])),
      parallel_(view.parallel > 0) {}

double PixelScale::operator()(glm::dvec3 at) const {
  if (parallel_) return focal_px_;
  const double depth = glm::dot(at - eye_, forward_);
  return depth > 0 ? focal_px_ / depth : 0;
}

std::optional<double> angle_on_ring(const Ray& ray, glm::dvec3 centre, glm::dvec3 axis, glm::dvec3 zero,
                                    double radius) {
  constexpr double kEdgeOn = 0.05;  // cosine between the ray and the axis
  if (std::abs(glm::dot(glm::normalize(glm::dvec3(ray.direction)), axis)) < kEdgeOn) return std::nullopt;
  const auto hit = meet_plane(ray, glm::vec3(centre), glm::vec3(axis));
  if (!hit) return std::nullopt;
  const glm::dvec3 to = glm::dvec3(*hit) - centre;
  if (!(glm::length(to) > 1e-3 * radius)) return std::nullopt;
  return curve::signed_angle(zero, to, axis);
}

std::vector<world::Entity> selected_segments(const world::Document& document, world::Entity selected) {
  if (document.entities.find<world::Segment>(selected)) return {selected};
  if (!document.entities.find<world::Knot>(selected)) return {};
  const world::KnotSegments at = world::neighbours(document, selected);
  std::vector<world::Entity> out{at.before, at.after};
  std::erase(out, world::kNone);
  return out;
}

glm::dvec3 over_rails(const sim::DerivedTrack& derived, double distance, double height) {
  const sim::TrackPlace place = sim::place_at(derived, distance);
  const sim::SegmentShape& shape = derived.shape(derived.order[place.index]);
  return sim::rails_at(shape, place.s) + height * sim::frame_at(shape, place.s).up;
}

void add_arrow(glm::dvec3 from, glm::dvec3 direction, double length, const View& view, float width_px,
               std::uint32_t rgba, Overlay& overlay) {
  constexpr double kBarb = 0.3, kHalfWidth = 0.14,
                   kAlong = 0.05;  // of the length; sine of the smallest angle to the line of sight
  const glm::dvec3 tip = from + length * direction;
  add_line(from, tip, width_px, rgba, overlay);
  const glm::dvec3 to_eye = view.parallel > 0 ? -glm::dvec3(line_of_sight(view)) : glm::dvec3(view.eye) - from;
  const glm::dvec3 side = glm::cross(direction, to_eye);
  const double across = glm::length(side);
  if (!(across > kAlong * glm::length(to_eye))) return;
  const glm::dvec3 back = tip - kBarb * length * direction, out = side * (kHalfWidth * length / across);
  add_line(tip, back + out, width_px, rgba, overlay);
  add_line(tip, back - out, width_px, rgba, overlay);
}

void add_sign(glm::dvec3 at, std::uint32_t rgba, std::span<const glm::dvec2> glyph, const View& view, float scale,
              Overlay& overlay) {
  constexpr std::uint32_t kInk = 0x1b1f27ff;
  const double px_per_metre = PixelScale(view)(at);
  if (!(px_per_metre > 0)) return;
  add_disc(at, 11 * scale, rgba, overlay);
  // Uses dots, because marks are drawn over lines.
  const glm::dvec3 right(right_of(view)), up(top_of(view));
  const double metres = static_cast<double>(scale) / px_per_metre;
  for (const glm::dvec2 dot : glyph) add_disc(at + metres * (dot.x * right + dot.y * up), 1.5f * scale, kInk, overlay);
}

namespace {

// A segment that may be visible; segments outside the picture are not listed.
struct SeenSegment {
  std::size_t index = 0;    // into derived.order
  double px_per_metre = 0;  // at its nearest point
  double length_px = 0;
};
std::vector<SeenSegment> seen_segments(const sim::DerivedTrack& derived, const View& view) {
  constexpr float kNearest = 1;  // m: closer track gets no more detail
  const glm::vec3 right = right_of(view), up = top_of(view), forward = line_of_sight(view);
  const float fx = view.projection[0][0], fy = view.projection[1][1];
  // A sphere is outside if it lies beyond a side plane of the frustum.
  const float side_x = std::sqrt(1 + fx * fx), side_y = std::sqrt(1 + fy * fy);
  const float focal_px = 0.5f * view.viewport.height * fy;
  std::vector<SeenSegment> seen;
  for (std::size_t i = 0; i < derived.order.size(); ++i) {
    const sim::SegmentShape& shape = derived.shape(derived.order[i]);
    const auto [low, high] = curve::control_box(shape.key.cubic);
    const float radius = 0.5f * glm::length(high - low);
    const glm::vec3 from_eye = 0.5f * (low + high) - view.eye;
    if (view.parallel > 0) {
      if (std::abs(glm::dot(from_eye, right)) * fx > 1 + radius * fx ||
          std::abs(glm::dot(from_eye, up)) * fy > 1 + radius * fy)
        continue;
      seen.push_back({i, focal_px, static_cast<double>(focal_px) * shape.arc.length()});
      continue;
    }
    const float depth = glm::dot(from_eye, forward);
    if (depth < -radius || std::abs(glm::dot(from_eye, right)) * fx - depth > radius * side_x ||
        std::abs(glm::dot(from_eye, up)) * fy - depth > radius * side_y)
      continue;
    const double px_per_metre = static_cast<double>(focal_px / std::max(depth - radius, kNearest));
    seen.push_back({i, px_per_metre, px_per_metre * shape.arc.length()});
  }
  return seen;
}

// Adds a broad line over the rails between two distances along the track, m, in `pieces`.
void add_band(const sim::DerivedTrack& derived, double from, double to, int pieces, std::uint32_t rgba, float scale,
              Overlay& overlay) {
  constexpr double kOverRails = 0.35;  // m
  const auto at = [&](double distance) { return over_rails(derived, distance, kOverRails); };
  add_curve(at, from, to, pieces, 5.0f * scale, rgba, overlay);
}

// Returns the number of multiples of `step` in [from, to).
int multiples(double from, double to, double step) {
  return static_cast<int>(std::ceil(to / step) - std::ceil(from / step));
}

// Returns the power of two metres that is at least `px` pixels long on the segment.
double step_of(const SeenSegment& seen, double px) { return std::exp2(std::ceil(std::log2(px / seen.px_per_metre))); }

// Returns the least distance in pixels, from `px` on by doubling, at which `count` of all segments is at most `most`.
template <class Count>
double fitting_distance(std::span<const SeenSegment> seen, double px, int most, Count count) {
  for (int doubling = 0; doubling < 24; ++doubling, px *= 2) {
    std::int64_t all = 0;
    for (const SeenSegment& one : seen) all += count(one, px);
    if (all <= most) break;
  }
  return px;
}

constexpr int kFewestTeeth = 8, kMostTeeth = 64;

// Sizes of conflicts and folds.
constexpr int kPieces = 24;    // per stretch
constexpr double kOver = 1.6;  // m, height of a sign

void add_exclamation(glm::dvec3 place, const View& view, float scale, Overlay& overlay) {
  constexpr std::array<glm::dvec2, 6> kGlyph{{{0, 4.8}, {0, 3.5}, {0, 2.2}, {0, 0.9}, {0, -0.4}, {0, -4.2}}};  // px
  add_sign(place + glm::dvec3(0, kOver, 0), kConflictColour, kGlyph, view, scale, overlay);
}

template <class Found>
std::span<const Found> first_of(std::span<const Found> found) {
  return found.first(std::min(found.size(), static_cast<std::size_t>(kMaxConflicts)));
}

// Returns the number of teeth of a segment, both ends included. Segments smaller than `px` on screen share teeth: one
// at the start of each segment that contains a multiple of the step.
int teeth_of(const sim::DerivedTrack& derived, const SeenSegment& seen, double px) {
  if (seen.length_px < px)
    return multiples(derived.starts[seen.index], derived.starts[seen.index + 1], step_of(seen, px)) > 0 ? 1 : 0;
  return std::clamp(static_cast<int>(seen.length_px / px), kFewestTeeth, kMostTeeth) + 1;
}

// Returns -kappa N times the scale: (B' x (B' x B'')) / |B'|^4, at most kMaxTooth long; nothing where there is no
// curvature.
std::optional<glm::dvec3> tooth_at(const curve::Cubic& cubic, double t, double scale) {
  const glm::dvec3 d1 = curve::derivative(cubic, t), d2 = curve::second_derivative(cubic, t);
  const double square = glm::dot(d1, d1);
  if (!curve::curvature_if_any(cubic, t)) return std::nullopt;
  if (!(square > 0)) return glm::dvec3(0);
  const glm::dvec3 tooth = glm::cross(d1, glm::cross(d1, d2)) * (scale / (square * square));
  const double length = glm::length(tooth);
  if (length <= kMaxTooth) return tooth;
  return std::isfinite(length) ? tooth * (kMaxTooth / length) : glm::dvec3(0);
}

constexpr double kMaxOffset = 1e4;  // m, limit of a magnified error

// Returns the segments whose rounding is shown, with at most kMaxRoundingVertices together.
std::vector<world::Entity> rounded_segments(const world::Document& document, const sim::DerivedTrack& derived,
                                            const world::Settings& settings) {
  const std::vector<world::Entity> selected = selected_segments(document, settings.selected);
  if (!selected.empty()) return selected;
  const auto most = static_cast<std::size_t>(kMaxRoundingVertices / (settings.evaluation->steps + 1));
  return {derived.order.begin(),
          derived.order.begin() + static_cast<std::ptrdiff_t>(std::min(most, derived.order.size()))};
}

void add_rounding(const sim::SegmentShape& shape, const world::Settings& settings, float scale, Overlay& overlay) {
  constexpr std::size_t kWhiskers = 64;
  const sim::Rounding r =
      sim::rounding(shape.curve, base::row_of(settings.evaluation->evaluator), settings.evaluation->steps);
  const std::size_t last = r.exact.size() - 1;
  std::vector<glm::dvec3> moved(r.exact.size());
  for (std::size_t i = 0; i <= last; ++i) {
    glm::dvec3 offset = settings.lab->magnification * r.error[i];
    const double size = glm::length(offset);
    if (size > kMaxOffset) offset *= kMaxOffset / size;
    moved[i] = r.exact[i] + offset;
  }
  const std::size_t every = last / kWhiskers + 1;
  for (std::size_t i = every; i < last; i += every)
    add_line(r.exact[i], moved[i], 1.0f * scale, faded(kRoundingColour, 0x60), overlay);
  for (std::size_t i = 0; i + 1 < last; ++i) add_line(moved[i], moved[i + 1], 1.75f * scale, kRoundingColour, overlay);
  add_line(moved[last - 1], moved[last], 3.0f * scale, kSeamColour, overlay);
  if (last > 1) add_disc(moved[last - 1], 3.5f * scale, kSeamColour, overlay);
}

// Appends a layer's lines, each over a dark rim, so that they read on sky, ground and rails. Layers with thousands of
// lines have no rims.
void append_rimmed(const Overlay& layer, float scale, Overlay& overlay) {
  constexpr std::size_t kFew = 2500;
  constexpr std::uint32_t kDiscRimColour = 0x1b1f2778;
  constexpr float kThin = 1.5f, kDiscRim = 2.0f;  // px at scale 1: lines are rimmed from this width on; rim of discs
  if (layer.lines.size() <= kFew)
    for (const Line& one : layer.lines)
      if (one.width_px >= kThin * scale && (one.rgba & 0xffu) == 0xffu)
        overlay.lines.push_back({one.from, one.to, one.width_px + kDiscRim * scale, kDiscRimColour});
  overlay.lines.insert(overlay.lines.end(), layer.lines.begin(), layer.lines.end());
  overlay.marks.insert(overlay.marks.end(), layer.marks.begin(), layer.marks.end());
}

// Adds a sign with a peak above each joint whose jolt exceeds sim::kJoltLimit.
void add_jolts(const sim::DerivedTrack& derived, std::span<const sim::Jolt> jolts, const View& view, float scale,
               Overlay& overlay) {
  constexpr std::array<glm::dvec2, 9> kPeak{
      {{-6, -3}, {-4, -3}, {-2.6, -1.2}, {-1.3, 1.4}, {0, 4}, {1.3, 1.4}, {2.6, -1.2}, {4, -3}, {6, -3}}};  // px
  int left = kMaxJolts;
  for (std::size_t i = 0; i < jolts.size() && left > 0; ++i) {
    if (!(jolts[i].total > sim::kJoltLimit)) continue;
    --left;
    add_sign(over_rails(derived, derived.starts.at(i), kOver), kLimitColour, kPeak, view, scale, overlay);
  }
}

// Adds folds of the rails, or tight bends: a broad line and a sign over each.
void add_folds(const sim::DerivedTrack& derived, std::span<const sim::Fold> folds, const View& view, float scale,
               Overlay& overlay) {
  const auto shown = first_of(folds);
  for (const sim::Fold& fold : shown) add_band(derived, fold.from, fold.to, kPieces, kConflictColour, scale, overlay);
  for (const sim::Fold& fold : shown) add_exclamation(glm::dvec3(fold.place), view, scale, overlay);
}

// Adds conflicts: a broad line over both stretches, and a sign between their narrowest points.
void add_conflicts(const sim::DerivedTrack& derived, std::span<const sim::Conflict> conflicts, const View& view,
                   float scale, Overlay& overlay) {
  const auto shown = first_of(conflicts);
  for (const sim::Conflict& conflict : shown) {
    add_band(derived, conflict.from, conflict.to, kPieces, kConflictColour, scale, overlay);
    add_band(derived, conflict.other_from, conflict.other_to, kPieces, kConflictColour, scale, overlay);
    add_line(conflict.at_place, conflict.other_place, 3.0f * scale, kConflictColour, overlay);
  }
  for (const sim::Conflict& conflict : shown)
    add_exclamation(0.5 * (glm::dvec3(conflict.at_place) + glm::dvec3(conflict.other_place)), view, scale, overlay);
}

// Adds a broad line over each stretch under water, and a sign where it is deepest.
void add_flooded(const sim::DerivedTrack& derived, std::span<const sim::FloodedTrack> flooded, const View& view,
                 float scale, Overlay& overlay) {
  for (const sim::FloodedTrack& stretch : first_of(flooded)) {
    add_band(derived, stretch.from, stretch.to, kPieces, kConflictColour, scale, overlay);
    add_exclamation(glm::dvec3(stretch.place), view, scale, overlay);
  }
}

}  // namespace

void add_comb(const sim::DerivedTrack& derived, const world::Settings& settings, const View& view, Overlay& overlay) {
  const float scale = mark_scale(settings, view);
  const std::vector<SeenSegment> seen = seen_segments(derived, view);
  const auto count = [&](const SeenSegment& one, double px) { return teeth_of(derived, one, px); };
  const double px = fitting_distance(seen, 9.0 * static_cast<double>(scale), kMaxTeeth, count);
  glm::dvec3 before(0);  // tip of the previous tooth
  bool goes_on = false;  // the envelope continues over small segments
  std::size_t next = 0;
  for (const SeenSegment& one : seen) {
    const curve::Cubic& cubic = derived.shape(derived.order[one.index]).key.cubic;
    const int teeth = count(one, px);
    goes_on = goes_on && one.index == next && teeth <= 1;
    next = one.index + 1;
    for (int i = 0; i < teeth; ++i) {
      const double t = teeth > 1 ? static_cast<double>(i) / (teeth - 1) : 0;
      const std::optional<glm::dvec3> tooth = tooth_at(cubic, t, settings.lab->comb_scale);
      if (!tooth) {
        goes_on = false;
        continue;
      }
      const glm::dvec3 root = curve::point(cubic, t), tip = root + *tooth;
      add_line(root, tip, 1.0f * scale, faded(kCombColour, 0xb0), overlay);
      if (goes_on) add_line(before, tip, 2.25f * scale, kCombColour, overlay);
      before = tip;
      goes_on = true;
    }
    goes_on = goes_on && teeth <= 1;
  }
}

void add_frames(const sim::DerivedTrack& derived, const world::Settings& settings, const View& view, Overlay& overlay) {
  constexpr double kApartPx = 72, kArrowPx = 34;
  const float scale = mark_scale(settings, view);
  const double ui = static_cast<double>(scale);
  const PixelScale pixels(view);
  const std::vector<SeenSegment> seen = seen_segments(derived, view);
  const auto count = [&](const SeenSegment& one, double px) {
    return multiples(derived.starts[one.index], derived.starts[one.index + 1], step_of(one, px));
  };
  const double px = fitting_distance(seen, kApartPx * ui, kMaxFrames, count);
  for (const SeenSegment& one : seen) {
    const sim::SegmentShape& shape = derived.shape(derived.order[one.index]);
    const double start = derived.starts[one.index], step = step_of(one, px), first = std::ceil(start / step);
    for (int i = 0; i < count(one, px); ++i) {
      const double s = (first + i) * step - start;
      const glm::dvec3 at = curve::point(shape.key.cubic, shape.arc.parameter(s));
      const double px_per_metre = pixels(at);
      if (!(px_per_metre > 0)) continue;
      const sim::TrackFrame f = sim::track_frame(derived, settings.frames, one.index, s);
      const double length = kArrowPx * ui / px_per_metre;
      const auto paint = [&](std::uint32_t rgba) { return f.defined ? rgba : faded(rgba, 0x50); };
      add_arrow(at, f.frame.forward, length, view, 2.25f * scale, paint(kTangentColour), overlay);
      add_arrow(at, f.frame.up, length, view, 2.25f * scale, paint(kNormalColour), overlay);
      add_arrow(at, glm::cross(f.frame.forward, f.frame.up), length, view, 2.25f * scale, paint(kBinormalColour),
                overlay);
    }
  }
}

void add_spans(const sim::DerivedTrack& derived, std::span<const sim::Overload> spans, float scale, Overlay& overlay) {
  constexpr double kPiece = 1.0;  // m
  if (derived.order.empty()) return;
  int left = kMaxSpanPieces;
  for (const sim::Overload& span : spans) {
    double length = span.to_distance - span.from_distance;
    if (length < 0 && derived.closed) length += derived.length;  // across the closing joint
    const int pieces = std::min(left, std::max(1, static_cast<int>(std::ceil(std::abs(length) / kPiece))));
    left -= pieces;
    add_band(derived, span.from_distance, span.from_distance + length, pieces, kLimitColour, scale, overlay);
    if (left <= 0) return;
  }
}

void add_breaks(const sim::DerivedTrack& derived, std::span<const sim::FrenetBreak> breaks, const View& view,
                float scale, Overlay& overlay) {
  constexpr int kLines = 12;
  constexpr double kCrossPx = 7, kNormalPx = 40, kBeside = 0.02;
  const PixelScale pixels(view);
  const glm::dvec3 right(right_of(view)), up(top_of(view));
  int drawn = 0;
  for (const sim::FrenetBreak& at : breaks) {
    const sim::SegmentShape* const shape = derived.segments.find(at.segment);
    if (shape == nullptr) continue;
    const curve::Cubic& cubic = shape->key.cubic;
    const glm::dvec3 place = curve::point(cubic, at.t);
    const double px_per_metre = pixels(place);
    if (at.kind == sim::FrenetBreak::Kind::flip && !(px_per_metre > 0)) continue;
    if (++drawn > kMaxBreaks) return;
    if (at.kind == sim::FrenetBreak::Kind::undefined) {
      const auto point = [&](double t) { return curve::point(cubic, t); };
      add_curve(point, at.t, at.t_end, kLines, 5.0f * scale, faded(kBreakColour, 0xc0), overlay);
      continue;
    }
    const double size = kCrossPx * static_cast<double>(scale) / px_per_metre,
                 length = kNormalPx * static_cast<double>(scale) / px_per_metre;
    for (const double beside : {-kBeside, kBeside}) {
      const double t = std::clamp(at.t + beside, 0.0, 1.0);
      if (const auto frame = curve::frenet(cubic, t))
        add_arrow(curve::point(cubic, t), frame->normal, length, view, 2.0f * scale, kNormalColour, overlay);
    }
    add_line(place - size * (right + up), place + size * (right + up), 3.0f * scale, kBreakColour, overlay);
    add_line(place - size * (right - up), place + size * (right - up), 3.0f * scale, kBreakColour, overlay);
  }
}

void add_construction(const sim::SegmentShape& shape, double t, const View& view, float scale, Overlay& overlay) {
  const curve::DeCasteljauPoints c = curve::construction(shape.key.cubic, t);
  add_line(c.first[0], c.first[1], 2.25f * scale, kConstructionColour, overlay);
  add_line(c.first[1], c.first[2], 2.25f * scale, kConstructionColour, overlay);
  add_line(c.second[0], c.second[1], 2.75f * scale, kConstructionColour, overlay);
  // The last two points span the tangent: B'(t) = 3 (second[1] - second[0]).
  const double third = glm::length(c.second[1] - c.second[0]);
  add_arrow(c.point, curve::unit_tangent(shape.key.cubic, t), third, view, 2.75f * scale, kTangentColour, overlay);
  for (const glm::dvec3 at : c.first) add_disc(at, 3.5f * scale, kConstructionColour, overlay);
  for (const glm::dvec3 at : c.second) add_disc(at, 4.25f * scale, kConstructionColour, overlay);
  add_disc(c.point, 5.5f * scale, kTangentColour, overlay);
}

void add_circle(const sim::SegmentShape& shape, double t, float scale, Overlay& overlay) {
  const std::optional<curve::FrenetFrame> frame = curve::frenet(shape.key.cubic, t);
  if (!frame || !(frame->curvature * kMaxRadius > 1)) return;
  const double radius = 1 / frame->curvature;
  const glm::dvec3 touch = curve::point(shape.key.cubic, t), centre = touch + radius * frame->normal;
  glm::dvec3 before = touch;
  for (int i = 1; i <= kCircleSides; ++i) {
    const double angle = 2 * base::kPi * i / kCircleSides;
    const glm::dvec3 at = i == kCircleSides
                              ? touch
                              : centre + radius * (std::sin(angle) * frame->tangent - std::cos(angle) * frame->normal);
    add_line(before, at, 2.25f * scale, kCircleColour, overlay);
    before = at;
  }
  add_line(centre, touch, 1.25f * scale, faded(kCircleColour, 0xa0), overlay);
  add_disc(centre, 3.0f * scale, kCircleColour, overlay);
}

void add_rounding(const world::Document& document, const sim::DerivedTrack& derived, const world::Settings& settings,
                  const View& view, Overlay& overlay) {
  for (const world::Entity e : rounded_segments(document, derived, settings))
    add_rounding(derived.shape(e), settings, mark_scale(settings, view), overlay);
}

void add_laboratory(const world::Document& document, const sim::DerivedTrack& derived, const world::Settings& settings,
                    const View& view, const MarkedFindings& findings, Overlay& overlay) {
  using world::Layer;
  const float scale = mark_scale(settings, view);
  const sim::SegmentShape* const probed = derived.segments.find(settings.selected);
  const double t = settings.selected_t;
  const auto layer = [&](Layer which, bool possible, auto add) {
    if (!possible || !settings.lab->layers.has(which)) return;
    Overlay drawn;
    add(drawn);
    append_rimmed(drawn, scale, overlay);
  };
  layer(Layer::comb, true, [&](Overlay& o) { add_comb(derived, settings, view, o); });
  layer(Layer::frames, true, [&](Overlay& o) { add_frames(derived, settings, view, o); });
  layer(Layer::flips, true, [&](Overlay& o) { add_breaks(derived, findings.breaks, view, scale, o); });
  layer(Layer::conflicts, !findings.riding, [&](Overlay& o) {
    add_conflicts(derived, findings.conflicts, view, scale, o);
    add_flooded(derived, findings.flooded, view, scale, o);
    add_folds(derived, findings.folds, view, scale, o);
    add_folds(derived, findings.tight_bends, view, scale, o);
  });
  layer(Layer::limits, true, [&](Overlay& o) {
    add_spans(derived, findings.spans, scale, o);
    add_jolts(derived, findings.jolts, view, scale, o);
  });
  layer(Layer::rounding, true, [&](Overlay& o) { add_rounding(document, derived, settings, view, o); });
  layer(Layer::circle, probed != nullptr, [&](Overlay& o) { add_circle(*probed, t, scale, o); });
  layer(Layer::construction, probed != nullptr, [&](Overlay& o) { add_construction(*probed, t, view, scale, o); });
}

}  // namespace coaster::view
