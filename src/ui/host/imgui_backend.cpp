// Feeds a frame's events to Dear ImGui, and draws its lists with the program's GL table.
#include "ui/host/imgui_backend.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <variant>

#include "ui/screens/dialogs.h"
#include "ui/widgets/imgui_compat.h"

namespace coaster::ui {
namespace {

using platform::Key;

// True if what follows the key must see its effect.
bool acts(const platform::KeyPress& press, bool text_has_keyboard) {
  if (!press.down || press.repeat || press.key == Key::unknown) return false;
  if (!text_has_keyboard) return true;
  constexpr Key kLeave[] = {Key::enter, Key::keypad_enter, Key::tab, Key::escape};
  return std::ranges::find(kLeave, press.key) != std::end(kLeave);
}

// The keys that text fields use.
constexpr std::pair<Key, ImGuiKey> kKeys[] = {{Key::tab, ImGuiKey_Tab},
                                              {Key::left, ImGuiKey_LeftArrow},
                                              {Key::right, ImGuiKey_RightArrow},
                                              {Key::up, ImGuiKey_UpArrow},
                                              {Key::down, ImGuiKey_DownArrow},
                                              {Key::page_up, ImGuiKey_PageUp},
                                              {Key::page_down, ImGuiKey_PageDown},
                                              {Key::home, ImGuiKey_Home},
                                              {Key::end, ImGuiKey_End},
                                              {Key::insert, ImGuiKey_Insert},
                                              {Key::del, ImGuiKey_Delete},
                                              {Key::backspace, ImGuiKey_Backspace},
                                              {Key::space, ImGuiKey_Space},
                                              {Key::enter, ImGuiKey_Enter},
                                              {Key::escape, ImGuiKey_Escape},
                                              {Key::keypad_enter, kKeypadEnter},
                                              {Key::a, ImGuiKey_A},
                                              {Key::c, ImGuiKey_C},
                                              {Key::v, ImGuiKey_V},
                                              {Key::x, ImGuiKey_X},
                                              {Key::y, ImGuiKey_Y},
                                              {Key::z, ImGuiKey_Z}};

// Returns how many of the open popups are not lists and menus in front of everything: a dialog.
int popups_behind_lists() {
  const auto& popups = ImGui::GetCurrentContext()->OpenPopupStack;
  int count = popups.Size;
  const auto is_dialog = [](const ImGuiWindow* w) { return w != nullptr && (w->Flags & ImGuiWindowFlags_Modal) != 0; };
  while (count > 0 && !is_dialog(popups[count - 1].Window)) --count;
  return count;
}

constexpr const char* kVertexShader = R"(layout(location = 0) in vec2 position;
layout(location = 1) in vec2 place;
layout(location = 2) in vec4 colour;
uniform vec4 scale;  // pixels to clip space: xy factor, zw offset
out vec2 v_place;
out vec4 v_colour;
void main() {
  v_place = place;
  v_colour = colour;
  gl_Position = vec4(position * scale.xy + scale.zw, 0.0, 1.0);
}
)";
constexpr const char* kFragmentShader = R"(in vec2 v_place;
in vec4 v_colour;
uniform sampler2D image;
out vec4 result;
void main() { result = v_colour * texture(image, v_place); }
)";

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

// Sets the attributes so that index 0 is vertex `first` of the bound buffer: OpenGL ES 3.0 has no base vertex.
void vertices_from(const gfx::Gl& gl, std::size_t first) {
  const std::size_t at = first * sizeof(ImDrawVert);
  gl.VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(ImDrawVert), offset(at + offsetof(ImDrawVert, pos)));
  gl.VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(ImDrawVert), offset(at + offsetof(ImDrawVert, uv)));
  gl.VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(ImDrawVert), offset(at + offsetof(ImDrawVert, col)));
}

}  // namespace

