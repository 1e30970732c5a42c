#include "ui/widgets/imgui_compat.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace coaster::ui {
namespace {

void set_up_io(ImGuiIO& io) {
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;  // a list may have more than 65,536 vertices
}

}  // namespace

#if IMGUI_VERSION_NUM >= 18700

void set_mouse(ImVec2 position, ImVec2 wheel) {
  ImGuiIO& io = ImGui::GetIO();
  io.AddMousePosEvent(position.x, position.y);
  io.AddMouseWheelEvent(wheel.x, wheel.y);
}
void set_button(int button, bool down) { ImGui::GetIO().AddMouseButtonEvent(button, down); }
void set_key(ImGuiKey key, bool down) { ImGui::GetIO().AddKeyEvent(key, down); }

#else

void set_mouse(ImVec2 position, ImVec2 wheel) {
  ImGuiIO& io = ImGui::GetIO();
  io.MousePos = position;
  io.MouseWheelH = wheel.x;
  io.MouseWheel = wheel.y;
}
void set_button(int button, bool down) { ImGui::GetIO().MouseDown[button] = down; }
void set_key(ImGuiKey key, bool down) {
  ImGui::GetIO().KeyMap[key] = key;  // from ImGui's keys to "native" ones: the identity
  ImGui::GetIO().KeysDown[key] = down;
}

#endif

void set_modifiers(bool ctrl, bool shift, bool alt) {
  ImGuiIO& io = ImGui::GetIO();
#if IMGUI_VERSION_NUM >= 18900
  io.AddKeyEvent(ImGuiMod_Ctrl, ctrl);
  io.AddKeyEvent(ImGuiMod_Shift, shift);
  io.AddKeyEvent(ImGuiMod_Alt, alt);
#else
  io.KeyCtrl = ctrl;
  io.KeyShift = shift;
  io.KeyAlt = alt;
#endif
}

void set_list_keys(bool on) {
  ImGuiIO& io = ImGui::GetIO();
  ImGuiContext& g = *ImGui::GetCurrentContext();
  io.ConfigFlags = on ? ImGuiConfigFlags_NavEnableKeyboard : ImGuiConfigFlags_None;
#if IMGUI_VERSION_NUM < 18700
  // Enter chooses only in newer versions; Space does in all.
  if (on && (io.KeysDown[ImGuiKey_Enter] || io.KeysDown[kKeypadEnter])) io.KeysDown[ImGuiKey_Space] = true;
#endif
#if IMGUI_VERSION_NUM >= 19140
  bool& visible = g.NavCursorVisible;
  visible = visible && on;
#else
  g.NavDisableHighlight = g.NavDisableHighlight || !on;
  const bool visible = !g.NavDisableHighlight;
#endif
  // A menu opened by the mouse has no item chosen yet: the first press of Down chooses the first one, not the second.
  if (!on || visible || g.NavWindow == nullptr || (g.NavWindow->Flags & ImGuiWindowFlags_ChildMenu) == 0) return;
#if IMGUI_VERSION_NUM >= 19000
  g.NavInitResult.ID = 0;
#else
  g.NavInitResultId = 0;
#endif
}

void choose_first() {
  ImGuiContext& g = *ImGui::GetCurrentContext();
  ImGui::SetWindowFocus();
  ImGui::NavInitWindow(ImGui::GetCurrentWindow(), true);
#if IMGUI_VERSION_NUM >= 19140
  g.NavCursorVisible = true;
#else
  g.NavDisableHighlight = false;
#endif
}

bool begin_part(const char* id, ImVec2 size, bool border) {
#if IMGUI_VERSION_NUM >= 19090
  return ImGui::BeginChild(id, size, ImGuiChildFlags_NavFlattened | static_cast<ImGuiChildFlags>(border));
#else
  return ImGui::BeginChild(id, size, border, ImGuiWindowFlags_NavFlattened);
#endif
}

int open_popups() { return ImGui::GetCurrentContext()->OpenPopupStack.Size; }

