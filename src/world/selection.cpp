#include "world/selection.h"

#include <algorithm>
#include <cstdint>

namespace coaster::world {

namespace {

template <class Component>
std::vector<Entity> selected_with(const Document& document, const Settings& settings) {
  std::vector<Entity> selected;
  if (!document.entities.find<Component>(settings.selected)) return selected;
  selected.reserve(settings.also.size() + 1);
  for (const Entity e : settings.also)
    if (document.entities.find<Component>(e)) selected.push_back(e);
  selected.push_back(settings.selected);
  return selected;
}

}  // namespace

std::vector<Entity> selected_knots(const Document& document, const Settings& settings) {
  return selected_with<Knot>(document, settings);
}
std::vector<Entity> selected_sections(const Document& document, const Settings& settings) {
  return selected_with<Section>(document, settings);
}

std::vector<SectionRun> selected_runs(const Document& document, const Settings& settings) {
  std::vector<Entity> selected = selected_sections(document, settings);
  if (selected.empty()) return {};
  std::sort(selected.begin(), selected.end());
  std::vector<SectionRun> runs = sections_of(document);
  std::erase_if(
      runs, [&](const SectionRun& run) { return !std::binary_search(selected.begin(), selected.end(), run.section); });
  return runs;
}

bool is_selected(const Settings& settings, Entity e) {
  return e == settings.selected || std::find(settings.also.begin(), settings.also.end(), e) != settings.also.end();
}

glm::vec3 middle_of(const Document& document, const std::vector<Entity>& knots) {
  glm::dvec3 sum(0);
  for (const Entity e : knots) sum += glm::dvec3(knot(document, e).position);
  return glm::vec3(sum / static_cast<double>(knots.size()));
}

std::vector<Entity> in_track_order(const Document& document, const std::vector<Entity>& chosen) {
  std::uint32_t most = 0;
  for (const Entity e : chosen) most = std::max(most, e.index + 1);
  std::vector<Entity> by_index(most, kNone);
  for (const Entity e : chosen) by_index[e.index] = e;
  std::vector<Entity> ordered;
  for (const Entity e : document.track.knots)
    if (e.index < most && by_index[e.index] == e) ordered.push_back(e);
  return ordered;
}

void drop_dead(const Document& document, Settings& settings) {
  const auto alive = [&](Entity e) { return document.entities.alive(e); };
  std::erase_if(settings.also, [&](Entity e) { return !alive(e); });
  if (!settings.selected.valid() || alive(settings.selected)) return;
  settings.selected = kNone;
  if (settings.also.empty()) return;
  settings.selected = settings.also.back();
  settings.also.pop_back();
}

}  // namespace coaster::world
