// All kinds of commands, for what is done with every kind: its text, applying it. Each group's header lists its own.
#pragma once

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

#include "base/check.h"
#include "edit/commands/command.h"
#include "edit/commands/commands_challenge.h"
#include "edit/commands/commands_document.h"
#include "edit/commands/commands_elements.h"
#include "edit/commands/commands_lab.h"
#include "edit/commands/commands_operation.h"
#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_sections.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "edit/commands/commands_shape.h"
#include "world/settings_groups.h"

namespace coaster::edit {

// Set<> of every row of a group of settings.
template <class Group, std::size_t... I>
CommandList<Set<std::get<I>(Group::kRows).member>...> set_commands(std::index_sequence<I...>);
template <class... Groups>
auto set_commands(world::GroupList<Groups...>)
    -> decltype((set_commands<Groups>(std::make_index_sequence<std::tuple_size_v<decltype(Groups::kRows)>>()) + ...));

using Commands = decltype(DocumentCommands() + ShapeCommands() + OperationCommands() + ElementCommands() +
                          SectionCommands() + SettingsCommands() + LabCommands() + RideCommands() + SessionCommands() +
                          ChallengeCommands() + set_commands(world::SettingGroups()));

// The place of a command's kind in the list (COASTER_CHECK).
inline std::size_t index_of(const Command& command) {
  static constexpr auto kInfos = Commands::table([]<class C>() { return &C::kInfo; });
  const auto found = std::find(kInfos.begin(), kInfos.end(), &command.info());
  COASTER_CHECK(found != kInfos.end(), "the kind of a command is in the list of commands");
  return static_cast<std::size_t>(found - kInfos.begin());
}

}  // namespace coaster::edit
