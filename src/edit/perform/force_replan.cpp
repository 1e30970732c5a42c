#include "edit/perform/force_replan.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/text.h"
#include "curve/continuity.h"
#include "curve/frames.h"
#include "edit/perform/placing.h"
#include "edit/perform/replan.h"
#include "world/sections.h"
#include "world/topology.h"

namespace coaster::edit {
namespace {

using base::Status;
using glm::dvec3;
using world::Document;
using world::Entity;
using world::Knot;
using world::SectionKind;
using world::SectionRun;

// Properties of a section's end that the following track shares, besides the knot's frame.
struct BendAndSpin {
  dvec3 curvature;  // 1/m
  double spin;      // rad/m
};
BendAndSpin bend_and_spin(const Document& document, const SectionRun& run) {
  const Knot& knot = nth_knot(document, run.end());
  const curve::Cubic cubic = world::cubic_of(document, document.track.segments[run.end() - 1]);
  return {curve::across(curve::curvature_vector(cubic, 1.0), glm::normalize(dvec3(knot.tangent))), knot.spin};
}

bool alike(const BendAndSpin& a, const BendAndSpin& b, const sim::Carry& carry) {
  constexpr double kBend = 5e-5, kSpin = 1e-4;  // 1/m, rad/m
  return glm::distance(carry.direction(a.curvature), b.curvature) <= kBend && std::abs(a.spin - b.spin) <= kSpin;
}

// Returns the section that begins where a run ends; none at the end of an open track.
Entity section_after(const Document& document, const SectionRun& run) {
  const std::vector<Entity>& segments = document.track.segments;
  if (!document.track.closed && run.end() == segments.size()) return world::kNone;
  return world::segment(document, segments[run.end() % segments.size()]).section;
}

// Changes of speed up to this leave a section as it is.
constexpr double kSameSpeed = 0.002;  // m/s

// Returns the energy with which the train comes to a force section of the document, m^2/s^2: twice that of a kilogram.
// Nothing for other sections, and where the document has none of that name.
std::optional<double> energy_at(const Document& document, Entity section) {
  const auto* const value = document.entities.find<world::Section>(section);
  if (value == nullptr || value->kind != SectionKind::force) return std::nullopt;
  const double height = nth_knot(document, world::run_of(document, section).first).position.y;
  return value->force.speed * value->force.speed + 2 * world::kGravity * height;
}

// Gives a force section the speed at which the train comes with what it has gained.
void put_speed(const Session& session, const Change& change, Document& document, Entity section) {
  const std::optional<double> former = energy_at(session.document, section);
  if (!change.gained || !former) return;
  double& speed = document.entities.get<world::Section>(section).force.speed;
  const double square = speed * speed + *former + *change.gained - *energy_at(document, section);
  if (square < world::kSlowestForce * world::kSlowestForce) return;
  if (const double now = std::sqrt(square); std::abs(now - speed) > kSameSpeed) speed = now;
}

bool has_equipment(const Document& document, const SectionRun& run) {
  for (std::size_t i = run.first; i < run.end(); ++i)
    if (document.entities.find<world::Equipment>(document.track.segments[i]) != nullptr) return true;
  return false;
}

// Gives the section the fit's shape and its last knot the fit's spin; the following track does not move.
void put_end(Document& document, const SectionRun& run, const sim::ElementFit& fit) {
  reshape(document, run.section, fit, SectionEnd::moves);
  const std::size_t end = world::run_of(document, run.section).end();
  const auto& knots = document.track.knots;
  document.entities.get<Knot>(knots[end % knots.size()]).spin = fit.knots.back().spin;
}

}  // namespace

Status put_and_follow(Session& session, Change& change, Document& document, const SectionRun& run,
                      const sim::ElementFit& fit) {
  const Entity next = section_after(document, run);
  const auto home = world::completing(document, run.end());
  if (home && home->first == run.end()) return put_end(document, run, fit), Status{};
  const SectionKind kind = next.valid() ? world::section(document, next).kind : SectionKind::free;
  if (kind != SectionKind::element && kind != SectionKind::force) return put_in_place(document, run, fit);
  const BendAndSpin before = bend_and_spin(document, run);
  const base::Result<sim::Carry> carry = sim::carry_between(nth_knot(document, run.end()), fit.knots.back());
  Document moved = document;
  put_end(document, run, fit);
  if (carry && alike(before, bend_and_spin(document, world::run_of(document, run.section)), *carry)) {
    document = std::move(moved);
    return put_in_place(document, run, fit);
  }
  change.planned.push_back(next);
  if (has_equipment(document, run)) change.gained.reset();
  return kind == SectionKind::element
             ? replan(session, change, document, next, world::section(document, next).element, Following::planned)
             : replan_force(session, change, document, next);
}

Status replan_force(Session& session, Change& change, Document& document, Entity section) {
  const SectionRun run = world::run_of(document, section);
  put_speed(session, change, document, section);
  if (const std::optional<double> former = energy_at(session.document, section))
    change.gained = *energy_at(document, section) - *former;
  const sim::ForceTask task = sim::force_task(document, run, world::section(document, section).force);
  const sim::ForcePlan& plan = force_plans_of(session).plan(task);
  if (!plan.refusal.empty()) return refused(plan.refusal);
  if (const Status room = room_for_spans(session, document, run, plan.spans()); !room) return room;
  if (const std::string stopped = sim::stop_text(plan); !stopped.empty())
    change.clamped.push_back(base::sentence(stopped));
  if (!session.history.in_gesture) report_missed(plan, change);
  if (task.held) {
    if (const std::string unmet = sim::unmet_text(plan); !unmet.empty() && !session.history.in_gesture)
      change.clamped.push_back(unmet);
    return reshape(document, section, plan.fit.spans, SectionEnd::stays), Status{};
  }
  const sim::ElementFit fit = plan.fit.spans;  // the memory may move while what follows is planned
  return put_and_follow(session, change, document, run, fit);
}

bool follow_speeds(Session& session, Change& change) {
  std::vector<Entity> sections;
  const auto& all = session.document.entities.pool<world::Section>().items();
  const auto count = std::count_if(all.begin(), all.end(), [](const auto& s) { return s.kind == SectionKind::force; });
  if (count == 0) return false;
  force_plans_of(session).make_room(static_cast<std::size_t>(count));
  for (const SectionRun& run : world::sections_of(session.document)) sections.push_back(run.section);
  bool changed = false;
  for (const Entity section : sections) {
    const world::Section& value = world::section(session.document, section);
    if (value.kind != SectionKind::force) continue;
    const SectionRun run = world::run_of(session.document, section);
    world::ForceProgram program = value.force;
    const std::optional<double> speed = Finder(session).speed_at(session.derived.starts[run.first]);
    if (speed && !(std::abs(*speed - program.speed) <= kSameSpeed)) program.speed = *speed;
    const sim::ForceTask task = sim::force_task(session.document, run, program);
    if (force_plans_of(session).has(task)) continue;
    Document next = session.document;
    next.entities.get<world::Section>(section).force = program;
    change.gained.reset();
    Status status = replan_force(session, change, next, section);
    const bool differs = !(next == session.document);
    if (status && differs) status = adopt(session, change, session.document, std::move(next));
    if (!status) {
      change.clamped.push_back(
          base::sentence(fmt::format("{} keeps its shape: {}", world::words_of(value), status.message)));
    } else if (differs) {
      changed = true;
      change.planned.push_back(section);
      world::settle_joints(session.document);
      derive(session);
    }
  }
  return changed;
}

}  // namespace coaster::edit