platform::Events EventQueue::take(const platform::Events& events, bool text_has_keyboard, bool clicks_wait,
                                  bool field_opens) {
  constexpr int kMostFrames = 3;
  opening_ = field_opens && !text_has_keyboard ? opening_ + 1 : 0;
  const bool opens = opening_ > 0 && opening_ <= kMostFrames;
  platform::Events taken;
  const platform::Events before = std::exchange(waiting_, {});
  bool clicked = clicks_wait || opens, pressed = false, chorded = false;
  const auto take_one = [&](const platform::Event& event) {
    const auto* const press = std::get_if<platform::KeyPress>(&event);
    const bool button = std::holds_alternative<platform::MouseButton>(event);
    const bool key = press != nullptr && press->down && press->key != Key::unknown;
    // The text of a key comes right after it.
    const bool text = std::holds_alternative<platform::TextInput>(event);
    if (!waiting_.empty() || chorded || (clicked && (key || text)) || (pressed && (key || button))) {
      waiting_.push_back(event);
      return;
    }
    clicked = clicked || button;
    pressed = pressed || (press != nullptr && acts(*press, text_has_keyboard));
    chorded = key && text_has_keyboard && press->modifiers.ctrl;
    taken.push_back(event);
  };
  for (const platform::Event& event : before) take_one(event);
  for (const platform::Event& event : events)
    std::holds_alternative<platform::Tick>(event) ? taken.push_back(event) : take_one(event);
  return taken;
}

bool ImGuiInput::keys_wait() const {
  return std::ranges::any_of(presses_of_key_, [](int presses) { return presses > 0; });
}

void ImGuiInput::take_key(const platform::KeyPress& event, bool text_has_keyboard) {
  const auto* const row = std::ranges::find(kKeys, event.key, &std::pair<Key, ImGuiKey>::first);
  if (row == std::end(kKeys)) return;
  const auto key = static_cast<std::size_t>(row - kKeys);
  // Repeats come from ImGui's own timer.
  held_[key] = event.down && (text_has_keyboard || event.key != Key::tab);
  if (held_[key] && !event.repeat) ++presses_of_key_[key];
}

// Passes the keys to ImGui. A press that comes before ImGui has seen the key released waits a frame.
void ImGuiInput::show_keys() {
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    const bool presses = presses_of_key_[i] > 0 && !shown_[i];
    presses_of_key_[i] -= presses ? 1 : 0;
    shown_[i] = presses || (presses_of_key_[i] == 0 && held_[i]);
    set_key(kKeys[i].second, shown_[i]);
  }
}

// Text of a frame that also has Ctrl down waits for the next frame, because ImGui would drop it.
void ImGuiInput::take_text(const std::string& utf8, bool ctrl) {
  if (ctrl) {
    late_text_ += utf8;
    return;
  }
  modifiers_.ctrl = false;  // text never comes with Ctrl: a stale one would make ImGui drop it
  ImGui::GetIO().AddInputCharactersUTF8(utf8.c_str());
}

void ImGuiInput::take_button(const platform::MouseButton& event) {
  constexpr double kSeconds = 0.3;  // between the presses of a double click, at least: frames may be longer
  const float reach = 2 * ImGui::GetIO().MouseDragThreshold;
  const auto button = static_cast<std::size_t>(event.button);
  Press& last = presses_[button];
  const bool twice = event.down && !last.twice && polled_ - last.time <= kSeconds &&
                     std::hypot(mouse_.x - last.at.x, mouse_.y - last.at.y) <= reach;
  if (event.down) last = {time_, mouse_, twice};
  waiting_.push_back({button, event.down, twice, mouse_, event.modifiers});
}

// Passes the mouse to ImGui: its position when a button changed, else the present one.
void ImGuiInput::show_mouse(ImVec2 wheel) {
  ImGuiIO& io = ImGui::GetIO();
  Buttons changed{};
  ImVec2 at = mouse_;
  while (!waiting_.empty() && !changed[waiting_.front().button]) {
    const Change& change = waiting_.front();
    changed[change.button] = true;
    down_[change.button] = change.down;
    at = change.at;
    modifiers_ = change.modifiers;
    // ImGui compares times of frames: these settings make it take every press for a second one, or none.
    if (change.down) io.MouseDoubleClickTime = io.MouseDoubleClickMaxDist = change.twice ? FLT_MAX : 0.0f;
    waiting_.pop_front();
  }
  set_mouse(at, wheel);
  for (std::size_t i = 0; i < down_.size(); ++i) set_button(static_cast<int>(i), down_[i]);
}

