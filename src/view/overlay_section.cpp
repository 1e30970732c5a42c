#include "view/overlay_section.h"

#include <algorithm>

#include "sim/shape/rails.h"
#include "view/workspace.h"
#include "world/sections.h"
#include "world/selection.h"

namespace coaster::view {
namespace {

using world::Entity;

struct LineLook {
  float width;  // points
  std::uint32_t colour;
};
constexpr LineLook kSelectedLine{5, 0xff8a1fcc}, kHoveredLine{2, 0xffffffb0};

void add_run(const sim::Derived& derived, const world::SectionRun& run, std::size_t most, const LineLook& look,
             float scale, Overlay& overlay) {
  constexpr std::size_t kMostSteps = 16;  // per segment
  const std::size_t steps = std::clamp<std::size_t>(most / run.count, 1, kMostSteps);
  for (std::size_t i = run.first; i < run.end(); ++i) {
    const sim::SegmentShape& shape = derived.shape_at(i);
    glm::vec3 last(sim::rails_point(shape, 0));
    for (std::size_t k = 1; k <= steps; ++k) {
      const glm::vec3 next(sim::rails_point(shape, static_cast<double>(k) / static_cast<double>(steps)));
      overlay.lines.push_back({last, next, look.width * scale, look.colour});
      last = next;
    }
  }
}

// Returns the section to mark under the mouse, or kNone.
Entity hovered_section(const world::Document& document, const world::Settings& settings, const Pick& hovered) {
  if (!selects_sections(settings)) return world::kNone;
  Entity section;
  if (const auto* const segment = document.entities.find<world::Segment>(hovered.entity)) section = segment->section;
  if (!section.valid() || world::is_free(document, section) || world::is_selected(settings, section))
    return world::kNone;
  return section;
}

}  // namespace

void add_sections(const world::Document& document, const sim::Derived& derived, const world::Settings& settings,
                  const View& view, const Pick& hovered, Overlay& overlay) {
  const float scale = mark_scale(settings, view);
  if (const Entity section = hovered_section(document, settings, hovered); section.valid())
    add_run(derived, world::run_of(document, section), kMaxSectionLines, kHoveredLine, scale, overlay);
  std::vector<Entity> selected = world::selected_sections(document, settings);
  if (selected.empty()) return;
  const auto before = [](Entity a, Entity b) { return a.index < b.index; };
  std::sort(selected.begin(), selected.end(), before);
  for (const world::SectionRun& run : world::sections_of(document))
    if (std::binary_search(selected.begin(), selected.end(), run.section, before))
      add_run(derived, run, kMaxSectionLines / selected.size(), kSelectedLine, scale, overlay);
}

}  // namespace coaster::view
