#include "ui/tools/show_places.h"

#include <algorithm>

#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_sections.h"
#include "edit/commands/commands_settings.h"
#include "edit/commands/set_setting.h"
#include "sim/plan/element_plan.h"
#include "sim/solids/conflict_types.h"
#include "sim/study/complete_circuit.h"
#include "sim/study/jolt.h"
#include "world/aid_settings.h"
#include "world/element_rows.h"
#include "world/equipment_rows.h"
#include "world/panel_settings.h"
#include "world/sections.h"

namespace coaster::ui {
namespace {

using world::ElementKind;
using world::EquipmentKind;

constexpr std::string_view kEquipment = "equipment";
constexpr double kNone = 0;

bool in_build(const edit::Session& session) {
  return session.settings.panels->workspace == world::Workspace::build && !session.game.challenge;
}

// True if a lift or launch gives trains their speed.
bool drives_trains(const world::Document& document) {
  return std::ranges::any_of(document.entities.pool<world::Equipment>().items(),
                             [](const world::Equipment& equipment) { return base::row_of(equipment.kind).drives; });
}

// Returns the equipment offered for an element that has none.
double offered(const edit::Session& session, ElementKind kind) {
  if (kind == ElementKind::straight && session.document.track.segments.empty())
    return world::equipment_choice(EquipmentKind::station);
  if (kind == ElementKind::climb && !drives_trains(session.document))
    return world::equipment_choice(EquipmentKind::lift);
  return kNone;
}

double selected_distance(const edit::Session& session) {
  const sim::SegmentShape* const shape = session.derived.segments.find(session.settings.selected);
  const auto index = shape ? world::index_of(session.derived.order, session.settings.selected) : std::nullopt;
  return index ? session.derived.starts[*index] + shape->arc.distance(session.settings.selected_t) : -1;
}

// Selects the segment at `distance` and points the orbit camera at `target`, from between `near` and `far` m.
void look_at(Ui& ui, double distance, glm::vec3 target, float near, float far) {
  const edit::Session& session = ui.session();
  const sim::TrackPlace place = sim::place_at(session.derived, distance);
  const world::Entity segment = session.derived.order[place.index];
  ui.emit(
      edit::Select{{world::name_of(session.document, segment)}, session.derived.shape(segment).arc.parameter(place.s)});
  world::Camera camera = session.settings.camera;
  camera.target = target;
  camera.distance = std::clamp(camera.distance, near, far);
  ui.emit(edit::set_camera(camera));
  if (session.settings.camera_mode != world::CameraMode::orbit)
    ui.emit(edit::Set<&world::Settings::camera_mode>{world::CameraMode::orbit});
}

// Returns the first of the positions found, in track order, that is after the selected one; null if there are none.
template <class Found>
const Found* next_of(Ui& ui, std::span<const Found> found) {
  constexpr double kHere = 1e-3;  // m: closer positions are the selected one
  if (found.empty()) return nullptr;
  const double from = selected_distance(ui.session());
  const auto later = std::find_if(found.begin(), found.end(), [&](const Found& one) { return one.at > from + kHere; });
  return later == found.end() ? &found.front() : &*later;
}

}  // namespace

void choose_element(Ui& ui, ElementKind kind) {
  const world::Element& last = ui.session().settings.element;
  world::Element element = last.kind == kind ? last : ui.inputs.elements[static_cast<std::size_t>(kind)];
  if (in_build(ui.session()) && world::found_value(element, kEquipment) == kNone)
    world::set_value(element, kEquipment, offered(ui.session(), kind));
  ui.emit(edit::ChooseElement{element});
}

void place_shown_element(Ui& ui) {
  world::Element element = ui.session().settings.element;
  ui.emit(edit::PlaceElement{element});
  const bool placed = ui.find.element().refusal.empty();
  if (!placed || !in_build(ui.session()) || world::found_value(element, kEquipment).value_or(kNone) == kNone) return;
  world::set_value(element, kEquipment, kNone);
  ui.emit(edit::ChooseElement{element});
}

bool completable(const world::Document& document) { return !document.track.closed && !document.track.segments.empty(); }

std::size_t shown_proposal(const world::EditingAids& aids, const sim::CircuitProposals& found) {
  const auto wanted = static_cast<std::size_t>(std::max(aids.circuit, 1));
  return std::min(wanted, std::max<std::size_t>(found.list.size(), 1)) - 1;
}

void show_proposals(Ui& ui) {
  if (ui.session().settings.aids->show_element) ui.emit(edit::Set<&world::EditingAids::show_element>{false});
  ui.emit(edit::Set<&world::EditingAids::circuit>{1});
}

void toggle_proposals(Ui& ui) {
  if (ui.session().settings.aids->circuit > 0) ui.emit(edit::Set<&world::EditingAids::circuit>{0});
  else show_proposals(ui);
}

void next_proposal(Ui& ui) {
  const sim::CircuitProposals& found = ui.find.circuit();
  if (found.list.empty()) return;
  const std::size_t next = (shown_proposal(*ui.session().settings.aids, found) + 1) % found.list.size();
  ui.emit(edit::Set<&world::EditingAids::circuit>{static_cast<int>(next) + 1});
}

void place_proposal(Ui& ui) {
  const sim::CircuitProposals& found = ui.find.circuit();
  ui.emit(edit::CompleteCircuit{static_cast<int>(shown_proposal(*ui.session().settings.aids, found)) + 1});
  if (!found.list.empty()) ui.emit(edit::Set<&world::EditingAids::circuit>{0});
}

std::vector<glm::vec3> preview_points(const Ui& ui) {
  std::vector<glm::vec3> points;
  const world::EditingAids& aids = *ui.session().settings.aids;
  const auto add = [&](const sim::ElementPlan& plan) {
    if (plan.refusal.empty())
      for (const world::Knot& knot : plan.fit.knots) points.emplace_back(knot.position);
  };
  if (aids.circuit > 0 && completable(ui.session().document)) {
    if (ui.session().history.in_gesture) return points;  // a search would hold up each frame of a drag
    const sim::CircuitProposals& ways = ui.find.circuit();
    if (!ways.list.empty()) add(ways.list[shown_proposal(aids, ways)].plan);
  } else if (aids.show_element) {
    add(ui.find.element());
  }
  return points;
}

bool rideable(const edit::Session& session) {
  return session.document.entities.pool<world::Train>().size() > 0 && !session.document.track.segments.empty();
}

bool append_mode_switches(const edit::Session& session) {
  return session.settings.aids->append_mode || !session.document.track.closed;
}

bool card_shows(const edit::Session& session) {
  return session.settings.aids->show_card && session.game.show_result && session.game.result;
}

std::optional<double> failed_place(const edit::Session& session) {
  if (!session.game.result) return std::nullopt;
  if (session.game.result->verdict && session.game.result->verdict->place) return session.game.result->verdict->place;
  return session.game.result->end == edit::RideEnd::failed ? session.game.result->place : std::nullopt;
}

std::optional<world::Entity> climb_without_lift(const edit::Session& session) {
  const world::Document& document = session.document;
  if (session.game.challenge || !session.game.result || !session.game.result->below_top ||
      session.derived.order.empty())
    return std::nullopt;
  const world::Entity segment =
      session.derived.order[sim::place_at(session.derived, *session.game.result->place).index];
  const world::Entity section = world::segment(document, segment).section;
  if (world::is_free(document, section) || document.entities.find<world::Equipment>(segment)) return std::nullopt;
  return section;
}

void show_place(Ui& ui, double distance) {
  const sim::DerivedTrack& derived = ui.session().derived;
  if (derived.order.empty()) return;
  const sim::TrackPlace place = sim::place_at(derived, distance);
  const sim::SegmentShape& shape = derived.shape(derived.order[place.index]);
  const glm::vec3 target(curve::point(shape.key.cubic, shape.arc.parameter(place.s)));
  look_at(ui, distance, target, 18, 36);
  if (card_shows(ui.session())) ui.emit(edit::CloseCard{});
}

void show_next_conflict(Ui& ui) {
  if (const auto* const next = next_of(ui, ui.find.conflicts()))
    look_at(ui, next->at, 0.5f * (next->at_place + next->other_place), 0, 24);
}

void show_next(Ui& ui, std::span<const sim::Fold> found) {
  if (const auto* const next = next_of(ui, found)) look_at(ui, next->at, next->place, 0, 24);
}

void show_knot(Ui& ui, world::Entity knot) {
  const world::Document& document = ui.session().document;
  const auto index = world::index_of(document.track.knots, knot);
  if (!index) return;
  look_at(ui, ui.session().derived.starts[*index], world::knot(document, knot).position, 0, 24);
  ui.emit(edit::Select{{world::name_of(document, knot)}, 0});  // rather than the segment that starts there
}

void show_worst_jolt(Ui& ui) {
  const std::span<const sim::Jolt> jolts = ui.find.jolts();
  const auto worst = std::max_element(jolts.begin(), jolts.end(),
                                      [](const sim::Jolt& a, const sim::Jolt& b) { return a.total < b.total; });
  if (worst == jolts.end() || !(worst->total > 0)) return;
  show_knot(ui, ui.session().document.track.knots[static_cast<std::size_t>(worst - jolts.begin())]);
}

}  // namespace coaster::ui
