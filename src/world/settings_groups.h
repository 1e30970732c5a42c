// All groups of settings, for code over every setting: its command, its query, the user's settings file. A file that
// reads one setting includes its group's header instead.
#pragma once

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

#include "world/aid_settings.h"
#include "world/appearance_settings.h"
#include "world/camera_feel.h"
#include "world/evaluation_settings.h"
#include "world/laboratory_settings.h"
#include "world/panel_settings.h"
#include "world/settings.h"

namespace coaster::world {

template <class Group, class AnySettings>
auto& group_in(AnySettings& settings) {
  if constexpr (std::is_same_v<Group, Appearance>) return *settings.look;
  else if constexpr (std::is_same_v<Group, Panels>) return *settings.panels;
  else if constexpr (std::is_same_v<Group, CameraFeel>) return *settings.feel;
  else if constexpr (std::is_same_v<Group, EditingAids>) return *settings.aids;
  else if constexpr (std::is_same_v<Group, Evaluation>) return *settings.evaluation;
  else if constexpr (std::is_same_v<Group, LabView>) return *settings.lab;
  else if constexpr (std::is_same_v<Group, Camera>) return settings.camera;
  else return settings;
}

// Returns the setting, from settings that may be const.
template <auto Member, class AnySettings>
auto& value_in(AnySettings& settings) {
  return group_in<GroupOf<Member>>(settings).*Member;
}

template <class... Groups>
struct GroupList {};
using SettingGroups = GroupList<Appearance, Panels, CameraFeel, EditingAids, Evaluation, LabView, Camera, Settings>;

// Calls visit.template operator()<&Group::member>() for each row of a group, in order.
template <class Group, class Visit>
constexpr void for_each_setting_of(Visit visit) {
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (visit.template operator()<std::get<I>(Group::kRows).member>(), ...);
  }
  (std::make_index_sequence<std::tuple_size_v<decltype(Group::kRows)>>());
}
// Does the same for each row of all groups.
template <class Visit>
constexpr void for_each_setting(Visit visit) {
  [&]<class... Groups>(GroupList<Groups...>) { (for_each_setting_of<Groups>(visit), ...); }(SettingGroups());
}

}  // namespace coaster::world
