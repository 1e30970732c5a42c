#include "edit/session/findings.h"

#include "edit/session/session.h"
#include "world/lab_view.h"

namespace coaster::edit {
namespace {

void find_ride(Session& session) {
  Findings& found = session.findings;
  found.ride = found.memory.rides.ride(session.document, session.derived, chosen_cart(session));
  found.tables = &found.memory.rides.tables(session.document, session.derived);
}

void find_ratings(Session& session) {
  static const sim::Ratings kNone;
  Findings& found = session.findings;
  const double cutoff = session.limits.envelope.cutoff;
  found.ratings = &kNone;
  if (found.ride != nullptr)
    found.ratings = &found.memory.ratings.get({found.ride->serial, cutoff},
                                              [&] { return sim::rate(*found.ride, *found.tables, cutoff); });
}

void find_overloads(Session& session) {
  Findings& found = session.findings;
  found.overloads = {};
  if (found.ride != nullptr)
    found.overloads = found.memory.overloads.get({found.ride->serial, session.limits.envelope},
                                                 [&] { return sim::red_spans(*found.ride, session.limits.envelope); });
}

void find_deviation(Session& session) {
  Findings& found = session.findings;
  found.deviation = 0;
  if (!session.game.challenge) return;
  std::pair traces{sim::trace_of(session.document), session.game.challenge->shape};
  found.deviation =
      found.memory.deviation.get(traces, [&] { return sim::shape_distance(traces.first, traces.second); });
}

}  // namespace

const Findings& find(Session& session, Want wanted) { return find(session, wanted, session.settings.element); }

const Findings& find(Session& session, Want wanted, const world::Element& element) {
  Findings& found = session.findings;
  Findings::Memory& memory = found.memory;
  const bool by_ride = base::row_of(session.settings.lab->colouring).of_ride;
  if (has(wanted, Want::document_hash))
    found.document_hash = memory.document_hash.get(session.edits, [&] { return world::hash(session.document); });
  if (has(wanted, Want::ride | Want::ratings | Want::overloads) || (has(wanted, Want::values) && by_ride))
    find_ride(session);
  if (has(wanted, Want::ratings)) find_ratings(session);
  if (has(wanted, Want::overloads)) find_overloads(session);
  if (has(wanted, Want::conflicts | Want::room)) found.conflicts = memory.conflicts.update(session.derived);
  if (has(wanted, Want::element | Want::room)) found.element = &memory.elements.plan(element, session.document);
  if (has(wanted, Want::room)) found.room = memory.room.update(*found.element, memory.conflicts, session.derived);
  if (has(wanted, Want::breaks)) found.breaks = memory.breaks.update(session.derived);
  if (has(wanted, Want::values))
    found.values = &memory.values.update(session.derived, session.settings, by_ride ? found.ride : nullptr);
  if (has(wanted, Want::supports)) {
    memory.supports.update(session.derived);
    found.supports = &memory.supports;
  }
  if (has(wanted, Want::deviation)) find_deviation(session);
  return found;
}

}  // namespace coaster::edit
