#include "exchange/nolimits/nl2_corners.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/portable_math.h"
#include "curve/arc_length.h"
#include "curve/frames.h"

namespace coaster::exchange {
namespace {

using glm::dvec3;

struct Fillet {
  double leaves = 1, joins = 0;  // parameters of the piece before and the piece after
  Bezier curve;
  double off = 0;  // m
};

// Returns the fillet that starts `reach` m before the corner and ends as far after it.
Fillet fillet_of(const Bezier& before, const Bezier& after, const curve::ArcLengthMap& arc_before,
                 const curve::ArcLengthMap& arc_after, double reach) {
  const auto leaves = [&](double m) { return arc_before.parameter(arc_before.length() - m); };
  Fillet fillet{leaves(reach), arc_after.parameter(reach), {}, 0};
  const Bezier in = part(before, 0, fillet.leaves), out = part(after, fillet.joins, 1);
  const double handle = 2 * reach / 3;
  fillet.curve = {in[3], in[3] + handle * end_direction(in), out[0] - handle * start_direction(out), out[0]};
  constexpr int kSamples = 32;
  for (int k = 1; k < kSamples; ++k) {
    const double t = static_cast<double>(k) / kSamples, beyond = (2 * t - 1) * reach;
    const dvec3 old = beyond < 0 ? point(before, leaves(-beyond)) : point(after, arc_after.parameter(beyond));
    fillet.off = std::max(fillet.off, glm::distance(old, point(fillet.curve, t)));
  }
  return fillet;
}

Fillet round_corner(const Bezier& before, const Bezier& after, double angle) {
  constexpr double kShare = 0.45, kShorter = 0.8;
  constexpr int kTries = 40;
  const curve::ArcLengthMap arc_before(in_float(before)), arc_after(in_float(after));
  // Between straight lines the fillet is reach sin(angle / 2) / 2 from the corner.
  double reach = std::min(
      {2 * kCornerOff / base::sin_cos(angle / 2).sin, kShare * arc_before.length(), kShare * arc_after.length()});
  Fillet fillet = fillet_of(before, after, arc_before, arc_after, reach);
  for (int tries = 0; fillet.off > 1.000001 * kCornerOff && tries < kTries; ++tries)
    fillet = fillet_of(before, after, arc_before, arc_after, reach *= kShorter);
  return fillet;
}

bool is_corner(const Bezier& before, const Bezier& after, double angle) {
  // A handle turned by half the angle moves its end by that much, and the curve by at most 4/9 of it.
  const double handle = std::max(glm::distance(before[2], before[3]), glm::distance(after[0], after[1]));
  return 4.0 / 9 * handle * angle / 2 > kTurnedOff || angle > base::radians(kSharpest);
}

}  // namespace

std::vector<SplinePiece> round_corners(const std::vector<SplinePiece>& pieces, bool closed,
                                       std::vector<Corner>& corners) {
  std::vector<std::optional<Fillet>> fillets(pieces.size());  // at the start of each piece
  for (std::size_t i = closed ? 0 : 1; i < pieces.size(); ++i) {
    const Bezier &before = pieces[i > 0 ? i - 1 : pieces.size() - 1].curve, &after = pieces[i].curve;
    const double angle = curve::angle_between(end_direction(before), start_direction(after));
    if (!is_corner(before, after, angle)) continue;
    if (angle <= base::radians(kSharpest) + 1e-6) fillets[i] = round_corner(before, after, angle);
    corners.push_back({pieces[i].vertex, angle, fillets[i] ? fillets[i]->off : 0});
  }
  std::vector<SplinePiece> rounded;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto &start = fillets[i], &end = i + 1 < pieces.size() ? fillets[i + 1] : fillets[0];
    rounded.push_back({part(pieces[i].curve, start ? start->joins : 0, end ? end->leaves : 1), pieces[i].vertex});
    if (end) rounded.push_back({end->curve, pieces[i + 1 < pieces.size() ? i + 1 : 0].vertex});
  }
  return rounded;
}

namespace {

// Returns the parameter where a curve is slowest: at a cusp the derivative vanishes.
double slowest(const Bezier& b) {
  constexpr int kSamples = 32, kHalvings = 40;
  const auto speed = [&](double t) { return glm::length(slope(b, t)); };
  double best = 0;
  for (int k = 1; k <= kSamples; ++k)
    if (const double t = static_cast<double>(k) / kSamples; speed(t) < speed(best)) best = t;
  double step = 1.0 / kSamples;
  for (int i = 0; i < kHalvings; ++i, step /= 2)
    for (const double t : {std::max(best - step, 0.0), std::min(best + step, 1.0)})
      if (speed(t) < speed(best)) best = t;
  return best;
}

// Returns the direction of travel kCornerOff away from the point at t, towards the end 0 or 1; at that end if it is
// nearer.
dvec3 direction_beside(const Bezier& b, double t, double end) {
  constexpr int kHalvings = 40;
  const dvec3 here = point(b, t);
  double near = t, far = end;
  for (int i = 0; i < kHalvings && glm::distance(point(b, end), here) > kCornerOff; ++i) {
    const double middle = 0.5 * (near + far);
    (glm::distance(point(b, middle), here) > kCornerOff ? far : near) = middle;
  }
  if (far == 0) return start_direction(b);
  return far == 1 ? end_direction(b) : glm::normalize(slope(b, far));
}

}  // namespace

std::optional<Corner> find_fold(const std::vector<SplinePiece>& pieces, bool closed) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const SplinePiece &piece = pieces[i], &next = pieces[(i + 1) % pieces.size()];
    const double t = slowest(piece.curve);
    const double within =
        curve::angle_between(direction_beside(piece.curve, t, 0), direction_beside(piece.curve, t, 1));
    if (within > base::radians(kSharpest)) return Corner{piece.vertex, within, 0};
    const double corner = curve::angle_between(end_direction(piece.curve), start_direction(next.curve));
    if ((i + 1 == pieces.size() && !closed) || is_corner(piece.curve, next.curve, corner)) continue;
    const double across = curve::angle_between(direction_beside(piece.curve, 1, 0), direction_beside(next.curve, 0, 1));
    if (across > base::radians(kSharpest)) return Corner{next.vertex, across, 0};
  }
  return std::nullopt;
}

}  // namespace coaster::exchange
