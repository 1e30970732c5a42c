#include "ui/host/areas.h"

#include "ui/lab/force_graph.h"
#include "ui/lab/laboratory.h"
#include "ui/panels/panels.h"
#include "ui/panels/sections_table.h"
#include "ui/screens/ride_bar.h"
#include "world/lab_view.h"
#include "world/panels.h"

namespace coaster::ui {
namespace {

// The riders' page is as high as possible, because it is read from top to bottom.
Strip strip_of(const world::Settings& settings) {
  const float chosen = settings.panels->laboratory_height;
  const bool tall = settings.lab->page == world::LabPage::riders;
  return {settings.panels->show_laboratory, chosen > 0 ? chosen : tall ? 0.5f : 0.0f};
}

}  // namespace

LayoutWish wish_of(const Ui& ui) {
  const world::Panels& shown = *ui.session().settings.panels;
  return {.panels = shown.show_panels,
          .workspace = shown.workspace,
          .strip = strip_of(ui.session().settings),
          .parameters = ui.drawers.parameters.wanted,
          .graph = ui.drawers.graph.wanted,
          .graph_share = shown.graph_height,
          .elements = palette_size(),
          .label_width = palette_label_width(ui.scale)};
}

void build_areas(Ui& ui, const Layout& layout) {
  build_column(ui, Column::left, layout.left);
  build_column(ui, Column::right, layout.right);
  build_laboratory(ui, layout.strip);
  build_column(ui, Column::left, layout.parameters);
  build_palette_of_elements(ui, layout.palette, layout.grid);
  build_drawer(ui, layout.drawer);
  build_force_graph(ui, layout.graph);
  if (const float bar = ImGui::GetFrameHeight(); ui.drawers.table && layout.graph.height > bar + 1)
    build_sections_table(ui, {layout.graph.x, layout.graph.y + bar, layout.graph.width, layout.graph.height - bar});
  build_ride_bar(ui, layout.ride);
  build_status_bar(ui, layout.status);
  const world::Workspace workspace = ui.session().settings.panels->workspace;
  if (workspace == world::Workspace::build || workspace == world::Workspace::ride) draw_goals(ui, layout.scene);
}

}  // namespace coaster::ui
