#include "edit/session/findings.h"

#include "edit/session/session.h"
#include "sim/shape/deviation.h"
#include "sim/study/near_misses.h"
#include "sim/study/seat.h"
#include "world/lab_view.h"

namespace coaster::edit {
namespace {

void find_ride(Session& session) {
  Findings& found = session.findings;
  found.ride = found.memory.rides.ride(session.document, session.derived, chosen_cart(session));
  found.tables = &found.memory.rides.tables(session.document, session.derived);
}

void update_riders(Session& session, sim::CarRange cars) {
  Findings& found = session.findings;
  found.riders = nullptr;
  if (found.ride == nullptr) return;
  found.memory.riders.update(*found.ride, *found.tables, session.derived, session.limits.envelope.cutoff, cars);
  found.riders = &found.memory.riders;
}

// Finds the riders of the selected seat, or with `all` of every car.
void find_riders(Session& session, bool all) {
  const int cars = session.findings.ride != nullptr ? session.findings.ride->start.cars : 1;
  const world::LabView& lab = *session.settings.lab;
  update_riders(session, sim::cars_of(all ? world::Seat::all : lab.seat, lab.seat_car, cars));
}

// Finds the values that colour the track: those of the middle car.
void find_values(Session& session) {
  Findings& found = session.findings;
  const world::Colouring colouring = session.settings.lab->colouring;
  const auto value = sim::ride_value_of(colouring);
  std::optional<sim::Rider> rider;
  if (base::row_of(colouring).of_ride && found.ride != nullptr) {
    const int middle = found.ride->start.cars / 2;
    rider = sim::Rider{found.ride, middle, {}, 0};
    if (value && sim::needs_samples(*value)) {
      update_riders(session, {middle, middle});
      rider = found.riders->car(middle);
    }
  }
  found.values = &found.memory.values.update(session.derived, session.settings, rider);
}

void find_overloads(Session& session) {
  Findings& found = session.findings;
  found.overloads = {};
  if (found.ride != nullptr)
    found.overloads = found.memory.overloads.get({found.ride->serial, session.limits.envelope},
                                                 [&] { return sim::red_spans(*found.ride, session.limits.envelope); });
}

// Requires the overloads.
void find_ratings(Session& session) {
  static const sim::Ratings kNone;
  Findings& found = session.findings;
  const sim::Envelope& envelope = session.limits.envelope;
  found.ratings = &kNone;
  if (found.ride == nullptr) return;
  found.ratings = &found.memory.ratings.get({found.ride->serial, session.derived.last_build, envelope}, [&] {
    found.memory.passed.update(session.derived);
    const sim::NearMisses misses = sim::near_misses(*found.ride, session.derived, &found.memory.passed);
    return sim::rate(*found.ride, *found.tables, envelope.cutoff, {misses.count(), found.overloads});
  });
}

void find_jolts(Session& session) {
  Findings& found = session.findings;
  const double cutoff = session.limits.envelope.cutoff;
  found.jolts = {};
  if (found.ride != nullptr)
    found.jolts = found.memory.jolts.get({found.ride->serial, cutoff}, [&] { return sim::jolts(*found.ride, cutoff); });
}

// Requires the riders.
void find_sections(Session& session) {
  Findings& found = session.findings;
  const world::LabView& lab = *session.settings.lab;
  const sim::CarRange cars =
      found.ride != nullptr ? sim::cars_of(lab.seat, lab.seat_car, found.ride->start.cars) : sim::CarRange{};
  sim::SectionTable& kept = found.memory.sections.value;
  const std::uint64_t serial = kept.serial + 1, ride = found.ride != nullptr ? found.ride->serial : 0;
  found.sections =
      &found.memory.sections.get({session.edits, session.derived.last_build, ride, cars.first, cars.last}, [&] {
        std::vector<sim::Rider> riders;
        if (found.ride != nullptr) riders = found.riders->cars(cars);
        return sim::SectionTable{sim::section_figures(session.document, session.derived, riders), serial};
      });
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
  if (has(wanted, Want::ride | Want::ratings | Want::overloads | Want::seat | Want::riders | Want::jolts |
                      Want::circuit | Want::sections) ||
      (has(wanted, Want::values) && by_ride))
    find_ride(session);
  if (has(wanted, Want::seat | Want::riders | Want::sections)) find_riders(session, has(wanted, Want::riders));
  if (has(wanted, Want::overloads | Want::ratings)) find_overloads(session);
  if (has(wanted, Want::ratings)) find_ratings(session);
  if (has(wanted, Want::jolts)) find_jolts(session);
  if (has(wanted, Want::conflicts | Want::room | Want::circuit))
    found.conflicts = memory.conflicts.update(session.derived);
  else if (has(wanted, Want::conflicts_so_far))
    found.conflicts = memory.conflicts.update(session.derived, sim::Conflicts::kSlice);
  found.all_conflicts = memory.conflicts.is_complete();
  if (has(wanted, Want::folds)) found.folds = memory.folds.update(session.derived);
  if (has(wanted, Want::tight_bends)) found.tight_bends = memory.tight_bends.update(session.derived);
  if (has(wanted, Want::element | Want::room)) {
    const bool of_forces = world::is_of_forces(element.kind);
    found.element = &memory.elements.plan(element, session.document,
                                          of_forces ? speed_at(session, session.derived.length) : std::nullopt);
  }
  if (has(wanted, Want::room))
    found.room =
        memory.room.update(*found.element, memory.conflicts, session.derived, world::rails_height(session.document));
  if (has(wanted, Want::circuit))
    found.circuit = &memory.circuit.update(session.document, session.derived, memory.conflicts, found.ride);
  if (has(wanted, Want::sections)) find_sections(session);
  if (has(wanted, Want::breaks)) found.breaks = memory.breaks.update(session.derived);
  if (has(wanted, Want::values)) find_values(session);
  if (has(wanted, Want::supports)) {
    memory.near.update(session.derived);
    memory.supports.update(session.derived, memory.near);
    found.supports = &memory.supports;
  }
  if (has(wanted, Want::deviation)) find_deviation(session);
  if (has(wanted, Want::chord_error))
    found.chord_error = memory.chord_error.get({session.derived.last_build, session.derived.steps},
                                               [&] { return sim::chord_error(session.derived); });
  return found;
}

void look_from(Session& session, const sim::Surroundings& around) { session.findings.memory.near.look_from(around); }

std::optional<double> speed_at(Session& session, double distance) {
  const world::Document& document = session.document;
  if (document.track.segments.empty()) return document.start_speed;
  const sim::Ghost* const ride =
      session.findings.memory.rides.ride(document, session.derived, world::first_cart(document));
  if (ride == nullptr) return std::nullopt;
  const auto found = sim::passing(*ride, distance);
  return found ? std::optional(found->speed) : std::nullopt;
}

double way_jolt(Session& session, std::size_t index) {
  const sim::CircuitProposals& found = *find(session, Want::circuit).circuit;
  return session.findings.memory.way_jolts.worst(found, index, session.document, session.edits, chosen_cart(session),
                                                 session.limits.envelope.cutoff);
}

const sim::ForcePlan* force_plan(Session& session, world::Entity section) {
  const world::Document& document = session.document;
  const world::Section* const value = document.entities.find<world::Section>(section);
  if (value == nullptr || value->kind != world::SectionKind::force) return nullptr;
  return &session.findings.memory.forces.plan(
      sim::force_task(document, world::run_of(document, section), value->force));
}

}  // namespace coaster::edit
