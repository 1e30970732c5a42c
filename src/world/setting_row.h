// The row of a scalar setting. A group of settings (world/appearance_settings.h and similar) is a plain struct with a
// tuple `kRows`, one row per member. The row gives a setting its command, its query, its member of the user's settings
// file and its line in a recording; to add a setting, add the member and its row. All groups: world/settings_groups.h.
#pragma once

#include <string_view>
#include <tuple>
#include <type_traits>

namespace coaster::world {

struct SettingRow {
  std::string_view word = {};     // name of its command
  std::string_view help = {};     // one line, for the command and the query
  double low = 0, high = 0;       // limits of a number; values beyond them are clamped with a notice
  std::string_view unit = {};     // of the number, "m"
  std::string_view query = {};    // name of the query if it differs from `word`
  std::string_view kept_as = {};  // member of the user's settings file; empty: not kept
  // Where users have another default than sessions start with: 1 for a switch that is on, else the number of the
  // enumerator; -1: they have the same.
  int for_user = -1;

  constexpr std::string_view query_name() const { return query.empty() ? word : query; }
};

template <class Group, class T>
struct SettingOf {
  T Group::*member;
  SettingRow row;
};
template <class Group, class T>
constexpr SettingOf<Group, T> setting(T Group::*member, std::string_view word, std::string_view help,
                                      SettingRow row = {}) {
  row.word = word, row.help = help;
  return {member, row};
}

template <class M>
struct MemberTraits;
template <class G, class T>
struct MemberTraits<T G::*> {
  using Group = G;
  using Value = T;
};
template <auto Member>
using GroupOf = typename MemberTraits<decltype(Member)>::Group;
template <auto Member>
using ValueOf = typename MemberTraits<decltype(Member)>::Value;

// The row of a member of a group; does not compile for a member without one.
template <auto Member>
consteval SettingRow setting_row() {
  SettingRow found;
  const auto look = [&]<class Row>(const Row& each) {
    if constexpr (std::is_same_v<decltype(Row::member), decltype(Member)>)
      if (each.member == Member) found = each.row;
  };
  std::apply([&](const auto&... rows) { (look(rows), ...); }, GroupOf<Member>::kRows);
  if (found.word.empty()) throw "the member has a row in kRows of its group";
  return found;
}

}  // namespace coaster::world
