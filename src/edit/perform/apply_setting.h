// Applies the command of a setting, of any group and type. The names of some types are in sim.
#pragma once

#include <string>
#include <type_traits>

#include <fmt/format.h>

#include "base/enum_names.h"
#include "edit/commands/set_setting.h"
#include "edit/perform/perform_context.h"
#include "sim/ride/ride.h"
#include "sim/shape/frame_methods.h"
#include "world/settings_groups.h"

namespace coaster::edit {

// Returns the setting in words for a notice: "roll damping" for "camera.roll_damping".
std::string noun_of(std::string_view word);

// Commands parsed from text name valid rows; others may not.
template <base::Named E>
base::Status known_row(E value) {
  if (base::has_row(value)) return {};
  return refused(fmt::format("there is no row {} in the table of {}", static_cast<int>(value), base::count_of<E>()));
}

// Clamps a number to the limits of its row; refuses an invalid value.
template <class T>
base::Status limit(Change& change, const world::SettingRow& row, T& value) {
  if constexpr (std::is_enum_v<T>) {
    return known_row(value);
  } else if constexpr (!std::is_same_v<T, bool>) {
    value = change.clamp(noun_of(row.word), value, static_cast<T>(row.low), static_cast<T>(row.high), row.unit);
  }
  return {};
}

template <auto Member>
base::Status perform(Session& session, Change& change, const Set<Member>& command) {
  auto value = command.to;
  if (const base::Status good = limit(change, Set<Member>::kRow, value); !good) return good;
  if constexpr (std::is_same_v<world::GroupOf<Member>, world::Evaluation>) {
    world::Evaluation next = *session.settings.evaluation;
    next.*Member = value;
    const base::Status room = within_budget(session.document.track.segments.size(), next.steps, next.vertex_budget);
    if (!room) return room;
    change.remeasure = true;
  }
  world::value_in<Member>(session.settings) = value;
  return {};
}

}  // namespace coaster::edit
