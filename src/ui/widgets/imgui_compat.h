// All differences between versions of Dear ImGui. Tested with 1.86, 1.90.1 and 1.92.9.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <functional>
#include <set>
#include <span>

namespace coaster::ui {

#if IMGUI_VERSION_NUM >= 18700
inline constexpr ImGuiKey kKeypadEnter = ImGuiKey_KeypadEnter;
#else
inline constexpr ImGuiKey kKeypadEnter = ImGuiKey_KeyPadEnter;
#endif

// For an invisible button that keys choose.
#if IMGUI_VERSION_NUM >= 19140
inline constexpr ImGuiButtonFlags kChosenByKeys = ImGuiButtonFlags_EnableNav;
#else
inline constexpr ImGuiButtonFlags kChosenByKeys = ImGuiButtonFlags_None;
#endif

// Prepares a new current context: it keeps no files, textures are created by upload_textures(), and a frame gets all
// input set before it.
void set_up_context();

// Input of the current context for the next frame; set all of it before each frame.
void set_mouse(ImVec2 position, ImVec2 wheel);  // pixels; notches since the last frame
void set_button(int button, bool down);
void set_key(ImGuiKey key, bool down);
void set_modifiers(bool ctrl, bool shift, bool alt);
// With `on`, the arrows, Home, End, Enter and Escape move, choose and close in the next frame's lists and menus, or in
// its window with the focus.
void set_list_keys(bool on);
// Gives the focus to the current window, and chooses the first of the widgets that follow.
void choose_first();
// A child window whose widgets the arrows reach from its parent's.
bool begin_part(const char* id, ImVec2 size, bool border = false);

// Returns how many lists, menus and dialogs are open, one inside another.
int open_popups();
// Returns 1 or -1 if Right or Left leaves the open menu of the menu bar for its neighbour, otherwise 0: a menu inside
// it opens or closes. Call it after all menus, with open_popups() before them; then open the neighbour.
int take_menu_step(int popups_before);

// Returns the line height of a font, px.
float pixels_of(const ImFont& font);
bool has_glyph(ImFont& font, ImWchar character);

// Empties the atlas; then add fonts, then finish. All digits get the width of the widest, so that changing numbers do
// not move. Letters that the fonts lack show as a box if their block is one of `tried`, else one frame later.
// finish_fonts() returns false if Dear ImGui cannot read one of the fonts.
inline constexpr ImWchar kBox = 0x25A1, kBlock = 4;  // a block: that many letters
void begin_fonts(ImFontAtlas& atlas);
bool finish_fonts(ImFontAtlas& atlas, const std::set<ImWchar>& tried);
// Adds the blocks of the letters that the last frame could not draw, each by its first letter.
void take_missing(std::set<ImWchar>& blocks);

// Calls `upload` for each texture of the current context that is new, changed or no longer used since the last call.
// Draw commands identify these textures by `id`, from kOwnTexture on, and others by their OpenGL names, which are
// smaller. RGBA, 8 bits each; without pixels: delete it.
inline constexpr std::uintptr_t kOwnTexture = 0x8000'0000;
using Upload = std::function<void(std::uintptr_t id, int width, int height, const void* pixels)>;
void upload_textures(const Upload& upload);
// The current context has the fonts of another one, whose textures upload_textures() has uploaded.
void share_textures(const ImGuiIO& other);
std::uintptr_t texture_of(const ImDrawCmd& command);
std::span<const ImDrawList* const> lists_of(const ImDrawData& data);

}  // namespace coaster::ui
