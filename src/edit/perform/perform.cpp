// Checks and limits that commands share.
#include "edit/perform/perform.h"
#include "world/evaluation.h"

#include <algorithm>
#include <cmath>

namespace coaster::edit {
namespace {

template <class T, class Print>
T cut(std::vector<std::string>& lines, std::string_view what, T value, T low, T high, std::string_view unit,
      Print print) {
  if (value >= low && value <= high) return value;
  const T limit = value > high ? high : low;
  lines.push_back(std::string(what) + " " + print(value) + " is beyond the limit of " + print(limit) +
                  (unit.empty() ? "" : " ") + std::string(unit));
  return limit;
}

// Prints whole numbers in full: a limit of 100000 m, not 1e+05 m.
constexpr auto kPrintReal = [](auto value) {
  const bool plain = std::abs(value) < 1e9 && value == std::trunc(value);
  return plain ? std::to_string(static_cast<std::int64_t>(value)) : base::to_text(value);
};
constexpr auto kPrintWhole = [](auto value) { return std::to_string(value); };

}  // namespace

double Change::clamp(std::string_view what, double value, double low, double high, std::string_view unit) {
  return cut(clamped, what, value, low, high, unit, kPrintReal);
}
float Change::clamp(std::string_view what, float value, float low, float high, std::string_view unit) {
  return cut(clamped, what, value, low, high, unit, kPrintReal);
}
int Change::clamp(std::string_view what, int value, int low, int high, std::string_view unit) {
  return cut(clamped, what, value, low, high, unit, kPrintWhole);
}
std::int64_t Change::clamp(std::string_view what, std::int64_t value, std::int64_t low, std::int64_t high,
                           std::string_view unit) {
  return cut(clamped, what, value, low, high, unit, kPrintWhole);
}

glm::vec3 Change::clamp_position(std::string_view what, glm::vec3 position) {
  constexpr std::string_view kAxes[] = {".x", ".y", ".z"};
  for (int axis = 0; axis < 3; ++axis)
    position[axis] = clamp(std::string(what) + std::string(kAxes[axis]), position[axis], -world::kMaxCoordinate,
                           world::kMaxCoordinate, "m");
  return position;
}

base::Status refused(std::string message) { return {base::Code::refused, std::move(message)}; }

bool finite(glm::vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

base::Result<world::Entity> require(const Session& session, Target target, world::Kind kind) {
  const std::string wanted(base::name_of(kind));
  if (target.name.number == 0) return refused("expected a " + wanted + ", found none");
  const std::string label = "@" + world::to_text(target.name);
  if (target.name.kind != kind) return refused("expected a " + wanted + ", found " + label);
  const world::Entity e = world::find(session.document, target.name);
  if (!e.valid()) return refused("there is no " + wanted + " " + label);
  return e;
}

base::Status within_budget(std::size_t segments, int steps, std::int64_t budget) {
  const std::int64_t vertices = static_cast<std::int64_t>(segments) * (steps + 1);
  if (vertices <= budget) return {};
  return refused(std::to_string(segments) + " segments of " + std::to_string(steps) + " steps are " +
                 std::to_string(vertices) + " vertices, over the vertex budget of " + std::to_string(budget));
}

base::Status room_for(const Session& session, std::size_t knots, std::size_t segments) {
  if (knots > world::kMaxKnots)
    return refused("the track is at the limit of " + std::to_string(world::kMaxKnots) + " knots");
  return within_budget(segments, session.settings.evaluation->steps, session.settings.evaluation->vertex_budget);
}

void fit_budget(Session& session) {
  const std::size_t segments = session.document.track.segments.size();
  int& steps = session.settings.evaluation->steps;
  if (within_budget(segments, steps, session.settings.evaluation->vertex_budget)) return;
  const std::int64_t fitting = session.settings.evaluation->vertex_budget / static_cast<std::int64_t>(segments) - 1;
  const int lowered = static_cast<int>(std::clamp<std::int64_t>(fitting, curve::kMinSteps, steps));
  notify(session, NoticeKind::warning,
         "resolution lowered from " + std::to_string(steps) + " to " + std::to_string(lowered) +
             " steps: the limit is the vertex budget of " + std::to_string(session.settings.evaluation->vertex_budget));
  steps = lowered;
}

}  // namespace coaster::edit