// Returns the notches of the wheel that keep what fingers drag in a panel below them: two fingers anywhere, one where
// it holds no widget.
float ImGuiInput::scrolled_by_finger() const {
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  const ImGuiIO& io = g.IO;
  const bool holds_widget = g.ActiveId != 0 && !(g.ActiveIdWindow != nullptr && g.ActiveId == g.ActiveIdWindow->MoveId);
  const bool one = down_[0] && io.MouseDown[0] && !holds_widget, two = down_[2] && io.MouseDown[2];
  if (!finger_ || !io.WantCaptureMouse || !(one || two)) return 0;
  constexpr float kLines = 5;  // ImGui's step for a notch
  return (mouse_.y - io.MousePos.y) / (kLines * ImGui::GetFontSize());
}

void ImGuiInput::feed(const platform::Events& events, int width, int height, bool text_has_keyboard,
                      bool page_of_choices) {
  static_assert(std::tuple_size_v<Keys> == std::size(kKeys));
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
  float seconds = 0;
  bool ctrl = false;
  ImVec2 wheel;
  if (!late_text_.empty()) take_text(std::exchange(late_text_, {}), false);
  for (const platform::Event& event : events)
    if (const auto* const tick = std::get_if<platform::Tick>(&event)) seconds += static_cast<float>(tick->dt);
  // A press comes at any time since the last poll; a longer time than a second is an idle window's wait for it.
  polled_ = time_ + std::max(0.0, static_cast<double>(seconds) - 1);
  time_ += static_cast<double>(seconds);
  for (const platform::Event& event : events) {
    if (const auto* const move = std::get_if<platform::MouseMove>(&event))
      mouse_ = {move->x, move->y}, finger_ = move->finger;
    else if (const auto* const turn = std::get_if<platform::Wheel>(&event)) wheel.x += turn->dx, wheel.y += turn->dy;
    else if (const auto* const press = std::get_if<platform::MouseButton>(&event)) {
      modifiers_ = press->modifiers;
      ctrl = ctrl || press->modifiers.ctrl;
      take_button(*press);
    } else if (const auto* const key = std::get_if<platform::KeyPress>(&event)) {
      modifiers_ = key->modifiers;
      ctrl = ctrl || key->modifiers.ctrl;
      take_key(*key, text_has_keyboard);
    } else if (const auto* const text = std::get_if<platform::TextInput>(&event)) {
      take_text(text->utf8, ctrl);
    } else if (const auto* const focus = std::get_if<platform::Focus>(&event); focus != nullptr && !focus->focused) {
      modifiers_ = {};
      waiting_.clear();
      down_ = {};
      held_ = {}, presses_of_key_ = {};
    }
  }
  wheel.y += scrolled_by_finger();
  show_mouse(wheel);
  show_keys();
  set_modifiers(modifiers_.ctrl, modifiers_.shift, modifiers_.alt);
  const int behind = popups_behind_lists();
  listing_ = behind < open_popups();
  set_list_keys((listing_ || page_of_choices) && !text_has_keyboard);
  // All of them: a menu inside another one would open again under the mouse.
  if (listing_ && !text_has_keyboard && pressed(events, Key::escape)) ImGui::ClosePopupToLevel(behind, true);
  // For fingers widgets reach half of the way to the next one.
  ImGuiStyle& style = ImGui::GetStyle();
  style.TouchExtraPadding = finger_ ? ImVec2(0.5f * style.ItemSpacing.x, 0.5f * style.ItemSpacing.y) : ImVec2();
  io.DeltaTime = seconds > 0 ? seconds : 1e-4f;  // ImGui asserts a positive step
}

base::Result<ImGuiRenderer> ImGuiRenderer::make(const gfx::Gl& gl) {
  auto program = gfx::make_program(gl, {.name = "panels", .vertex = kVertexShader, .fragment = kFragmentShader});
  if (!program) return program.status();
  return ImGuiRenderer(gl, std::move(*program));
}

