// Commands of the palette: place an element at the open end, select and preview one.
#include <algorithm>

#include <fmt/format.h>

#include "base/units.h"
#include "edit/commands/commands_elements.h"
#include "edit/perform/replan.h"
#include "sim/study/complete_circuit.h"
#include "sim/study/jolt.h"
#include "world/aid_settings.h"
#include "world/element_rows.h"
#include "world/evaluation_settings.h"
#include "world/sections.h"
#include "world/topology.h"

namespace coaster::edit {
namespace {

using base::Status;

// Reports what was placed, or else its warnings.
void report(const sim::ElementPlan& plan, double missing, const world::Document& document, Change& change) {
  change.clamped.insert(change.clamped.end(), plan.lines.begin(), plan.lines.end());
  if (const double depth = sim::depth_of(plan, sim::Land(document.park)); depth > 0)
    change.clamped.push_back(depth_text("element", depth, document));
  if (missing > 0)
    change.clamped.push_back(
        fmt::format("The element is {:.1f} m too close to other track for a train to pass.", missing));
  if (!plan.forces && !plan.fit.within)
    change.clamped.push_back(fmt::format("The fit error is {} m because the element is far from the origin.",
                                         base::to_text(static_cast<float>(plan.fit.error))));
  if (plan.forces || !change.clamped.empty()) return;  // the warning should be the newest notice
  change.note = fmt::format("Placed {}: {:.1f} m, fit error {:.1f} mm.", world::words_of(plan.element.kind),
                            plan.length, plan.fit.error * 1000);
}

}  // namespace

void open_out(world::Document& document, const world::Knot& start) {
  if (document.track.knots.empty()) {
    world::append_knot(document, start);
    return;
  }
  world::Knot& last = document.entities.get<world::Knot>(document.track.knots.back());
  last.joint = world::JointKind::aligned;
  last.out_length = start.out_length;
}

world::Entity append_section(world::Document& document, const std::vector<world::Knot>& knots, world::Section section) {
  open_out(document, knots.front());
  for (std::size_t k = 1; k < knots.size(); ++k) world::append_knot(document, knots[k]);
  const std::size_t spans = knots.size() - 1;
  return world::make_section(document, document.track.segments.size() - spans, spans, std::move(section));
}

world::Entity place(world::Document& document, const sim::ElementPlan& plan) {
  world::Section section{{}, world::SectionKind::element, world::limited(plan.element)};
  if (plan.forces)
    section = {std::string(base::row_of(plan.element.kind).label), world::SectionKind::force, {}, {}, *plan.forces};
  const std::size_t first = document.track.segments.size();
  const world::Entity placed = append_section(document, plan.fit.knots, std::move(section));
  equip(document, plan, first);
  return placed;
}

void equip(world::Document& document, const sim::ElementPlan& plan, std::size_t first) {
  for (const sim::EquippedSpans& part : plan.equipment)
    for (std::size_t i = 0; i < part.spans; ++i)
      document.entities.put(document.track.segments[first++], part.equipment);
}

void add_first_train(world::Document& document) {
  if (document.entities.pool<world::Train>().size() == 0)
    world::add_cart(document, document.track.segments.front(), 0.0);
}

Status perform(Session& session, Change& change, const PlaceElement& command) {
  if (const Status good = well_formed(command.what); !good) return good;
  world::Document& document = session.document;
  const sim::ElementPlan& plan = SessionFindings(session).element(command.what);
  if (!plan.refusal.empty()) return refused(plan.refusal);
  const std::size_t knots = std::max<std::size_t>(document.track.knots.size(), 1) + plan.spans();
  if (const Status room = room_for(session, knots, knots - 1); !room) return room;
  const double missing = sim::worst(SessionFindings(session).room(command.what));
  const world::Entity section = place(document, plan);
  change.select = plan.forces ? section : document.track.knots.back();
  if (document.track.segments.size() == plan.spans()) add_first_train(document);
  if (plan.forces) report_forces(*SessionFindings(session).force(section), change);
  report(plan, missing, document, change);
  return {};
}

Status perform(Session& session, Change& change, const CompleteCircuit& command) {
  if (command.proposal < 1 || command.proposal > static_cast<int>(sim::kMostProposals))
    return refused(fmt::format("expected a proposal from 1 to {}", sim::kMostProposals));
  const sim::CircuitProposals& found = SessionFindings(session).circuit();
  if (!found.refusal.empty()) return refused(found.refusal);
  if (static_cast<std::size_t>(command.proposal) > found.list.size())
    return refused(fmt::format("there {} {} proposal{}", found.list.size() == 1 ? "is" : "are", found.list.size(),
                               found.list.size() == 1 ? "" : "s"));
  const sim::CircuitProposal& proposal = found.list[static_cast<std::size_t>(command.proposal) - 1];
  const std::vector<world::Knot>& knots = proposal.plan.fit.knots;
  if (const Status room = room_for(session, knots.size() - 2, knots.size() - 1); !room) return room;
  const double jolt = SessionFindings(session).closing_jolt(static_cast<std::size_t>(command.proposal) - 1);
  change.select = sim::close_by(session.document, proposal);
  if (jolt > sim::kJoltLimit)
    change.clamped.push_back(fmt::format("A joint of the closing section jolts riders by {} g. Worst jolt finds it.",
                                         base::figure_text(jolt, 1, "g")));
  change.note = fmt::format(
      "Completed the circuit: {:.1f} m, {} {}, at most {:.1f} g.{}", proposal.plan.length, proposal.plan.spans(),
      proposal.plan.spans() == 1 ? "span" : "spans", proposal.felt.most,
      found.assumed ? fmt::format(" No train reaches the open end: planned for {} m/s.", base::to_text(found.speed))
                    : "");
  return {};
}

Status perform(Session& session, Change&, const ChooseElement& command) {
  if (const Status good = well_formed(command.what); !good) return good;
  session.settings.element = command.what;
  session.settings.aids->show_element = true;
  return {};
}

}  // namespace coaster::edit
