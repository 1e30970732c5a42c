// The list of all kinds of commands, for what is done with every kind: its text, applying it. A file that makes a
// command includes the header of its group alone.
#pragma once

#include <algorithm>
#include <array>
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
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "edit/commands/commands_shape.h"
#include "world/settings_groups.h"

namespace coaster::edit {

template <class... C>
struct CommandList {
  static constexpr std::size_t size = sizeof...(C);
  // Calls make.template operator()<C>() for each kind, in order.
  template <class Make>
  static constexpr auto table(Make make) {
    return std::array{make.template operator()<C>()...};
  }
};
template <class... A, class... B>
CommandList<A..., B...> operator+(CommandList<A...>, CommandList<B...>);

// Set<> of every row of a group of settings.
template <class Group, std::size_t... I>
CommandList<Set<std::get<I>(Group::kRows).member>...> set_commands(std::index_sequence<I...>);
template <class... Groups>
auto set_commands(world::GroupList<Groups...>)
    -> decltype((set_commands<Groups>(std::make_index_sequence<std::tuple_size_v<decltype(Groups::kRows)>>()) + ...));

using Commands =
    decltype(CommandList<MoveKnot, MoveHandle, SetDirection, SetLengths, SetRoll, SetJoint, SetTurns, SplitSegment,
                         AddCurve, AppendKnot, RemoveKnot, SetClosed, AddCart, SetName, SetStartSpeed, SetDatum, MakeG2,
                         MakeAllG2, Translate, Rotate, Scale, Mirror, Smooth, Equalise, Straighten, SetRadius,
                         DropToGround, Align, Reverse, Duplicate, CloseExactly, SetEquipment, RemoveEquipment, SetTrain,
                         SetLosses, SetHeartline, SetRollbackFails, AutoBank, PlaceElement, SetCamera, SetFly, Select,
                         SelectKnots, SetSnapping, SetPolyline, ShowLayer, Measure, StopMeasuring, ChooseElement,
                         RideStart, RidePause, RideStop, RideStep, RideSeek, Undo, Redo, BeginGesture, EndGesture,
                         CancelGesture, Load, Save, SaveMeasurements, SaveReport, LoadEnvelope, RecoverTrack, NewTrack,
                         StartChallenge, LeaveChallenge, ShowHint, CloseCard>() +
             set_commands(world::SettingGroups()));

// The place of a command's kind in the list (COASTER_CHECK).
inline std::size_t index_of(const Command& command) {
  static constexpr auto kInfos = Commands::table([]<class C>() { return &C::kInfo; });
  const auto found = std::find(kInfos.begin(), kInfos.end(), &command.info());
  COASTER_CHECK(found != kInfos.end(), "the kind of a command is in the list of commands");
  return static_cast<std::size_t>(found - kInfos.begin());
}

}  // namespace coaster::edit
