// The first steps, shown until they are dismissed, and the hint at the bottom of the viewport.
#include "ui/screens/overlays.h"

#include <imgui.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "edit/commands/set_setting.h"
#include "ui/tools/places.h"
#include "ui/tools/section_clicks.h"
#include "ui/widgets/theme.h"
#include "view/section_handle.h"
#include "world/aids.h"
#include "world/panels.h"
#include "world/sections.h"

namespace coaster::ui {
namespace {

using Steps = std::vector<std::pair<std::string, std::string>>;

// Return the user's keys and what they do in a workspace.
Steps building_steps(const KeyMap& keys) {
  const auto k = [&](std::string_view action) { return keys.shown(action); };
  return {
      {"Palette", fmt::format("click an element; {} places it", k("Place element"))},
      {"Click", "select a section or a knot, then drag its handles"},
      {fmt::format("{} {} {}", k("Move"), k("Rotate"), k("Scale")), "move, rotate, scale; then X, Y, Z or a number"},
      {k("Play or pause"), fmt::format("ride; {} rider's view, {} orbit view", k("Ride camera"), k("Orbit camera"))},
      {k("Laboratory"), "the laboratory: curves, errors, forces"},
      {k("Undo"), "undo, any number of steps"}};
}
Steps riding_steps(const KeyMap& keys) {
  const auto k = [&](std::string_view action) { return keys.shown(action); };
  return {{k("Play or pause"), fmt::format("play and pause; {} returns to the start", k("Reset"))},
          {fmt::format("{} {} {}", k("Orbit camera"), k("Ride camera"), k("Chase camera")),
           "orbit, rider's view, behind the train"},
          {k("Next track colours"), "colour the track by speed, g and more"},
          {k("Panels"), "hide the bars"},
          {k("Build workspace"), "the workspace Build"}};
}
Steps laboratory_steps(const KeyMap& keys) {
  const auto k = [&](std::string_view action) { return keys.shown(action); };
  return {
      {k("Next evaluator"), fmt::format("next evaluator; {} more steps, {} fewer", k("More steps"), k("Fewer steps"))},
      {"Click", "select a segment: the pages show it"},
      {k("Probe on"), fmt::format("move the probe along the curve; {} back", k("Probe back"))},
      {k("Next track colours"), "colour the track by curvature, error and more"},
      {k("Build workspace"), "the workspace Build"}};
}

Steps first_steps(const Ui& ui) {
  const world::Workspace workspace = ui.session().settings.panels->workspace;
  Steps steps = workspace == world::Workspace::ride         ? riding_steps(ui.keys)
                : workspace == world::Workspace::laboratory ? laboratory_steps(ui.keys)
                                                            : building_steps(ui.keys);
  // In every workspace.
  steps.insert(steps.begin() + 1,
               {"Drag", fmt::format("orbit; wheel zooms, {} frames all", ui.keys.shown("Frame all"))});
  steps.emplace_back(ui.keys.shown("Command palette"), "find any action or command");
  return steps;
}

constexpr float kHintsWidth = 398, kHintsHeight = 240, kMargin = 14;  // design px

// Only where they cover at most half of the scene's height: on a phone they would hide the track.
bool hints_show(const Ui& ui, const view::Viewport& scene) {
  return ui.session().settings.aids->show_hints && ui.state.lesson == nullptr && !card_shows(ui.session()) &&
         scene.width >= (kHintsWidth + 2 * kMargin) * ui.scale && scene.height >= 2 * kHintsHeight * ui.scale;
}

}  // namespace

std::string foot_text(const ViewportTool& tool, const edit::Session& session, const KeyMap& keys) {
  if (tool.transform().active())
    return fmt::format("{}     X Y Z axis \u00B7 Shift plane \u00B7 digits \u00B7 Enter \u00B7 {}",
                       tool.transform().status(), keys.shown("Cancel"));
  if (tool.box_waits())
    return fmt::format("Drag a box around knots. Shift adds, Ctrl removes, {} cancels.", keys.shown("Cancel"));
  const bool empty = session.document.track.knots.empty();
  if (empty && session.settings.aids->show_element && !session.settings.aids->append_mode)
    return fmt::format("{} places the element, {} hides its preview", keys.shown("Place element"),
                       keys.shown("Cancel"));
  const world::Workspace workspace = session.settings.panels->workspace;
  if (empty && (workspace == world::Workspace::ride || workspace == world::Workspace::laboratory))
    return fmt::format("{} shows the elements to build with. Or click on the ground to place the first knot",
                       keys.shown("Build workspace"));
  if (empty) return "Choose an element, or click on the ground to place the first knot";
  if (session.settings.aids->append_mode && !session.document.track.closed)
    return fmt::format("Click on the ground to append knots; {} or {} ends it", keys.shown("Append points"),
                       keys.shown("Cancel"));
  return {};
}

view::Viewport beside_hints(const Ui& ui, const view::Viewport& scene, float width) {
  const float left = std::floor((kHintsWidth + kMargin) * ui.scale);
  if (!hints_show(ui, scene) || scene.width - left < width) return scene;
  return {scene.x + left, scene.y, scene.width - left, scene.height};
}

void draw_hints(Ui& ui, const view::Viewport& scene) {
  if (!hints_show(ui, scene)) return;
  const float width = std::floor(kHintsWidth * ui.scale), margin = std::floor(kMargin * ui.scale);
  // Below the track, clear of the notices at the bottom.
  const ImVec2 foot(std::floor(scene.x + margin), std::floor(scene.y + scene.height - 58 * ui.scale));
  const Card card{.id = "##hints", .panel = "Hints", .at = foot, .pivot = {0, 1}, .width = width, .alpha = 0.88f};
  build_card(ui, card, [&] {
    ImGui::TextUnformatted("First steps");
    for (const auto& [key, text] : first_steps(ui)) {
      const float start = ImGui::GetCursorPosX();
      tinted_line(key, palette().accent);
      note_item(ui, key, "label", "", true, text);
      ImGui::SameLine(start + std::floor(58 * ui.scale));
      tinted_line(text, palette().dim);
    }
    const std::string_view help = "Hide the first steps. View/Show/First steps shows them again.";
    if (button(ui, "Got it", with_keys(ui.keys, help, "First steps")))
      ui.emit(edit::Set<&world::Aids::show_hints>{false});
  });
}

namespace {

// Returns what a handle of a section changes, with its value: "Height 25.00 m".
std::string named_handle(const Ui& ui) {
  const edit::Session& session = ui.session();
  const view::Pick& at = ui.hovered;
  const auto named = [](std::string_view parameter, std::string_view value) {
    std::string name(parameter);
    name[0] = static_cast<char>(name[0] - 'a' + 'A');
    return fmt::format("{} {}", name, value);
  };
  if (const auto handle = view::angle_handle(session.document, session.derived, at.entity, at.kind)) {
    const std::string angle = measured(ui, handle->angle, 1, "\u00B0");
    if (handle->whole == 1) return named(handle->parameter, angle);
    return named(handle->parameter, fmt::format("{} ({})", fixed(handle->angle * handle->whole, 3), angle));
  }
  const auto handle = view::section_handle(session.document, session.derived, at.entity);
  return handle ? named(handle->parameter, measured(ui, handle->value, 2, "m")) : "";
}

// Returns the title of the section under the mouse, or what the handle there changes; empty for none.
std::string named_section(const Ui& ui) {
  const edit::Session& session = ui.session();
  if (view::is_section_handle(ui.hovered.kind)) return named_handle(ui);
  if (ui.hovered.kind == view::PickKind::spin)
    return fmt::format("Spin {} \u00B0/m",
                       fixed(base::degrees(double{world::knot(session.document, ui.hovered.entity).spin}), 2));
  const world::Entity section = section_under(session, ui.hovered);
  if (!section.valid() || ImGui::IsAnyMouseDown()) return {};
  return world::title_of(world::section(session.document, section));
}

}  // namespace

void draw_section_name(Ui& ui, const view::Viewport& scene) {
  const edit::Session& session = ui.session();
  const glm::vec2 mouse = mouse_position();
  if (session.settings.panels->workspace != world::Workspace::build || !scene.contains(mouse)) return;
  const std::string title = named_section(ui);
  if (title.empty() || ImGui::GetIO().WantCaptureMouse) return;
  const float pad = std::floor(8 * ui.scale), aside = std::floor(16 * ui.scale), width = text_size(title).x + 2 * pad;
  const bool left = mouse.x + aside + width > scene.x + scene.width, above = mouse.y > scene.y + 0.5f * scene.height;
  build_card(ui,
             {.id = "##section",
              .panel = "View",
              .at = {std::floor(mouse.x + (left ? -aside : aside)), std::floor(mouse.y + (above ? -aside : aside))},
              .pivot = {left ? 1.0f : 0.0f, above ? 1.0f : 0.0f},
              .width = width,
              .padding = {8, 5},
              .alpha = 0.88f,
              .flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoFocusOnAppearing},
             [&] {
               tinted_line(title, palette().text);
               note_item(ui, "Section", "label", "", true, title);
             });
}

void draw_foot_line(const Ui& ui, const ViewportTool& tool, const view::Viewport& scene) {
  const std::string hint = foot_text(tool, ui.session(), ui.keys);
  if (hint.empty()) return;
  const bool empty = ui.session().document.track.knots.empty() && !ui.session().settings.aids->show_element;
  const ImVec2 size = ImGui::CalcTextSize(hint.c_str());
  const ImVec2 pad(size.y * 0.9f, size.y * 0.5f);
  // Above the notices.
  const view::Viewport free = beside_hints(ui, scene, size.x + 2 * pad.x);
  const ImVec2 at(std::floor(free.x + (free.width - size.x) * 0.5f),
                  std::floor(empty ? scene.y + scene.height * 0.62f : scene.y + scene.height - 5.6f * size.y));
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddRectFilled({at.x - pad.x, at.y - pad.y}, {at.x + size.x + pad.x, at.y + size.y + pad.y},
                     packed(palette().background, 0.78f), size.y);
  draw_text(list, at, palette().text, hint);
}

}  // namespace coaster::ui
