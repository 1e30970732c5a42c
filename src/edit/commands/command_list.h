// The list of all kinds of commands, for functions over every kind: text, applying. Each group's header lists its
// kinds.
#pragma once

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

#include "base/check.h"
#include "edit/commands/command.h"
#include "edit/commands/commands_document.h"
#include "edit/commands/commands_force_sections.h"
#include "edit/commands/commands_operation.h"
#include "edit/commands/commands_park.h"
#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_sections.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "edit/commands/commands_shape.h"
#include "edit/commands/set_setting.h"
#include "world/settings_groups.h"

namespace coaster::edit {

// Set<> of every row of a group of settings.
template <class Group, std::size_t... I>
CommandList<Set<std::get<I>(Group::kRows).member>...> set_commands(std::index_sequence<I...>);
template <class... Groups>
auto set_commands(world::GroupList<Groups...>)
    -> decltype((set_commands<Groups>(std::make_index_sequence<std::tuple_size_v<decltype(Groups::kRows)>>()) + ...));

using Commands = decltype(DocumentCommands() + ShapeCommands() + OperationCommands() + CoasterCommands() +
                          ParkCommands() + ElementCommands() + SectionCommands() + ForceCommands() + SeekCommands() +
                          SettingsCommands() + LabCommands() + RideCommands() + SessionCommands() +
                          ChallengeCommands() + set_commands(world::SettingGroups()));

inline constexpr auto kCommandInfos = Commands::table([]<class C>() { return &C::kInfo; });

// Returns the index of a command's kind in the list (COASTER_CHECK).
inline std::size_t index_of(const Command& command) {
  const auto found = std::find(kCommandInfos.begin(), kCommandInfos.end(), &command.info());
  COASTER_CHECK(found != kCommandInfos.end(), "the kind of a command is in the list of commands");
  return static_cast<std::size_t>(found - kCommandInfos.begin());
}

// Returns whether a command in scripts starts with this word.
inline bool is_command_word(std::string_view word) {
  return std::ranges::any_of(kCommandInfos, [&](const CommandInfo* info) { return info->name == word; });
}

}  // namespace coaster::edit