int take_menu_step(int popups_before) {
  ImGuiContext& g = *ImGui::GetCurrentContext();
  const int step = int{ImGui::IsKeyPressed(ImGuiKey_RightArrow)} - int{ImGui::IsKeyPressed(ImGuiKey_LeftArrow)};
  if (step == 0 || open_popups() != popups_before || (step < 0 && popups_before > 1)) return 0;
  ImGui::NavMoveRequestCancel();  // ImGui would close the menu
  // No item of the neighbour is chosen yet, and the title under a resting mouse does not open again.
#if IMGUI_VERSION_NUM >= 19140
  g.NavCursorVisible = false;
  g.NavHighlightItemUnderNav = true;
#else
  g.NavDisableHighlight = true;
  g.NavDisableMouseHover = true;
#endif
  return step;
}

#if IMGUI_VERSION_NUM >= 19200

namespace {

// Loads a glyph as Dear ImGui's loader does, a digit centred in the width of the widest digit. With `advance` it only
// measures. Inter's digits are proportional by default, and stb_truetype reads no OpenType features.
bool load_glyph(ImFontAtlas* atlas, ImFontConfig* source, ImFontBaked* baked, void* data, ImWchar c, ImFontGlyph* glyph,
                float* advance) {
  const auto load = ImFontAtlasGetFontLoaderForStbTruetype()->FontBakedLoadGlyph;
  if (!load(atlas, source, baked, data, c, glyph, advance)) return false;
  if (c < '0' || c > '9') return true;
  float widest = 0;
  for (ImWchar digit = '0'; digit <= '9'; ++digit) {
    float width = 0;
    if (load(atlas, source, baked, data, digit, nullptr, &width)) widest = std::max(widest, width);
  }
  if (advance != nullptr) {
    *advance = widest;
    return true;
  }
  const float shift = (widest - glyph->AdvanceX) * 0.5f;
  glyph->X0 += shift;
  glyph->X1 += shift;
  glyph->AdvanceX = widest;
  return true;
}

}  // namespace

void set_up_context() {
  ImGuiIO& io = ImGui::GetIO();
  set_up_io(io);
  io.ConfigInputTrickleEventQueue = false;
  io.BackendFlags |= ImGuiBackendFlags_RendererHasTextures;
#if IMGUI_VERSION_NUM >= 19290
  io.MouseSingleClickDelay = INFINITY;  // must be longer than the time of a double click, which the input sets
#endif
}

float pixels_of(const ImFont& font) { return font.LegacySize; }
bool has_glyph(ImFont& font, ImWchar character) { return font.IsGlyphInFont(character); }

void begin_fonts(ImFontAtlas& atlas) {
  static const ImFontLoader loader = [] {
    ImFontLoader made = *ImFontAtlasGetFontLoaderForStbTruetype();
    made.Name = "stb_truetype, digits of one width";
    made.FontBakedLoadGlyph = load_glyph;
    return made;
  }();
  atlas.Clear();
  atlas.SetFontLoader(&loader);
}
// Glyphs are loaded when they are first drawn, in the current size: with another atlas the former size would remain.
bool finish_fonts(ImFontAtlas& atlas, const std::set<ImWchar>&) {
  ImGui::GetStyle().FontSizeBase = pixels_of(*atlas.Fonts[0]);
  return true;
}

void take_missing(std::set<ImWchar>& blocks) {
  constexpr ImU16 kNotFound = 0xfffe;  // Dear ImGui's mark of a character it has looked for
  for (const ImFont* const font : ImGui::GetIO().Fonts->Fonts)
    if (const ImFontBaked* const baked = font->LastBaked)
      for (int c = 0x80; c < baked->IndexLookup.Size; ++c)
        if (baked->IndexLookup[c] == kNotFound) blocks.insert(static_cast<ImWchar>(c / kBlock * kBlock));
}

void upload_textures(const Upload& upload) {
  for (ImTextureData* const texture : ImGui::GetPlatformIO().Textures) {
    const std::uintptr_t id = kOwnTexture + static_cast<std::uintptr_t>(texture->UniqueID);
    if (texture->Status == ImTextureStatus_WantCreate || texture->Status == ImTextureStatus_WantUpdates) {
      upload(id, texture->Width, texture->Height, texture->GetPixels());
      texture->SetTexID(id);
      texture->SetStatus(ImTextureStatus_OK);
    } else if (texture->Status == ImTextureStatus_WantDestroy && texture->UnusedFrames > 0) {
      upload(id, 0, 0, nullptr);
      texture->SetTexID(ImTextureID_Invalid);
      texture->SetStatus(ImTextureStatus_Destroyed);
    }
  }
}

void share_textures(const ImGuiIO&) {}

#else