ImGuiRenderer::ImGuiRenderer(const gfx::Gl& gl, gfx::ShaderProgram program)
    : gl_(&gl),
      program_(std::move(program)),
      array_(gfx::make_vertex_array(gl)),
      vertices_(gfx::make_buffer(gl)),
      indices_(gfx::make_buffer(gl)) {
  gl.BindVertexArray(array_.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
  for (GLuint i = 0; i < 3; ++i) gl.EnableVertexAttribArray(i);
  gl.BindVertexArray(0);
}

void ImGuiRenderer::update_textures() {
  upload_textures([this](std::uintptr_t id, int width, int height, const void* pixels) {
    if (pixels == nullptr) {
      textures_.erase(id);
      return;
    }
    gfx::GlObject& texture = textures_[id];
    if (texture.id() == 0) texture = gfx::generate<&gfx::Gl::GenTextures, &gfx::Gl::DeleteTextures>(*gl_);
    gl_->BindTexture(GL_TEXTURE_2D, texture.id());
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  });
}

void ImGuiRenderer::draw(const ImDrawData& data, int width, int height) {
  if (width < 1 || height < 1 || data.DisplaySize.x < 1 || data.DisplaySize.y < 1) return;
  gl_->Viewport(0, 0, width, height);
  gl_->Disable(GL_DEPTH_TEST);
  gl_->Disable(GL_CULL_FACE);
  gl_->Enable(GL_BLEND);
  gl_->Enable(GL_SCISSOR_TEST);
  gl_->BlendEquation(GL_FUNC_ADD);
  gl_->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_->ActiveTexture(GL_TEXTURE0);
  update_textures();
  program_.use();
  program_.set("image", 0);
  program_.set("scale", glm::vec4(2.0f / data.DisplaySize.x, -2.0f / data.DisplaySize.y,
                                  -1.0f - data.DisplayPos.x * 2.0f / data.DisplaySize.x,
                                  1.0f + data.DisplayPos.y * 2.0f / data.DisplaySize.y));
  gl_->BindVertexArray(array_.id());
  for (const ImDrawList* const list : lists_of(data)) draw_list(*list, data.DisplayPos, width, height);
  gl_->BindVertexArray(0);
  gl_->BindTexture(GL_TEXTURE_2D, 0);
  gl_->UseProgram(0);
  gl_->Disable(GL_SCISSOR_TEST);
  gl_->Disable(GL_BLEND);
}

void ImGuiRenderer::draw_list(const ImDrawList& list, ImVec2 origin, int width, int height) {
  gl_->BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  gl_->BufferData(GL_ARRAY_BUFFER, list.VtxBuffer.Size * static_cast<GLsizeiptr>(sizeof(ImDrawVert)),
                  list.VtxBuffer.Data, GL_STREAM_DRAW);
  gl_->BufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.Size * static_cast<GLsizeiptr>(sizeof(ImDrawIdx)),
                  list.IdxBuffer.Data, GL_STREAM_DRAW);
  unsigned first = 0;
  vertices_from(*gl_, first);
  for (const ImDrawCmd& command : list.CmdBuffer) {
    if (command.UserCallback != nullptr) continue;  // the program queues none
    const int left = std::max(0, static_cast<int>(command.ClipRect.x - origin.x));
    const int top = std::max(0, static_cast<int>(command.ClipRect.y - origin.y));
    const int right = std::min(width, static_cast<int>(command.ClipRect.z - origin.x));
    const int bottom = std::min(height, static_cast<int>(command.ClipRect.w - origin.y));
    if (right <= left || bottom <= top) continue;
    gl_->Scissor(left, height - bottom, right - left, bottom - top);
    const std::uintptr_t id = texture_of(command);
    const auto own = textures_.find(id);
    gl_->BindTexture(GL_TEXTURE_2D, own != textures_.end() ? own->second.id() : static_cast<GLuint>(id));
    if (command.VtxOffset != first) vertices_from(*gl_, first = command.VtxOffset);
    gl_->DrawElements(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount),
                      sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
                      offset(command.IdxOffset * sizeof(ImDrawIdx)));
  }
}

}  // namespace coaster::ui
