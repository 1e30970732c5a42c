// The host of scripts: the functions that they call in the running program. The tutorial is also a script.
#pragma once

#include <type_traits>

#include "app/program.h"
#include "edit/commands/set_setting.h"
#include "script/host.h"
#include "world/aid_settings.h"
#include "world/panel_settings.h"
#include "world/settings_groups.h"

namespace coaster::app {

// Returns functions over `program`, which must outlive them.
script::Host make_script_host(Program& program);

// Returns what the page around the program may ask by text: the value of a query ("ride.speed", "position @k3"), or of
// "widget PATH" the middle of the widget of that path on the screen, "X Y" in px, as scripts find it. Empty if there is
// no such value, or the widget is hidden, covered or disabled.
std::string answer(Program& program, std::string_view question);

// Starts the tutorial (tutorials/first_coaster.coaster) when it is requested, and runs it up to its next lesson, which
// waits for the player. Call it after each frame of a window. The tutorial runs until its end, until the player leaves
// it, or until end_tutorial(). A notice reports errors.
void teach(Program& program);
// Ends the tutorial and restores the settings that it changed.
void end_tutorial(Program& program);

// Sets those settings to their values in `from`.
template <auto... Setting>
void take_settings(Program& program, const world::Settings& from) {
  const auto take = [&]<auto S>() {
    if (const auto value = world::value_in<S>(from); value != world::value_in<S>(program.session.settings))
      (void)apply(program, edit::Set<S>{value});
  };
  (take.template operator()<Setting>(), ...);
}

template <auto A, auto B>
inline constexpr bool kSameSetting =
    std::is_same_v<std::integral_constant<decltype(A), A>, std::integral_constant<decltype(B), B>>;
template <auto Setting>
inline constexpr bool kLentToTutorial =
    kSameSetting<Setting, &world::Panels::workspace> || kSameSetting<Setting, &world::Panels::show_panels> ||
    kSameSetting<Setting, &world::Panels::show_laboratory> || kSameSetting<Setting, &world::EditingAids::show_hints>;

}  // namespace coaster::app
