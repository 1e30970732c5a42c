#include "view/overlay_section.h"

#include <algorithm>

#include "sim/shape/rails.h"
#include "world/sections.h"

namespace coaster::view {
namespace {

constexpr std::uint32_t kSectionColour = 0xff8a1fcc;
constexpr float kSectionWidth = 4;      // px
constexpr std::size_t kMostSteps = 16;  // per segment

}  // namespace

void add_selected_section(const world::Document& document, const sim::Derived& derived, world::Entity selected,
                          float scale, Overlay& overlay) {
  if (!document.entities.find<world::Section>(selected)) return;
  const world::SectionRun run = world::run_of(document, selected);
  const std::size_t steps = std::clamp<std::size_t>(kMaxSectionLines / run.count, 1, kMostSteps);
  for (std::size_t i = run.first; i < run.end(); ++i) {
    const sim::SegmentShape& shape = derived.shape_at(i);
    glm::vec3 last(sim::rails_point(shape, 0));
    for (std::size_t k = 1; k <= steps; ++k) {
      const glm::vec3 next(sim::rails_point(shape, static_cast<double>(k) / static_cast<double>(steps)));
      overlay.lines.push_back({last, next, kSectionWidth * scale, kSectionColour});
      last = next;
    }
  }
}

}  // namespace coaster::view