namespace {

// Inter's digits are proportional by default, and stb_truetype reads no OpenType features.
void make_figures_tabular(ImFont& font) {
  float widest = 0;
  for (ImWchar c = '0'; c <= '9'; ++c) widest = std::max(widest, font.GetCharAdvance(c));
  for (ImWchar c = '0'; c <= '9'; ++c) {
    auto* glyph = const_cast<ImFontGlyph*>(font.FindGlyphNoFallback(c));
    if (glyph == nullptr) continue;
    const float shift = (widest - glyph->AdvanceX) * 0.5f;
    glyph->X0 += shift;
    glyph->X1 += shift;
    glyph->AdvanceX = widest;
    font.IndexAdvanceX[c] = widest;
  }
}

constexpr float kMissing = 2;  // outside of the texture

// Gives letters without a glyph a dot that tells their block by its place in the texture.
void mark_missing(ImFont& font, const std::set<ImWchar>& tried) {
  const int size = 0x10000, before = font.IndexLookup.Size;
  font.GrowIndex(size);
  for (int c = before; c < size; ++c) font.IndexAdvanceX[c] = font.FallbackAdvanceX;
  for (int block = 0x80; block < size; block += kBlock) {
    if (tried.contains(static_cast<ImWchar>(block))) continue;
    ImFontGlyph dot{};
    dot.Visible = 1;
    dot.X1 = dot.Y1 = 1;
    dot.AdvanceX = font.FallbackAdvanceX;
    dot.U0 = dot.U1 = static_cast<float>(block);
    dot.V0 = dot.V1 = kMissing;
    font.Glyphs.push_back(dot);
    for (int c = block; c < block + kBlock; ++c)
      if (ImWchar& glyph = font.IndexLookup[c]; glyph == ImWchar(-1)) glyph = ImWchar(font.Glyphs.Size - 1);
  }
  font.FallbackGlyph = &font.Glyphs[font.IndexLookup[font.FallbackChar]];  // they have moved
}

}  // namespace

void set_up_context() {
  set_up_io(ImGui::GetIO());
#if IMGUI_VERSION_NUM >= 18700
  ImGui::GetIO().ConfigInputTrickleEventQueue = false;
#endif
}

float pixels_of(const ImFont& font) { return font.FontSize; }
bool has_glyph(ImFont& font, ImWchar character) {
  const ImFontGlyph* const glyph = font.FindGlyphNoFallback(character);
  return glyph != nullptr && glyph->V0 != kMissing;
}

void begin_fonts(ImFontAtlas& atlas) {
  atlas.Clear();
  ImGui::GetIO().BackendRendererUserData = nullptr;  // the atlas that was uploaded
}
bool finish_fonts(ImFontAtlas& atlas, const std::set<ImWchar>& tried) {
  if (!atlas.Build()) return false;
  for (ImFont* const font : atlas.Fonts) {
    make_figures_tabular(*font);
    mark_missing(*font, tried);
  }
  atlas.SetTexID((ImTextureID)kOwnTexture);  // a pointer
  return true;
}

void take_missing(std::set<ImWchar>& blocks) {
  if (const ImDrawData* const data = ImGui::GetDrawData())
    for (const ImDrawList* const list : lists_of(*data))
      for (const ImDrawVert& corner : list->VtxBuffer)
        if (corner.uv.y == kMissing) blocks.insert(static_cast<ImWchar>(corner.uv.x));
}

void upload_textures(const Upload& upload) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  if (std::exchange(ImGui::GetIO().BackendRendererUserData, &atlas) == &atlas) return;
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  atlas.GetTexDataAsRGBA32(&pixels, &width, &height);
  upload(kOwnTexture, width, height, pixels);
  atlas.ClearTexData();  // the texture alone holds them now
}

void share_textures(const ImGuiIO& other) { ImGui::GetIO().BackendRendererUserData = other.BackendRendererUserData; }

#endif

std::span<const ImDrawList* const> lists_of(const ImDrawData& data) {
#if IMGUI_VERSION_NUM >= 18980
  return {data.CmdLists.Data, static_cast<std::size_t>(data.CmdLists.Size)};
#else
  return {data.CmdLists, static_cast<std::size_t>(data.CmdListsCount)};
#endif
}

std::uintptr_t texture_of(const ImDrawCmd& command) { return (std::uintptr_t)command.GetTexID(); }

}  // namespace coaster::ui
