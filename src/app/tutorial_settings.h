// The kept settings that the tutorial changes. The changes are not saved, and are reverted when it ends.
#pragma once

#include <type_traits>

#include "world/aids.h"
#include "world/panels.h"

namespace coaster::app {

template <auto A, auto B>
inline constexpr bool kSameSetting =
    std::is_same_v<std::integral_constant<decltype(A), A>, std::integral_constant<decltype(B), B>>;
template <auto Setting>
inline constexpr bool kLentToTutorial =
    kSameSetting<Setting, &world::Panels::workspace> || kSameSetting<Setting, &world::Panels::show_panels> ||
    kSameSetting<Setting, &world::Panels::show_laboratory> || kSameSetting<Setting, &world::Aids::show_hints>;

}  // namespace coaster::app
