#include "sim/plan/circuit_ends.h"

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

// Returns the piece in which the curvature falls from k towards `towards` to 0, as 1 - soft_step().
LeadPiece ease_piece(dvec3 forward, dvec3 towards, double k) {
  LeadPiece piece{forward, towards, glm::cross(forward, towards), 0, {}};
  const double length = std::min(kLongestEase, 2.0 * kEaseAngle / k);
  piece.length = length;
  piece.rate = [k, length](double u) {
    const double v = u / length, angle = k * length * (v - soft_step_integral(v));
    const double rate = k * (1.0 - soft_step(v));
    const auto [sin, cos] = base::sin_cos(angle);
    return ElementRate{{cos, sin, 0}, {-sin * rate, cos * rate, 0}, dvec3(0), 0};
  };
  return piece;
}

// Sets the up of the ease so that it is `after` (in the world) at its end.
void carry_up(LeadPiece& ease, dvec3 after) {
  const dvec3 local(glm::dot(after, ease.forward), glm::dot(after, ease.up), glm::dot(after, ease.left));
  const double k = ease.rate(0).d2.y, length = ease.length, whole = 0.5 * k * length;
  ease.rate = [rate = ease.rate, local, k, length, whole](double u) {
    ElementRate r = rate(u);
    const double v = u / length, angle = k * length * (v - soft_step_integral(v));
    r.up = curve::rotate(local, {0, 0, 1}, angle - whole);
    return r;
  };
}

// Returns the level direction in which a track bends upright: its own, but a steep track turns towards its riders'
// heads if it points down, and away from them if it points up.
dvec3 ahead_of(dvec3 forward, dvec3 up) {
  constexpr double kVertical = 1e-6, kSteep = 0.87, kSure = 0.2;
  const dvec3 level(forward.x, 0, forward.z), wish = (forward.y < 0 ? 1.0 : -1.0) * dvec3(up.x, 0, up.z);
  if (glm::length(level) < kVertical) return curve::perpendicular({0, 1, 0}, wish);
  const dvec3 ahead = glm::normalize(level);
  return std::abs(forward.y) > kSteep && glm::dot(ahead, wish) < -kSure ? -ahead : ahead;
}

}  // namespace

Lead lead_from(const TrackEnd& end, double radius) {
  Lead lead;
  const double k = glm::length(end.curvature);
  const bool bent = k >= kStraightEnd;
  ElementPath path(end.position, end.forward, bent ? end.curvature : dvec3(0), end.up);
  const auto add = [&] {
    const LeadPiece& piece = lead.pieces.back();
    path.set_axes(piece.forward, piece.up, piece.left);
    path.add(piece.length, piece.rate);
  };
  if (bent) lead.pieces.push_back(ease_piece(end.forward, curve::perpendicular(end.forward, end.curvature), k)), add();
  const dvec3 forward = path.end().tangent, ahead = ahead_of(forward, end.up);
  const double angle = base::arc_tangent(forward.y, glm::dot(forward, ahead)), gentle = base::radians(kGentle_deg);
  if (std::abs(angle) > gentle) {
    lead.steep = true;
    const Bend bend{angle, angle < 0 ? -0.75 * gentle : 0.75 * gentle, radius};
    const dvec3 up(0, 1, 0), left = glm::cross(up, ahead);
    if (bent) {
      const auto [sin, cos] = base::sin_cos(angle);
      carry_up(lead.pieces.back(), -sin * ahead + cos * up);
    }
    lead.pieces.push_back(
        {ahead, up, left, bend.length(), [bend](double u) { return upright_rate(bend.angle(u), bend.bend(u)); }});
    add();
  }
  const ElementPoint& last = path.end();
  lead.pose = {{last.position.x, last.position.z}, base::arc_tangent(last.tangent.z, last.tangent.x)};
  lead.height = last.position.y;
  lead.slope = last.tangent.y / std::sqrt(last.tangent.x * last.tangent.x + last.tangent.z * last.tangent.z);
  lead.length = last.s;
  return lead;
}

Lead lead_to(TrackEnd home, double radius) {
  home.forward = -home.forward;
  Lead lead = lead_from(home, radius);
  std::reverse(lead.pieces.begin(), lead.pieces.end());
  for (LeadPiece& piece : lead.pieces)
    piece.rate = [rate = piece.rate, length = piece.length](double u) {
      ElementRate r = rate(length - u);
      r.d1 = -r.d1;
      return r;
    };
  lead.pose.heading += base::kPi;
  lead.slope = -lead.slope;
  return lead;
}

void add_lead(const Lead& lead, ElementPath& path) {
  for (const LeadPiece& piece : lead.pieces) {
    path.set_axes(piece.forward, piece.up, piece.left);
    path.add(piece.length, piece.rate);
  }
}

}  // namespace coaster::sim
