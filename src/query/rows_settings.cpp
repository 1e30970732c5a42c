// Queries about the settings with a row: one for each row.
#include <vector>

#include "query/rows.h"
#include "sim/ride/ride.h"
#include "sim/shape/frame_methods.h"
#include "world/settings_groups.h"

namespace coaster::query {
namespace {

template <auto Member>
Answer setting(const Context& c, View) {
  return value_of(world::value_in<Member>(c.session.settings));
}

}  // namespace

std::span<const Query> setting_rows() {
  static const std::vector<Query> rows = [] {
    std::vector<Query> made;
    world::for_each_setting([&]<auto Member>() {
      static constexpr world::SettingRow kRow = world::setting_row<Member>();
      made.push_back(
          {kRow.query_name(), kNoArgument, kRow.unit, kRow.help, setting<Member>, values_of<world::ValueOf<Member>>()});
    });
    return made;
  }();
  return rows;
}

}  // namespace coaster::query
