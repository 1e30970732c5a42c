#include "ui/actions/conflict_tour.h"

#include <algorithm>

namespace coaster::ui {
namespace {

double selected_distance(const edit::Session& session) {
  const sim::SegmentShape* const shape = session.derived.segments.find(session.settings.selected);
  const auto index = shape ? world::index_of(session.derived.order, session.settings.selected) : std::nullopt;
  return index ? session.derived.starts[*index] + shape->arc.distance(session.settings.selected_t) : -1;
}

}  // namespace

void show_next_conflict(Ui& ui) {
  constexpr float kNear = 24;     // m, or nearer where the eye is already
  constexpr double kHere = 1e-3;  // m: the one that is selected
  const edit::Session& session = ui.session();
  const std::span<const sim::Conflict> found = ui.find(edit::Want::conflicts).conflicts;
  if (found.empty()) return;
  const double from = selected_distance(session);
  const auto later = std::find_if(found.begin(), found.end(),
                                  [&](const sim::Conflict& conflict) { return conflict.at > from + kHere; });
  const sim::Conflict& next = later == found.end() ? found.front() : *later;
  const sim::TrackPlace place = sim::place_at(session.derived, next.at);
  const world::Entity segment = session.derived.order[place.index];
  ui.emit(
      edit::Select{{world::name_of(session.document, segment)}, session.derived.shape(segment).arc.parameter(place.s)});
  world::Camera camera = session.settings.camera;
  camera.target = 0.5f * (next.at_place + next.other_place);
  camera.distance = std::min(camera.distance, kNear);
  ui.emit(edit::SetCamera{camera});
  if (session.settings.camera_mode != world::CameraMode::orbit)
    ui.emit(edit::Set<&world::Settings::camera_mode>{world::CameraMode::orbit});
}

}  // namespace coaster::ui
