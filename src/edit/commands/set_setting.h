// The command for every setting with one value: it changes neither document nor motion.
#pragma once

#include "edit/commands/command_fields.h"
#include "world/setting_row.h"

namespace coaster::edit {

// Sets the setting with that member pointer: Set<&world::Appearance::shadows>{false}. Name and help come from its row.
template <auto Member>
struct Set {
  static constexpr world::SettingRow kRow = world::setting_row<Member>();
  world::ValueOf<Member> to{};
  static constexpr CommandInfo kInfo{kRow.word, kRow.help, Effect::settings};
  COASTER_FIELDS(visit("", self.to))
};

}  // namespace coaster::edit
