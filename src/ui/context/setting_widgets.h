// Rows that show and change a setting. Its member pointer gives the place of the value and its limits.
#pragma once

#include "edit/commands/set_setting.h"
#include "ui/context/ui.h"
#include "world/settings_groups.h"

namespace coaster::ui {

template <auto Member>
void setting_box(Ui& ui, std::string_view label, std::string_view tooltip) {
  ui.emit_if<edit::Set<Member>>(checkbox(ui, label, world::value_in<Member>(ui.session().settings), tooltip));
}

template <auto Member>
void setting_list(Ui& ui, std::string_view label, std::string_view tooltip, ComboPlace place = ComboPlace::fitting) {
  ui.emit_if<edit::Set<Member>>(combo_of(ui, label, world::value_in<Member>(ui.session().settings), tooltip, place));
}

template <auto Member>
void setting_slider(Ui& ui, std::string_view label, int decimals, std::string_view tooltip) {
  constexpr world::SettingRow kRow = world::setting_row<Member>();
  const double now = world::value_in<Member>(ui.session().settings);
  if (const auto to = real_slider(ui, label, now, kRow.low, kRow.high, decimals, tooltip, kRow.unit.data()))
    ui.emit(edit::Set<Member>{static_cast<world::ValueOf<Member>>(*to)});
}

}  // namespace coaster::ui
