#include "edit/perform/joint_repair.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "base/cancellable_job.h"
#include "base/text.h"
#include "curve/continuity.h"
#include "curve/g2.h"
#include "edit/perform/perform_context.h"
#include "world/topology.h"

namespace coaster::edit {
namespace {

using curve::G2Side;
using glm::dvec3;
using world::Document;
using world::JointKind;
using world::Knot;

// The indices in track order around a joint.
struct JointIndices {
  std::size_t before, at, after;
};
bool joins(const Document& document, std::size_t index) {
  const std::size_t count = document.track.knots.size();
  return document.track.closed ? count > 1 : index > 0 && index + 1 < count;
}
JointIndices joint_at(const Document& document, std::size_t index) {
  const std::size_t count = document.track.knots.size();
  return {(index + count - 1) % count, index, (index + 1) % count};
}

curve::Cubic cubic_from(const Document& document, std::size_t index) {
  return world::cubic_of(document, document.track.segments[index]);
}

curve::JointContinuity class_at(const Document& document, std::size_t index) {
  return curve::joint(cubic_from(document, joint_at(document, index).before), cubic_from(document, index));
}

dvec3 forward(const Knot& knot) { return glm::normalize(dvec3(knot.tangent)); }

// Returns the far end of one side. `strict` keeps a G2 joint there G2; a C2 joint stays C2 in any case.
G2Side side_of(const Document& document, std::size_t far, bool out, bool strict, bool one_neighbour) {
  const Knot& knot = nth_knot(document, far);
  G2Side side;
  side.anchor = dvec3(knot.position);
  side.direction = out ? forward(knot) : -forward(knot);
  side.length = out ? knot.out_length : knot.in_length;
  if (!joins(document, far)) {
    side.length_fixed = knot.joint == JointKind::automatic;
    return side;
  }
  const curve::JointContinuity joint = class_at(document, far);
  side.length_fixed =
      one_neighbour || knot.joint != JointKind::aligned || joint.parametric >= curve::ParametricContinuity::c1;
  if (joint.parametric == curve::ParametricContinuity::c2) {
    side.keep = G2Side::FarEndConstraint::handle;
  } else if (strict && joint.geometric == curve::GeometricContinuity::g2) {
    side.keep = G2Side::FarEndConstraint::curvature;
    // The curvature on the other side of that joint: it does not change, unless both sides belong to this joint.
    side.curvature = one_neighbour ? 0.5 * (joint.curvature_before + joint.curvature_after)
                     : out         ? joint.curvature_before
                                   : joint.curvature_after;
    side.curvature -= glm::dot(side.curvature, side.direction) * side.direction;
  }
  return side;
}

curve::G2Problem problem_of(const Document& document, const JointIndices& j, bool strict) {
  const Knot& knot = nth_knot(document, j.at);
  const bool one_neighbour = j.before == j.after;
  const dvec3 t = forward(knot), p(knot.position);
  curve::G2Problem problem;
  problem.position = p;
  problem.in_handle = p - t * double{knot.in_length};
  problem.out_handle = p + t * double{knot.out_length};
  problem.equal_lengths =
      knot.joint == JointKind::smooth || class_at(document, j.at).parametric >= curve::ParametricContinuity::c1;
  problem.position_fixed = nth_knot(document, j.before).joint == JointKind::automatic ||
                           nth_knot(document, j.after).joint == JointKind::automatic;
  problem.before = side_of(document, j.before, true, strict, one_neighbour);
  problem.after = side_of(document, j.after, false, strict, one_neighbour);
  return problem;
}

double polygon(const curve::Cubic& c) {
  return glm::length(dvec3(c.p1) - dvec3(c.p0)) + glm::length(dvec3(c.p2) - dvec3(c.p1)) +
         glm::length(dvec3(c.p3) - dvec3(c.p2));
}

double farthest(const curve::G2Problem& problem, const curve::G2Solution& s) {
  return std::max({glm::length(s.in_handle - problem.in_handle), glm::length(s.position - problem.position),
                   glm::length(s.out_handle - problem.out_handle), std::abs(s.before_length - problem.before.length),
                   std::abs(s.after_length - problem.after.length)});
}

std::string metres(double value) { return base::to_text(std::round(value * 1000.0) / 1000.0) + " m"; }

// Checks the limits of knots, and that the change is small enough for a repair.
base::Status acceptable(const Document& document, const JointIndices& j, const curve::G2Problem& problem,
                        const curve::G2Solution& s) {
  if (s.outcome == curve::G2Outcome::degenerate) return refused("a handle has no length");
  if (s.outcome == curve::G2Outcome::no_convergence)
    return refused("there is no G2 shape nearby that leaves the neighbouring joints as they are");
  const double most = 0.5 * std::min(polygon(cubic_from(document, j.before)), polygon(cubic_from(document, j.at))),
               far = farthest(problem, s);
  if (far > most)
    return refused(
        fmt::format("a control point would move {}, more than half a segment ({})", metres(far), metres(most)));
  for (const double length :
       {glm::length(s.position - s.in_handle), glm::length(s.out_handle - s.position), s.before_length, s.after_length})
    if (!(length >= double{world::kMinHandle} && length <= double{world::kMaxHandle}))
      return refused(fmt::format("a handle would leave the limits of {} to {} m", base::to_text(world::kMinHandle),
                                 base::to_text(world::kMaxHandle)));
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(s.position[axis]) > double{world::kMaxCoordinate})
      return refused("the knot would be beyond the limit of coordinates");
  return {};
}

void set_length(Knot& knot, bool out, double to) {
  (out ? knot.out_length : knot.in_length) = static_cast<float>(to);
  if (knot.joint == JointKind::smooth) knot.in_length = knot.out_length = static_cast<float>(to);
}

void put(Document& document, const JointIndices& j, const curve::G2Problem& problem, const curve::G2Solution& s) {
  Knot& knot = nth_knot(document, j.at);
  if (knot.joint == JointKind::automatic) knot.joint = JointKind::aligned;
  if (!problem.position_fixed) knot.position = glm::vec3(s.position);
  world::set_tangent(knot, glm::vec3(s.out_handle - s.in_handle));
  knot.in_length = static_cast<float>(glm::length(s.position - s.in_handle));
  knot.out_length = problem.equal_lengths ? knot.in_length : static_cast<float>(glm::length(s.out_handle - s.position));
  if (!problem.before.length_fixed) set_length(nth_knot(document, j.before), true, s.before_length);
  if (!problem.after.length_fixed) set_length(nth_knot(document, j.after), false, s.after_length);
}

using Continuity = std::optional<curve::JointContinuity>;  // nothing at an open end
Continuity classes_at(const Document& document, std::size_t index) {
  return joins(document, index) ? Continuity(class_at(document, index)) : std::nullopt;
}
bool lowered(const Continuity& before, const Continuity& now) {
  return before && (now->geometric < before->geometric || now->parametric < before->parametric);
}

// Does one repair. Not strict: the neighbours' joints may lose G2 (but not C1 or C2) and regain it later.
base::Status repair(Document& document, std::size_t index, bool strict) {
  const JointIndices j = joint_at(document, index);
  const curve::G2Problem problem = problem_of(document, j, strict);
  const curve::G2Solution solution = curve::solve_g2(problem);
  if (const base::Status status = acceptable(document, j, problem, solution); !status) return status;
  const Knot was[] = {nth_knot(document, j.before), nth_knot(document, j.at), nth_knot(document, j.after)};
  const Continuity before = classes_at(document, j.before), after = classes_at(document, j.after);
  const curve::ParametricContinuity own = class_at(document, index).parametric;
  put(document, j, problem, solution);
  const curve::JointContinuity now = class_at(document, index);
  std::string reason;
  if (now.geometric != curve::GeometricContinuity::g2)
    reason = "rounding the coordinates leaves a jump of curvature of " + base::to_text(now.curvature_jump) + " 1/m";
  else if (problem.equal_lengths && now.parametric < std::min(own, curve::ParametricContinuity::c1))
    reason = "rounding the coordinates would cost the joint C1";
  else if (strict && (lowered(before, classes_at(document, j.before)) || lowered(after, classes_at(document, j.after))))
    reason = "a neighbouring joint would lose its class";
  if (reason.empty()) return {};
  nth_knot(document, j.before) = was[0];
  nth_knot(document, j.after) = was[2];
  nth_knot(document, j.at) = was[1];
  return refused(std::move(reason));
}

double movement_between(const Document& a, const Document& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.track.knots.size(); ++i) {
    const Knot &from = nth_knot(a, i), &to = nth_knot(b, i);
    for (const dvec3 d :
         {dvec3(to.position) - dvec3(from.position), dvec3(world::in_handle(to)) - dvec3(world::in_handle(from)),
          dvec3(world::out_handle(to)) - dvec3(world::out_handle(from))})
      sum += glm::dot(d, d);
  }
  return std::sqrt(sum);
}

