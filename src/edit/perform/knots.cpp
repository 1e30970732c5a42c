// Commands that shape knots and segments without adding or removing any.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "base/units.h"
#include "curve/frames.h"
#include "edit/commands/commands_document.h"
#include "edit/commands/commands_shape.h"
#include "edit/perform/joint_repair.h"
#include "edit/perform/knot_runs.h"
#include "edit/perform/perform_context.h"
#include "sim/study/jolt.h"
#include "world/topology.h"

namespace coaster::edit {
namespace {

using base::Status;
using glm::dmat3;
using glm::dvec3;
using world::Entity;
using world::EntityKind;
using world::JointKind;
using world::Knot;

constexpr double kShortDirection = 1e-9;  // m, as in world::set_tangent

Knot& knot_at(Session& session, world::Entity e) { return session.document.entities.get<Knot>(e); }

constexpr std::size_t kMostNamed = 4;  // refused joints named in a notice

std::string as_movement(double value) {
  return value >= 1.0 ? base::to_text(std::round(value * 1e3) / 1e3) + " m"
                      : base::to_text(std::round(value * 1e6) / 1e3) + " mm";
}

std::string told(const world::Document& document, const RepairReport& report) {
  std::string text =
      fmt::format("Made {} {} G2 by moving {}. {} were G2 already.", report.changed,
                  report.changed == 1 ? "joint" : "joints", as_movement(report.movement), report.already);
  if (report.refused.empty()) return text;
  text += fmt::format(" {} cannot be made G2: ", report.refused.size());
  for (std::size_t i = 0; i < std::min(kMostNamed, report.refused.size()); ++i)
    text += fmt::format("{}@{} ({})", i ? ", " : "", world::label_of(document, report.refused[i].knot),
                        report.refused[i].reason);
  return text + (report.refused.size() > kMostNamed ? ", ..." : ".");
}

// Returns the step of the force at a fastest passage of the ride, before and after the repair, as a sentence.
std::string told(std::string_view what, std::optional<double> before, std::optional<double> now) {
  if (!before || !now) return fmt::format(" {}: none.", what);
  return fmt::format(" {}: {} g, before {} g.", what, base::figure_text(*now, 3, "g"),
                     base::figure_text(*before, 3, "g"));
}

constexpr double kLeastFactor = 1e-4;  // of scaling: smaller factors would lose the shape
constexpr double kShortAxis = 1e-9;

// p -> about + linear (p - about) + by.
struct AffineMap {
  dmat3 linear{1.0};
  dvec3 about{0}, by{0};
  bool rigid_shift = false;  // linear is 1: only positions change, by one addition
};

float cut_length(double length, bool& cut) {
  const double within = std::clamp(length, double{world::kMinHandle}, double{world::kMaxHandle});
  cut = cut || within != length;
  return static_cast<float>(within);
}

void turn(Knot& knot, const dmat3& linear, bool& cut) {
  const dvec3 tangent = linear * dvec3(knot.tangent), up = linear * dvec3(knot.up);
  const double stretch = glm::length(tangent);
  if (!(stretch > 0)) return;
  world::set_tangent(knot, glm::vec3(tangent / stretch));
  knot.up = glm::vec3(curve::perpendicular(dvec3(knot.tangent), up));
  world::orthonormalise(knot);
  knot.spin = static_cast<float>(std::clamp<double>(knot.spin * (glm::determinant(linear) < 0 ? -1 : 1) / stretch,
                                                    -world::kMaxSpin, world::kMaxSpin));
  knot.in_length = cut_length(knot.in_length * stretch, cut),
  knot.out_length = cut_length(knot.out_length * stretch, cut);
}

// Mirrors reverse twists: whole turns between two mirrored knots change sign, as spins do.
void turn_back_twists(Session& session, const std::vector<Entity>& knots, bool from_start) {
  for (const Entity e : session.document.track.segments) {
    world::Segment& segment = session.document.entities.get<world::Segment>(e);
    const auto chosen = [&](Entity k) { return std::binary_search(knots.begin(), knots.end(), k); };
    if (segment.turns != 0 && chosen(segment.from) && chosen(segment.to))
      segment.turns = -world::segment(former_document(session, from_start, e), e).turns;
  }
}

Status transform(Session& session, Change& change, const Knots& which, const AffineMap& map, bool from_start) {
  auto knots = knots_of(session, which);
  if (!knots) return knots.status();
  bool cut = false;
  for (const Entity e : *knots) {
    Knot next = world::knot(former_document(session, from_start, e), e);
    const dvec3 position =
        map.rigid_shift ? dvec3(next.position) + map.by : map.about + map.linear * (dvec3(next.position) - map.about);
    if (!map.rigid_shift) turn(next, map.linear, cut);
    constexpr double kMost = world::kMaxCoordinate;
    const dvec3 within = glm::clamp(position, dvec3(-kMost), dvec3(kMost));
    if (within != position)
      change.clamp_position("position", glm::vec3(glm::clamp(position, dvec3(-1e30), dvec3(1e30))));
    next.position = glm::vec3(within);
    session.document.entities.get<Knot>(e) = next;
  }
  if (cut)
    change.clamped.push_back(fmt::format("Kept handle lengths within the limits of {} to {} m.",
                                         base::to_text(world::kMinHandle), base::to_text(world::kMaxHandle)));
  if (glm::determinant(map.linear) < 0) {
    std::sort(knots->begin(), knots->end());
    turn_back_twists(session, *knots, from_start);
  }
  return {};
}

}  // namespace

Status perform(Session& session, Change& change, const MoveKnot& command) {
  const world::Entity e = entity_of(session, command.knot);
  knot_at(session, e).position = change.clamp_position("position", command.to);
  return {};
}

Status perform(Session& session, Change& change, const MoveHandle& command) {
  const auto e = require(session, {command.handle.knot}, EntityKind::knot);
  if (!e) return e.status();
  Knot& knot = knot_at(session, *e);
  const bool in = command.handle.end == HandleEnd::in;
  glm::dvec3 arm = glm::dvec3(command.to) - glm::dvec3(knot.position);
  if (in) arm = -arm;
  const double length = glm::length(arm);
  shaped_by_hand(knot);
  // A handle on its knot has no direction: keep the old one.
  if (length >= double{world::kMinHandle}) world::set_tangent(knot, glm::vec3(arm));
  const float clamped = change.clamp("handle length", static_cast<float>(std::max(length, 0.0)), world::kMinHandle,
                                     world::kMaxHandle, "m");
  (in ? knot.in_length : knot.out_length) = clamped;
  if (knot.joint == JointKind::smooth) knot.in_length = knot.out_length = clamped;
  return {};
}

Status perform(Session& session, Change&, const SetDirection& command) {
  const auto knots = knots_of(session, command.knots);
  if (!knots) return knots.status();
  if (!(glm::length(glm::dvec3(command.to)) >= kShortDirection)) return refused("expected a direction longer than 0");
  return each_knot(session, command.knots, [&](Knot& knot) {
    shaped_by_hand(knot);
    world::set_tangent(knot, command.to);
  });
}

Status perform(Session& session, Change& change, const SetHandleLengths& command) {
  const float in = change.clamp("handle length", command.in, world::kMinHandle, world::kMaxHandle, "m");
  const float out = change.clamp("handle length", command.out, world::kMinHandle, world::kMaxHandle, "m");
  return each_knot(session, command.knots, [&](Knot& knot) {
    shaped_by_hand(knot);
    knot.in_length = in, knot.out_length = out;
    if (in != out) knot.joint = JointKind::aligned;
  });
}

Status perform(Session& session, Change& change, const SetRoll& command) {
  const auto knots = knots_of(session, command.knots);
  if (!knots) return knots.status();
  for (const world::Entity e : *knots)
    world::set_roll(knot_at(session, e), command.to);  // any angle is valid: it wraps
  change.respun = with_neighbours(session.document, *knots);
  return {};
}

Status perform(Session& session, Change& change, const SetSpin& command) {
  const double most = base::degrees(double{world::kMaxSpin});
  const auto spin = static_cast<float>(base::radians(change.clamp("spin", command.to, -most, most, "deg/m")));
  return each_knot(session, command.knots, [&](Knot& knot) {
    knot.spin = std::clamp(spin, -world::kMaxSpin, world::kMaxSpin), knot.spin_kind = world::SpinKind::set;
  });
}

Status perform(Session& session, Change& change, const AutomaticSpin& command) {
  const auto knots = knots_of(session, command.knots);
  if (!knots) return knots.status();
  for (const world::Entity e : *knots) knot_at(session, e).spin_kind = world::SpinKind::automatic;
  change.respun = *knots;
  return {};
}

Status perform(Session& session, Change&, const SetJoint& command) {
  return each_knot(session, command.knots, [&](Knot& knot) {
    knot.joint = command.to;
    if (command.to == JointKind::smooth) equalise(knot);
  });
}

Status perform(Session& session, Change& change, const SetTurns& command) {
  const world::Entity e = entity_of(session, command.segment);
  session.document.entities.get<world::Segment>(e).turns =
      change.clamp("turns", command.to, -world::kMaxTurns, world::kMaxTurns);
  const world::Segment& segment = world::segment(session.document, e);
  change.respun = {segment.from, segment.to};
  return {};
}

Status perform(Session& session, Change& change, const MakeG2& command) {
  const world::Entity e = entity_of(session, command.knot);
  const std::size_t index = *world::index_of(session.document.track.knots, e);
  double movement = 0;
  const std::span<const sim::Jolt> jolts = SessionFindings(session).jolts();  // of the ride before
  const world::Document before = session.document;
  if (const Status status = make_g2(session.document, index, &movement); !status) return status;
  change.note = before == session.document ? "The joint is G2 already."
                                           : fmt::format("Made the joint G2 by moving {}.", as_movement(movement));
  change.note += told("Step of the force at the fastest passage", sim::fastest_step(before, jolts, index),
                      sim::fastest_step(session.document, jolts, index));
  return {};
}

Status perform(Session& session, Change& change, const MakeAllG2&) {
  world::Document next = session.document;
  const RepairReport report = make_all_g2(next);
  const std::string text = told(session.document, report);
  if (report.changed == 0 && !report.refused.empty()) return refused(text);
  const std::span<const sim::Jolt> jolts = SessionFindings(session).jolts();
  change.note = text + told("Largest step of the force at a fastest passage",
                            sim::largest_step(session.document, jolts), sim::largest_step(next, jolts));
  session.document = std::move(next);
  return {};
}

Status perform(Session& session, Change& change, const Translate& command) {
  return transform(session, change, command.knots, {.by = dvec3(command.by), .rigid_shift = true}, command.from_start);
}

Status perform(Session& session, Change& change, const Rotate& command) {
  const dvec3 axis(command.axis);
  if (!(glm::length(axis) >= kShortAxis)) return refused("expected an axis longer than 0");
  const dvec3 unit = axis / glm::length(axis);
  const double angle = base::radians(std::remainder(command.by, 360.0));
  const dmat3 linear(curve::rotate({1, 0, 0}, unit, angle), curve::rotate({0, 1, 0}, unit, angle),
                     curve::rotate({0, 0, 1}, unit, angle));
  return transform(session, change, command.knots, {.linear = linear, .about = dvec3(command.about)},
                   command.from_start);
}

Status perform(Session& session, Change& change, const Scale& command) {
  dmat3 linear(1.0);
  for (int i = 0; i < 3; ++i) {
    if (!(std::abs(double{command.by[i]}) >= kLeastFactor))
      return refused(fmt::format("expected factors of {} or more", base::to_text(kLeastFactor)));
    linear[i][i] = command.by[i];
  }
  return transform(session, change, command.knots, {.linear = linear, .about = dvec3(command.about)},
                   command.from_start);
}

Status perform(Session& session, Change& change, const Mirror& command) {
  const dvec3 across(command.across);
  if (!(glm::length(across) >= kShortAxis)) return refused("expected a normal longer than 0");
  const dvec3 n = across / glm::length(across);
  const dmat3 linear = dmat3(1.0) - 2.0 * glm::outerProduct(n, n);
  return transform(session, change, command.knots, {.linear = linear, .about = dvec3(command.about)}, false);
}

Status perform(Session& session, Change& change, const Align& command) {
  const int axis = static_cast<int>(command.axis);
  const std::string what = fmt::format("position.{}", base::name_of(command.axis));
  const double to = change.clamp(what, command.to, -double{world::kMaxCoordinate}, double{world::kMaxCoordinate}, "m");
  return each_knot(session, command.knots, [&](Knot& knot) { knot.position[axis] = static_cast<float>(to); });
}

}  // namespace coaster::edit
