// Park: the land around the coaster, and the brushes that shape it.
#include "edit/commands/commands_park.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/set_setting.h"
#include "ui/context/setting_widgets.h"
#include "ui/context/ui.h"
#include "ui/panels/selected_sections.h"
#include "ui/widgets/widgets.h"
#include "world/aid_settings.h"

namespace coaster::ui {
namespace {

using world::EditingAids;

void seed_row(Ui& ui, const world::Park& park) {
  constexpr double kMost = 4294967295.0;
  const Number seed = whole_number(park.seed, 0, kMost, kMost, 0.1);
  if (const auto to = number(ui, "Seed", seed, "Another number, other hills. Strokes of brushes stay."))
    ui.emit(edit::SetParkSeed{static_cast<std::int64_t>(*to)});
  if (wide_button(ui, "Roll the die", "Try another seed.")) ui.emit(edit::SetParkSeed{random_seed(ui)});
}

void water_rows(Ui& ui, const world::Park& park) {
  constexpr double kUsual = -1.2, kLow = -30, kHigh = 30;  // m
  const bool wet = park.water != world::kNoWater;
  const double usual = base::row_of(park.land).water;
  if (const auto on = checkbox(ui, "Water", wet, "Fill the land with water up to a level."))
    ui.emit(edit::SetParkWater{{!*on ? world::kNoWater : usual == world::kNoWater ? kUsual : usual}});
  if (!wet) return;
  ui.emit_if<edit::SetParkWater>(
      real_slider(ui, "Level", park.water, kLow, kHigh, 1, "Height of lakes and seas.", "m"));
}

void brushes(Ui& ui, const world::Park& park) {
  setting_list<&EditingAids::brush>(
      ui, "Brush", "What the mouse does to the ground. The wheel sets its size, with Ctrl it zooms. Escape leaves.");
  if (ui.session().settings.aids->brush != world::Brush::off)
    setting_slider<&EditingAids::brush_radius>(ui, "Size", 1, "Radius of the brush.");
  if (wide_button(ui, "Take strokes away", "The land as its seed has it.", !park.tiles.empty()))
    ui.emit(edit::ResetPark{});
}

}  // namespace

void section_earthwork(Ui& ui, const SelectedSections& chosen) {
  if (ui.session().document.park.plain()) return;
  if (const auto to = combo_of(ui, "Earthwork", chosen.section().earthwork,
                               "What is done to the land where the selected sections run below it."))
    ui.emit(edit::SetEarthwork{edit::Sections(chosen.names()), *to});
}

void park_panel(Ui& ui) {
  const world::Park& park = ui.session().document.park;
  const LockedWidgets locked(ui, edit::SetLand::kInfo.name);
  ui.emit_if<edit::SetLand>(combo_of(ui, "Land", park.land, "The land around the coaster. Plain: no park."));
  if (park.plain()) return;
  seed_row(ui, park);
  ui.emit_if<edit::SetParkRelief>(
      real_slider(ui, "Relief", park.relief, 0, world::kMaxRelief, 2, "Factor of the land's heights."));
  ui.emit_if<edit::SetParkWoods>(real_slider(ui, "Woods", park.woods, 0, 1, 2, "How much of the land is wooded."));
  water_rows(ui, park);
  brushes(ui, park);
}

}  // namespace coaster::ui
