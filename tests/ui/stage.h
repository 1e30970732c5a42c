// A UI on an off-screen surface with a session, operated like a user: events in, commands out and applied, frame by
// frame.
#pragma once

#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/files.h"
#include "edit/commands/commands_document.h"
#include "edit/commands/commands_settings.h"
#include "edit/perform/apply.h"
#include "edit/session/session.h"
#include "platform/surface.h"
#include "ui/host/host.h"
#include "ui/widgets/imgui_compat.h"

namespace coaster::ui {

// An open track of three knots, off-origin and skew, with a cart.
inline void build_track(edit::Session& session, base::Files& files) {
  const glm::vec3 places[] = {{-17.3f, 4.1f, 6.7f}, {3.9f, 9.6f, -2.3f}, {21.1f, 5.3f, 8.9f}};
  for (const glm::vec3 place : places) EXPECT_TRUE(edit::apply(session, files, edit::AppendKnot{place}).ok());
  EXPECT_TRUE(edit::apply(session, files, edit::AddTrain{{{world::EntityKind::segment, 1}}, 0.25}).ok());
  EXPECT_TRUE(edit::apply(session, files, edit::Select{}).ok());
}

struct DrawnGlyph {
  unsigned codepoint;
  ImVec2 low, high;  // px
  int vertex;        // the first of its four
};
// Calls visit(glyph) for each glyph in the fonts' texture.
inline void for_each_glyph(const auto& visit) {
#if IMGUI_VERSION_NUM >= 19200
  auto& fonts = ImGui::GetIO().Fonts->Builder->BakedPool;  // in sizes that were drawn
  for (int i = 0; i < fonts.Size; ++i)
    for (const ImFontGlyph& glyph : fonts[i].Glyphs) visit(glyph);
#else
  for (const ImFont* const font : ImGui::GetIO().Fonts->Fonts)
    for (const ImFontGlyph& glyph : font->Glyphs) visit(glyph);
#endif
}
inline float font_pixels() { return pixels_of(*ImGui::GetIO().Fonts->Fonts[0]); }

// Returns the characters that a list draws, found by their places in the fonts' texture.
inline std::vector<DrawnGlyph> drawn_glyphs(const ImDrawList& list) {
  static std::map<std::array<float, 4>, unsigned> glyphs;
  static std::array<float, 3> of{};  // the fonts that they are of
  std::array<float, 3> now{font_pixels()};
  for_each_glyph([&](const ImFontGlyph& g) { now[1] += 1, now[2] += g.U0 + g.V0 * 1.7f; });
  if (of != now) {
    of = now, glyphs.clear();
    for_each_glyph([&](const ImFontGlyph& g) {
      if (g.Visible) glyphs.try_emplace({g.U0, g.V0, g.U1, g.V1}, g.Codepoint);
    });
  }
  std::vector<DrawnGlyph> found;
  for (int i = 0; i + 3 < list.VtxBuffer.Size; ++i) {
    const ImDrawVert &a = list.VtxBuffer[i], &b = list.VtxBuffer[i + 2];
    const auto glyph = glyphs.find({a.uv.x, a.uv.y, b.uv.x, b.uv.y});
    if (glyph == glyphs.end()) continue;
    found.push_back({glyph->second, a.pos, b.pos, i});
    i += 3;
  }
  return found;
}
// Returns their text: words and lines are joined by single spaces.
inline std::string drawn_text(const ImDrawList& list) {
  std::string text;
  ImVec2 end(0, 0);
  const float size = font_pixels();
  for (const DrawnGlyph& glyph : drawn_glyphs(list)) {
    if (!text.empty() && (glyph.low.x > end.x + 0.17f * size || glyph.low.x < end.x - size)) text += ' ';
    text += glyph.codepoint < 128 ? static_cast<char>(glyph.codepoint) : '?';
    end = glyph.high;
  }
  return text;
}

class Stage : public testing::Test {
 protected:
  void SetUp() override {
    auto surface = platform::make_offscreen({.size = {width_, height_}});
    ASSERT_TRUE(surface.ok()) << surface.status().message;
    surface_ = std::move(*surface);
    auto gl = gfx::load_gl([&](const char* name) { return surface_->gl_proc(name); });
    ASSERT_TRUE(gl.ok()) << gl.status().message;
    gl_ = *gl;
    restart();
    build_track(session_, files_);
  }
  void TearDown() override { host_.reset(); }

  void restart() {
    host_.reset();
    auto host = Host::make(gl_);
    ASSERT_TRUE(host.ok()) << host.status().message;
    host_ = std::move(*host);
  }
  void resize(int width, int height) {
    width_ = width;
    height_ = height;
    frames(2);
  }

