#include "view/workspace.h"

#include "world/lab_view.h"
#include "world/panels.h"

namespace coaster::view {

bool selects_sections(const world::Settings& settings) { return settings.panels->workspace == world::Workspace::build; }

bool shows_knots(const world::Settings& settings) {
  return settings.panels->workspace != world::Workspace::ride && settings.lab->layers.has(world::Layer::knots);
}

}  // namespace coaster::view
