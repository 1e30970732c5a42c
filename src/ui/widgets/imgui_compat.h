// Where versions of Dear ImGui differ in a name. Tried with 1.86 and 1.90.
#pragma once

#include <imgui.h>

namespace coaster::ui {

#if IMGUI_VERSION_NUM >= 18700
inline constexpr ImGuiKey kKeypadEnter = ImGuiKey_KeypadEnter;
#else
inline constexpr ImGuiKey kKeypadEnter = ImGuiKey_KeyPadEnter;
#endif

}  // namespace coaster::ui