  // One frame of 1/60 s; its commands are applied and kept in commands_.
  Output frame(platform::Events events = {}) {
    events.emplace_back(platform::Tick{1.0 / 60});
    seconds_ += 1.0 / 60;
    UiState state{session_, stats_, seconds_, scripted_, nullptr, user_ ? &*user_ : nullptr};
    state.pictures = &pictures_;
    state.lesson = lesson_;
    state.content_scale = density_;
    state.job = job_;
    state.movie = movie_ ? &*movie_ : nullptr;
    Output out = host_->build(events, state, width_, height_);
    for (const edit::Command& command : out.commands) {
      (void)edit::apply(session_, files_, command);
      commands_.push_back(command);
    }
    last_ = out;
    return out;
  }
  void frames(int count) {
    for (int i = 0; i < count; ++i) frame();
  }

  const Widget* find(const std::string& path) const {
    for (const Widget& widget : host_->widgets())
      if (widget.is(path)) return &widget;
    return nullptr;
  }
  static glm::vec2 middle(const Widget& w) { return {w.x + w.width / 2, w.y + w.height / 2}; }

  // Turns the wheel over the widget's column until it is in sight; false when it cannot be brought there.
  bool reach(const std::string& path) {
    frames(2);
    for (int i = 0; i < 80; ++i) {
      const Widget* widget = find(path);
      if (widget == nullptr) return false;
      if (widget->visible) return true;
      const float y = static_cast<float>(height_) * 0.5f, x = middle(*widget).x;
      frame({platform::MouseMove{x, y}, platform::Wheel{0, widget->y > y ? -1.0f : 1.0f}});
      frame();
    }
    return false;
  }
  void hover(glm::vec2 pixel) { frame({platform::MouseMove{pixel.x, pixel.y}}); }
  void press(platform::Modifiers m = {}, platform::Button b = platform::Button::left) {
    frame({platform::MouseButton{b, true, m}});
  }
  void release(platform::Modifiers m = {}, platform::Button b = platform::Button::left) {
    frame({platform::MouseButton{b, false, m}});
  }
  void click_at(glm::vec2 pixel, platform::Modifiers m = {}) {
    hover(pixel);
    press(m);
    release(m);
    frame();
  }
  void click(const std::string& path, platform::Modifiers m = {}) {
    ASSERT_TRUE(reach(path)) << path;
    click_at(middle(*find(path)), m);
  }
  void key(platform::Key k, platform::Modifiers m = {}) {
    frame({platform::KeyPress{k, true, false, m}});
    frame({platform::KeyPress{k, false, false, {}}});
  }
  void type(const std::string& path, const std::string& text, bool enter = true) {
    const Widget* widget = find(path);
    click(path, {.ctrl = widget != nullptr && widget->kind != "text"});
    key(platform::Key::a, {.ctrl = true});
    frame({platform::TextInput{text}});
    if (enter) key(platform::Key::enter);
  }

  // Rests the mouse on a widget and returns the words of its tooltip.
  std::string words_over(const std::string& path) {
    if (!reach(path)) return "not found: " + path;
    hover(middle(*find(path)));
    frames(40);
    for (const ImGuiWindow* const window : ImGui::GetCurrentContext()->Windows)
      if ((window->Flags & ImGuiWindowFlags_Tooltip) != 0 && window->Active) return drawn_text(*window->DrawList);
    return {};
  }

  // Returns where a knot is on the screen, in the view of the last frame.
  glm::vec2 pixel_of(std::uint32_t knot) const {
    const auto at =
        view::project(host_->view(), world::knot(session_.document, entity(world::EntityKind::knot, knot)).position);
    EXPECT_TRUE(at.has_value());
    return at ? glm::vec2(*at) : glm::vec2(0);
  }
  world::Entity entity(world::EntityKind kind, std::uint32_t number) const {
    return world::find(session_.document, {kind, number});
  }
  const world::Knot& knot(std::uint32_t number) const {
    return world::knot(session_.document, entity(world::EntityKind::knot, number));
  }
  void select(world::EntityKind kind, std::uint32_t number) {
    ASSERT_TRUE(edit::apply(session_, files_, edit::Select{{{kind, number}}}).ok());
    frames(2);
  }
  // Returns a pixel of the viewport that shows only ground.
  glm::vec2 empty_ground() const {
    const view::Viewport& v = host_->view().viewport;
    return {std::floor(v.x + v.width * 0.5f) + 3, std::floor(v.y + v.height * 0.93f)};
  }

  template <class C>
  std::vector<C> all() const {
    std::vector<C> found;
    for (const edit::Command& command : commands_)
      if (const C* c = command.as<C>()) found.push_back(*c);
    return found;
  }

  int width_ = 1280, height_ = 720;
  float density_ = 1;  // pixels per point of the screen
  bool scripted_ = false;
  double seconds_ = 0;
  std::unique_ptr<platform::Surface> surface_;
  gfx::Gl gl_;
  std::unique_ptr<Host> host_;
  base::Files files_;
  edit::Session session_ = edit::make_session({});
  query::FrameStats stats_;
  std::optional<UserState> user_;
  const query::LessonCard* lesson_ = nullptr;
  JobState job_;
  std::optional<MovieState> movie_;
  std::map<std::string, TrackPicture> pictures_;  // of the start screen
  std::vector<edit::Command> commands_;
  Output last_;
};

}  // namespace coaster::ui