// Repairs once along the track and keeps joints that are G2. Returns the last reason for each refused joint.
void pass_along(Document& document, std::vector<std::string>& reasons) {
  for (std::size_t i = 0; i < document.track.knots.size(); ++i) {
    reasons[i].clear();
    if (!joins(document, i) || class_at(document, i).geometric == curve::GeometricContinuity::g2) continue;
    if (const base::Status status = repair(document, i, true); !status) reasons[i] = status.message;
  }
}

// Sweeps to and fro; each repair may disturb its neighbours, until every joint is G2 with a small jump or nothing
// improves.
void sweeps(Document& document, std::vector<std::string>& reasons) {
  constexpr double kSmall = 2e-4;  // 1/m
  const std::size_t count = document.track.knots.size();
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    bool any = false;
    for (std::size_t k = 0; k < count && !base::interrupted(); ++k) {
      const std::size_t i = sweep % 2 == 0 ? k : count - 1 - k;
      base::report_progress((sweep + static_cast<double>(k) / static_cast<double>(count)) / kMostSweeps);
      reasons[i].clear();
      if (!joins(document, i)) continue;
      const curve::JointContinuity now = class_at(document, i);
      if (now.curvature_jump < kSmall && now.geometric == curve::GeometricContinuity::g2) continue;
      const base::Status status = repair(document, i, false);
      if (!status) reasons[i] = status.message;
      any |= static_cast<bool>(status);
    }
    if (!any) break;
  }
}

