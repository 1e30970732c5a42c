// For each setting of the tables a value that is not its default and within its limits.
#pragma once

#include <type_traits>

#include "base/enum_names.h"
#include "sim/ride/ride.h"
#include "sim/shape/frame_methods.h"
#include "world/settings_groups.h"

namespace coaster::test {

template <auto Setting>
world::ValueOf<Setting> other_value() {
  using T = world::ValueOf<Setting>;
  constexpr world::SettingRow row = world::setting_row<Setting>();
  const world::Settings settings;
  const T at_first = world::value_in<Setting>(settings);
  if constexpr (std::is_enum_v<T>) return base::next_of(at_first);
  else if constexpr (std::is_same_v<T, bool>) return !at_first;
  else {
    const auto low = static_cast<T>(row.low);
    return at_first == low ? static_cast<T>(row.high) : static_cast<T>((low + at_first) / 2);
  }
}

}  // namespace coaster::test
