// Checks and limits that commands share.
#include "edit/perform/perform_context.h"

#include <algorithm>
#include <cmath>

#include "sim/shape/detail_limits.h"
#include "world/element_rows.h"
#include "world/evaluation_settings.h"

namespace coaster::edit {
namespace {

// Prints whole numbers in full: a limit of 100000 m, not 1e+05 m.
template <class T>
std::string number_text(T value) {
  if constexpr (std::is_floating_point_v<T>)
    if (!(std::abs(value) < 1e9 && value == std::trunc(value))) return fmt::format("{:.6g}", value);
  return std::to_string(static_cast<std::int64_t>(value));
}

}  // namespace

template <class T>
T Change::clamp(std::string_view what, T value, std::type_identity_t<T> low, std::type_identity_t<T> high,
                std::string_view unit) {
  const T limit = std::clamp(value, low, high);
  if (limit != value)
    clamped.push_back(fmt::format("{} {} from {} to the limit of {}{}{}.", limit < value ? "Reduced" : "Raised", what,
                                  number_text(value), number_text(limit), unit.empty() ? "" : " ", unit));
  return limit;
}
template double Change::clamp(std::string_view, double, double, double, std::string_view);
template float Change::clamp(std::string_view, float, float, float, std::string_view);
template int Change::clamp(std::string_view, int, int, int, std::string_view);
template std::int64_t Change::clamp(std::string_view, std::int64_t, std::int64_t, std::int64_t, std::string_view);

glm::vec3 Change::clamp_position(std::string_view what, glm::vec3 position) {
  constexpr std::string_view kAxes[] = {".x", ".y", ".z"};
  for (int axis = 0; axis < 3; ++axis)
    position[axis] = clamp(fmt::format("{}{}", what, kAxes[axis]), position[axis], -world::kMaxCoordinate,
                           world::kMaxCoordinate, "m");
  return position;
}

void Change::warn_of(std::string text) {
  if (!text.empty()) clamped.push_back(base::sentence(std::move(text)));
}

const world::Document& former_document(const Session& session, bool from_start, world::Entity entity) {
  const History& history = session.history;
  const bool restarts =
      from_start && history.in_gesture && history.gesture_start.entities.find<world::EntityName>(entity) != nullptr;
  return restarts ? history.gesture_start : session.document;
}

void derive(Session& session) {
  const sim::SolidsDetail before = sim::detail_of(session.derived);
  sim::derive(session.document, session.settings, session.measuring.clock, session.derived);
  session.evaluated.rebuilds += session.derived.rebuilds;
  session.evaluated.seconds += session.derived.evaluation_seconds;
  session.evaluated.vertices += session.derived.evaluated_vertices;
  const sim::SolidsDetail now = sim::detail_of(session.derived);
  if (now == before) return;
  if (const std::string coarse = sim::detail_text(now); !coarse.empty()) notify(session, NoticeKind::warning, coarse);
}

void warn(Session& session, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) notify(session, NoticeKind::warning, warning);
}

base::Status refused(std::string message) { return {base::Code::refused, std::move(message)}; }

base::Result<world::Entity> require(const Session& session, Target target, world::EntityKind kind) {
  const std::string_view wanted = base::name_of(kind);
  if (target.name.number == 0) return refused(fmt::format("expected a {}, found none", wanted));
  const std::string name = world::to_text(target.name);
  if (target.name.kind != kind) return refused(fmt::format("expected a {}, found @{}", wanted, name));
  const world::Entity e = world::find(session.document, target.name);
  if (!e.valid()) return refused(fmt::format("there is no {} @{}", wanted, name));
  return e;
}

world::Entity entity_of(const Session& session, Target target) { return world::find(session.document, target.name); }

base::Status may_be_called(std::string_view name, std::string_view what) {
  if (name.size() > world::kMaxNameBytes)
    return refused(fmt::format("the {} is over the limit of {} bytes", what, world::kMaxNameBytes));
  if (base::is_printable_utf8(name)) return {};
  return refused(fmt::format("expected a {} in UTF-8 without control characters", what));
}

void shaped_by_hand(world::Knot& knot) {
  if (knot.joint == world::JointKind::automatic) knot.joint = world::JointKind::aligned;
}

void begin_there(world::Knot& knot, float out_length) {
  knot.out_length = out_length;
  if (knot.in_length != out_length) knot.joint = world::JointKind::aligned;
  shaped_by_hand(knot);
}

base::Status well_formed(const world::Element& element) {
  if (!base::has_row(element.kind)) return refused("there is no such element");
  return {};
}

base::Status within(std::string_view what, double value, double low, double high, std::string_view unit) {
  if (value >= low && value <= high) return {};
  return refused(fmt::format("expected {} from {} to {}{}{}, found {}", what, number_text(low), number_text(high),
                             unit.empty() ? "" : " ", unit, number_text(value)));
}

base::Status within_budget(std::size_t segments, int steps, std::int64_t budget) {
  const std::int64_t vertices = static_cast<std::int64_t>(segments) * (steps + 1);
  if (vertices <= budget) return {};
  return refused(fmt::format("{} segments of {} steps are {} vertices, over the vertex budget of {}", segments, steps,
                             vertices, budget));
}

base::Status room_for(const Session& session, std::size_t knots, std::size_t segments) {
  if (knots > world::kMaxKnots) return refused(fmt::format("the track is at the limit of {} knots", world::kMaxKnots));
  return within_budget(segments, session.settings.evaluation->steps, session.settings.evaluation->vertex_budget);
}

void fit_budget(Session& session) {
  const std::size_t segments = session.document.track.segments.size();
  int& steps = session.settings.evaluation->steps;
  if (within_budget(segments, steps, session.settings.evaluation->vertex_budget)) return;
  const std::int64_t fitting = session.settings.evaluation->vertex_budget / static_cast<std::int64_t>(segments) - 1;
  const int lowered = static_cast<int>(std::clamp<std::int64_t>(fitting, curve::kMinSteps, steps));
  notify(session, NoticeKind::warning,
         fmt::format("Resolution lowered from {} to {} steps: the limit is the vertex budget of {}.", steps, lowered,
                     session.settings.evaluation->vertex_budget));
  steps = lowered;
}

}  // namespace coaster::edit
