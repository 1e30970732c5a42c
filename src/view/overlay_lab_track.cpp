// The pictures along the whole track: frames, comb, Frenet failures. Only visible track is processed, in steps of a few
// pixels, so the work does not grow with invisible detail.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "view/overlay_lab.h"
#include "view/overlay_lab_parts.h"
#include "world/lab_view.h"

namespace coaster::view {
namespace {

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
constexpr std::array<glm::dvec2, 6> kExclamation{{{0, 4.8}, {0, 3.5}, {0, 2.2}, {0, 0.9}, {0, -0.4}, {0, -4.2}}};  // px

// Returns the number of teeth of a segment, both ends included. Segments smaller than `px` on screen share teeth: one
// at the start of each segment that contains a multiple of the step.
int teeth_of(const sim::Derived& derived, const SeenSegment& seen, double px) {
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

}  // namespace

void add_comb(const sim::Derived& derived, const world::Settings& settings, const View& view, Overlay& overlay) {
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

void add_frames(const sim::Derived& derived, const world::Settings& settings, const View& view, Overlay& overlay) {
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

void add_spans(const sim::Derived& derived, std::span<const sim::RedSpan> spans, float scale, Overlay& overlay) {
  constexpr double kPiece = 1.0;  // m
  if (derived.order.empty()) return;
  int left = kMaxSpanPieces;
  for (const sim::RedSpan& span : spans) {
    double length = span.to_distance - span.from_distance;
    if (length < 0 && derived.closed) length += derived.length;  // across the closing joint
    const int pieces = std::min(left, std::max(1, static_cast<int>(std::ceil(std::abs(length) / kPiece))));
    left -= pieces;
    add_band(derived, span.from_distance, span.from_distance + length, pieces, 5.0f * scale, kLimitColour, overlay);
    if (left <= 0) return;
  }
}

void add_jolts(const sim::Derived& derived, std::span<const sim::Jolt> jolts, const View& view, float scale,
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

void add_breaks(const sim::Derived& derived, std::span<const sim::FrenetBreak> breaks, const View& view, float scale,
                Overlay& overlay) {
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
      for (int i = 0; i < kLines; ++i) {
        const double from = at.t + (at.t_end - at.t) * i / kLines, to = at.t + (at.t_end - at.t) * (i + 1) / kLines;
        add_line(curve::point(cubic, from), curve::point(cubic, to), 5.0f * scale, faded(kBreakColour, 0xc0), overlay);
      }
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

void add_folds(const sim::Derived& derived, std::span<const sim::Fold> folds, const View& view, float scale,
               Overlay& overlay) {
  const auto shown = folds.first(std::min(folds.size(), static_cast<std::size_t>(kMaxConflicts)));
  for (const sim::Fold& fold : shown)
    add_band(derived, fold.from, fold.to, kPieces, 5.0f * scale, kConflictColour, overlay);
  for (const sim::Fold& fold : shown)
    add_sign(glm::dvec3(fold.place) + glm::dvec3(0, kOver, 0), kConflictColour, kExclamation, view, scale, overlay);
}

void add_conflicts(const sim::Derived& derived, std::span<const sim::Conflict> conflicts, const View& view, float scale,
                   Overlay& overlay) {
  const auto shown = conflicts.first(std::min(conflicts.size(), static_cast<std::size_t>(kMaxConflicts)));
  for (const sim::Conflict& conflict : shown) {
    add_band(derived, conflict.from, conflict.to, kPieces, 5.0f * scale, kConflictColour, overlay);
    add_band(derived, conflict.other_from, conflict.other_to, kPieces, 5.0f * scale, kConflictColour, overlay);
    add_line(conflict.at_place, conflict.other_place, 3.0f * scale, kConflictColour, overlay);
  }
  for (const sim::Conflict& conflict : shown)
    add_sign(0.5 * (glm::dvec3(conflict.at_place) + glm::dvec3(conflict.other_place)) + glm::dvec3(0, kOver, 0),
             kConflictColour, kExclamation, view, scale, overlay);
}

}  // namespace coaster::view