// Returns the result of one of the two methods for a document.
RepairReport report(const Document& before, const Document& now, const std::vector<std::string>& reasons,
                    bool& spoilt) {
  RepairReport result;
  for (std::size_t i = 0; i < now.track.knots.size(); ++i) {
    if (!joins(now, i)) continue;
    const Continuity was = classes_at(before, i), is = classes_at(now, i);
    if (lowered(was, is)) spoilt = true;
    if (was->geometric == curve::GeometricContinuity::g2) ++result.already;
    else if (is->geometric == curve::GeometricContinuity::g2) ++result.changed;
    else
      result.refused.push_back({now.track.knots[i], reasons[i].empty() ? "the repair did not converge" : reasons[i]});
  }
  result.movement = movement_between(before, now);
  return result;
}

}  // namespace

base::Status make_g2(Document& document, std::size_t index, double* movement) {
  if (movement) *movement = 0;
  if (!joins(document, index)) return refused("an end of an open track joins nothing");
  if (class_at(document, index).geometric == curve::GeometricContinuity::g2) return {};
  const Document before = document;
  const base::Status status = repair(document, index, true);
  if (status && movement) *movement = movement_between(before, document);
  return status;
}

RepairReport make_all_g2(Document& document) {
  std::vector<std::string> reasons(document.track.knots.size());
  Document once = document;
  pass_along(once, reasons);
  bool spoilt = false;
  RepairReport best = report(document, once, reasons, spoilt);
  Document settled = document;
  sweeps(settled, reasons);
  bool lost = false;
  RepairReport other = report(document, settled, reasons, lost);
  const bool better = other.changed > best.changed || (other.changed == best.changed && other.movement < best.movement);
  if (!lost && (spoilt || better)) {
    document = std::move(settled);
    return other;
  }
  if (spoilt)
    return report(document, document,
                  std::vector<std::string>(reasons.size(), "a neighbouring joint would lose its class"), spoilt);
  document = std::move(once);
  return best;
}

}  // namespace coaster::edit
