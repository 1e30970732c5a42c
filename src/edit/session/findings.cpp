#include "edit/session/findings.h"

#include <algorithm>
#include <utility>

#include "edit/session/findings_memory.h"
#include "sim/shape/shape_distance.h"
#include "sim/study/ratings.h"
#include "sim/study/riders.h"
#include "world/evaluation_settings.h"
#include "world/heap_value_functions.h"
#include "world/laboratory_settings.h"

namespace coaster::world {
using Memory = edit::FindingsCache;
template HeapValue<Memory>::HeapValue();
template HeapValue<Memory>::HeapValue(const HeapValue<Memory>&);
template HeapValue<Memory>& HeapValue<Memory>::operator=(const HeapValue<Memory>&);
template HeapValue<Memory>::~HeapValue();
}  // namespace coaster::world

namespace coaster::edit {

sim::RideCache& rides_of(Session& session) { return session.findings->rides; }
sim::ForcePlanCache& force_plans_of(Session& session) { return session.findings->forces; }
const sim::ForcePlanCache& force_plans_of(const Session& session) { return session.findings->forces; }
sim::OpenedTrack& opened_track_of(Session& session) { return session.findings->opened; }

FindingsCache& SessionFindings::memory() const { return *session_->findings; }

std::uint64_t SessionFindings::document_hash() const {
  return memory().document_hash.get(session_->edits, [&] { return world::hash(session_->document); });
}

const sim::SimulatedRide* SessionFindings::ride() const {
  return memory().rides.ride(session_->document, session_->derived, chosen_cart(*session_));
}

const sim::RailTables& SessionFindings::tables() const {
  return memory().rides.tables(session_->document, session_->derived);
}

const sim::Ratings& SessionFindings::ratings() const {
  static const sim::Ratings kNone;
  const sim::SimulatedRide* const found = ride();
  if (found == nullptr) return kNone;
  const sim::ForceLimitCurves& envelope = force_limits(*session_);
  const sim::Ground& land = ground();
  return memory().ratings.get({found->serial, session_->derived.last_build, land.build(), envelope}, [&] {
    memory().passed.update(session_->derived, {}, &land);
    const sim::NearMisses misses = sim::near_misses(*found, session_->derived, &memory().passed);
    sim::Surroundings around;
    if (!land.plain()) around = sim::surroundings_of(*found, session_->derived, land, plants());
    return sim::rate(*found, tables(), envelope.cutoff, {misses.count(), overloads(), around});
  });
}

std::span<const sim::Overload> SessionFindings::overloads() const {
  const sim::SimulatedRide* const found = ride();
  if (found == nullptr) return {};
  const sim::ForceLimitCurves& envelope = force_limits(*session_);
  return memory().overloads.get({found->serial, envelope}, [&] { return sim::red_spans(*found, envelope); });
}

std::span<const sim::Jolt> SessionFindings::jolts() const {
  const sim::SimulatedRide* const found = ride();
  if (found == nullptr) return {};
  const double cutoff = force_limits(*session_).cutoff;
  return memory().jolts.get({found->serial, cutoff}, [&] { return sim::jolts(*found, cutoff); });
}

const sim::Riders* SessionFindings::riders_of(bool all) const {
  const sim::SimulatedRide* const found = ride();
  if (found == nullptr) return nullptr;
  const world::LabView& lab = *session_->settings.lab;
  const sim::CarRange cars = sim::cars_of(all ? world::Seat::all : lab.seat, lab.seat_car, found->start.cars);
  memory().riders.update(*found, tables(), session_->derived, force_limits(*session_).cutoff, cars);
  return &memory().riders;
}
const sim::Riders* SessionFindings::seat() const { return riders_of(false); }
const sim::Riders* SessionFindings::riders() const { return riders_of(true); }

std::optional<double> SessionFindings::speed_at(double distance) const {
  const world::Document& document = session_->document;
  if (document.track.segments.empty()) return document.start_speed;
  const sim::SimulatedRide* const found = memory().rides.ride(document, session_->derived, world::first_cart(document));
  if (found == nullptr) return std::nullopt;
  const auto passed = sim::passing(*found, distance);
  return passed ? std::optional(passed->speed) : std::nullopt;
}

const sim::TrackValues& SessionFindings::values() const {
  const world::Colouring colouring = session_->settings.lab->colouring;
  const auto value = sim::ride_value_of(colouring);
  const sim::SimulatedRide* const found = base::row_of(colouring).of_ride ? ride() : nullptr;
  std::optional<sim::Rider> rider;
  if (found != nullptr) {
    const int middle = found->start.cars / 2;
    rider = sim::Rider{found, middle, {}, 0};
    if (value && sim::needs_samples(*value)) {
      const double cutoff = force_limits(*session_).cutoff;
      memory().riders.update(*found, tables(), session_->derived, cutoff, {middle, middle});
      rider = memory().riders.car(middle);
    }
  }
  return memory().values.update(session_->derived, session_->settings, rider);
}

const sim::SectionTable& SessionFindings::sections() const {
  const sim::Riders* const felt = seat();
  const sim::SimulatedRide* const found = ride();
  const world::LabView& lab = *session_->settings.lab;
  const sim::CarRange cars =
      found != nullptr ? sim::cars_of(lab.seat, lab.seat_car, found->start.cars) : sim::CarRange{};
  const std::uint64_t serial = memory().sections.value.serial + 1, of_ride = found != nullptr ? found->serial : 0;
  return memory().sections.get({session_->edits, session_->derived.last_build, of_ride, cars.first, cars.last}, [&] {
    std::vector<sim::Rider> riders;
    if (found != nullptr) riders = felt->cars(cars);
    return sim::SectionTable{sim::section_figures(session_->document, session_->derived, riders), serial};
  });
}

std::span<const sim::Conflict> SessionFindings::conflicts() const {
  return memory().conflicts.update(session_->derived);
}
std::span<const sim::Conflict> SessionFindings::conflicts_so_far() const {
  return memory().conflicts.update(session_->derived, sim::Conflicts::kSlice);
}
bool SessionFindings::all_conflicts() const { return memory().conflicts.is_complete(); }
std::span<const sim::Fold> SessionFindings::folds() const { return memory().folds.update(session_->derived); }
std::span<const sim::Fold> SessionFindings::tight_bends() const {
  return memory().tight_bends.update(session_->derived);
}
std::span<const sim::FrenetBreak> SessionFindings::breaks() const { return memory().breaks.update(session_->derived); }

const sim::Supports& SessionFindings::supports() const {
  memory().near.update(session_->derived);
  memory().supports.update(session_->derived, memory().near, &ground());
  return memory().supports;
}
void SessionFindings::look_from(const sim::EyeSurroundings& around) const { memory().near.look_from(around); }

const sim::Ground& SessionFindings::ground() const {
  const sim::CoasterForm& form = sim::form_of(session_->document.kind);
  memory().ground.update(session_->document, session_->derived, sim::track_room(form));
  return memory().ground;
}

const sim::Plants& SessionFindings::plants() const {
  memory().plants.update(ground());
  return memory().plants;
}

const sim::StationBuildings& SessionFindings::stations() const {
  const sim::Ground& on = ground();
  sim::StationBuildings& known = memory().stations.value;
  return memory().stations.get({session_->edits, on.build()}, [&] {
    sim::Mesh made = sim::station_mesh(session_->derived, on, session_->document.name);
    const bool same = std::ranges::equal(made.vertices, known.mesh.vertices, {}, &sim::MeshVertex::position,
                                         &sim::MeshVertex::position);
    return sim::StationBuildings{std::move(made), known.build + (same ? 0 : 1)};
  });
}

std::span<const sim::FloodedTrack> SessionFindings::flooded() const {
  const sim::Ground& land = ground();
  return memory().flooded.get(land.build(), [&] { return sim::flooded_track(land); });
}

double SessionFindings::chord_error() const {
  return memory().chord_error.get({session_->derived.last_build, session_->derived.steps},
                                  [&] { return sim::chord_error(session_->derived); });
}

double SessionFindings::deviation() const {
  if (!session_->game.challenge) return 0;
  std::pair traces{sim::trace_of(session_->document), session_->game.challenge->shape};
  return memory().deviation.get(traces, [&] { return sim::shape_distance(traces.first, traces.second); });
}

const sim::ElementPlan& SessionFindings::element() const { return element(session_->settings.element); }
const sim::ElementPlan& SessionFindings::element(const world::Element& element) const {
  const bool of_forces = world::is_of_forces(element.kind);
  return memory().elements.plan(element, session_->document,
                                of_forces ? speed_at(session_->derived.length) : std::nullopt);
}

std::span<const sim::LineConflict> SessionFindings::room() const { return room(session_->settings.element); }
std::span<const sim::LineConflict> SessionFindings::room(const world::Element& element) const {
  (void)conflicts();
  return memory().room.update(this->element(element), memory().conflicts, session_->derived,
                              world::rails_height(session_->document));
}

const sim::CircuitProposals& SessionFindings::circuit() const {
  (void)conflicts();
  return memory().circuit.update(session_->document, session_->derived, memory().conflicts, ride());
}

double SessionFindings::closing_jolt(std::size_t index) const {
  return memory().closing_jolts.worst(circuit(), index, session_->document, session_->edits, chosen_cart(*session_),
                                      force_limits(*session_).cutoff);
}

const sim::ForcePlan* SessionFindings::force(world::Entity section) const {
  const world::Document& document = session_->document;
  const world::Section* const value = document.entities.find<world::Section>(section);
  if (value == nullptr || value->kind != world::SectionKind::force) return nullptr;
  return &memory().forces.plan(sim::force_task(document, world::run_of(document, section), value->force));
}

}  // namespace coaster::edit
