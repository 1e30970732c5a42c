// Hints, the legend, the card and ring of lessons, cards of progress, and notices.
#include "ui/screens/hud.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "edit/commands/set_setting.h"
#include "ui/plots/plot_axes.h"
#include "ui/tools/selecting.h"
#include "ui/tools/show_places.h"
#include "ui/widgets/theme.h"
#include "view/colour_map.h"
#include "view/gizmo.h"
#include "world/aid_settings.h"
#include "world/camera_feel.h"
#include "world/laboratory_settings.h"
#include "world/motion.h"
#include "world/panel_settings.h"
#include "world/sections.h"

namespace coaster::ui {
namespace {

using Steps = std::vector<std::pair<std::string, std::string>>;

// Returns the user's keys and what they do in the workspace.
Steps first_steps(const Ui& ui) {
  const auto k = [&](std::string_view action) { return ui.keys.shown(action); };
  Steps steps;
  switch (ui.session().settings.panels->workspace) {
    case world::Workspace::ride:
      steps = {{k("Play or pause"), fmt::format("play and pause; {} returns to the start", k("Reset"))},
               {fmt::format("{} {} {}", k("Orbit camera"), k("Ride camera"), k("Chase camera")),
                "orbit, rider's view, behind the train"},
               {k("Next track colours"), "colour the track by speed, g and more"},
               {k("Panels"), "hide the bars"},
               {k("Build workspace"), "the workspace Build"}};
      break;
    case world::Workspace::laboratory:
      steps = {{k("Next evaluator"),
                fmt::format("next evaluator; {} more steps, {} fewer", k("More steps"), k("Fewer steps"))},
               {"Click", "select a segment: the pages show it"},
               {k("Probe on"), fmt::format("move the probe along the curve; {} back", k("Probe back"))},
               {k("Next track colours"), "colour the track by curvature, error and more"},
               {k("Build workspace"), "the workspace Build"}};
      break;
    case world::Workspace::all:
    case world::Workspace::build:
      steps = {{"Palette", fmt::format("click an element; {} places it", k("Place element"))},
               {"Click", "select a section or a knot, then drag its handles"},
               {fmt::format("{} {} {}", k("Move"), k("Rotate"), k("Scale")),
                "move, rotate, scale; then X, Y, Z or a number"},
               {k("Play or pause"),
                fmt::format("ride; {} rider's view, {} orbit view", k("Ride camera"), k("Orbit camera"))},
               {k("Laboratory"), "the laboratory: curves, errors, forces"},
               {k("Undo"), "undo, any number of steps"}};
      break;
  }
  // In every workspace.
  steps.insert(steps.begin() + 1, {"Drag", fmt::format("orbit; wheel zooms, {} frames all", k("Frame all"))});
  steps.emplace_back(k("Command palette"), "find any action or command");
  return steps;
}

constexpr float kHintsWidth = 398, kHintsHeight = 240, kMargin = 14;  // design px

// Only where they cover at most half of the scene's height: on a phone they would hide the track.
bool hints_show(const Ui& ui, const view::Viewport& scene) {
  return ui.session().settings.aids->show_hints && ui.state.lesson == nullptr && !card_shows(ui.session()) &&
         scene.width >= (kHintsWidth + 2 * kMargin) * ui.scale && scene.height >= 2 * kHintsHeight * ui.scale;
}

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

ImU32 opaque(glm::vec3 colour) { return ImGui::ColorConvertFloat4ToU32({colour.x, colour.y, colour.z, 1}); }

// Draws from left to right, interpolated as in the shader.
void draw_bar(ImDrawList& list, ImVec2 at, float width, float height) {
  constexpr std::size_t kPieces = view::kColourStops.size() - 1;
  for (std::size_t i = 0; i < kPieces; ++i) {
    const float left = at.x + width * static_cast<float>(i) / kPieces,
                right = at.x + width * static_cast<float>(i + 1) / kPieces;
    const ImU32 from = opaque(view::kColourStops[i]), to = opaque(view::kColourStops[i + 1]);
    list.AddRectFilledMultiColor({left, at.y}, {right, at.y + height}, from, to, to, from);
  }
}

// Returns a pulse by the clock, 0..1; 1 in scripts, which have no clock, and with reduced motion.
float breath(const UiState& state) {
  constexpr double kPerSecond = 0.7;
  return state.scripted || state.session.settings.feel->reduced_motion
             ? 1.0f
             : static_cast<float>(0.5 + 0.5 * std::cos(2 * base::kPi * kPerSecond * state.seconds));
}

void ring(const UiState& state, const Widget& widget, float scale, const LessonLine& line) {
  const float grow = std::floor((3 + 3 * breath(state)) * scale);
  const ImVec2 low(widget.x - grow, widget.y - grow),
      high(widget.x + widget.width + grow, widget.y + widget.height + grow);
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  list.AddRect(low, high, packed(palette().warning), 5 * scale, 0, 2.5f * scale);
  list.AddLine({line.from.x, line.from.y}, {line.to.x, line.to.y}, packed(palette().warning, 0.55f), 1.5f * scale);
}

// `done`: 0..1, 0 also if it is not known: then a piece of the bar moves. `height` in design px.
void progress_bar(WidgetFrame& ui, double done, float height, std::uint32_t rgb, std::string_view tooltip) {
  ImGui::PushStyleColor(ImGuiCol_PlotHistogram, colour(rgb));
  ImGui::ProgressBar(static_cast<float>(done), {-1, sized(std::floor(height * ui.scale))}, "");
  ImGui::PopStyleColor();
  if (done <= 0) {
    constexpr float kPiece = 0.25f;  // of the width
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const float width = high.x - low.x, at = static_cast<float>(std::fmod(ImGui::GetTime() * 0.5, 1.0));
    const float left = low.x + (1 - kPiece) * width * (1 - std::abs(2 * at - 1));
    ImGui::GetWindowDrawList()->AddRectFilled({left, low.y}, {left + kPiece * width, high.y}, packed(rgb),
                                              ImGui::GetStyle().FrameRounding);
  }
  note_item(ui, "Progress", "label", tooltip, true, fixed(100 * done, 0) + " %");
}

std::string words_of(const MovieState& movie) {
  if (movie.encoding) return "Encoding the movie";
  return fmt::format("{} s, {} {}", fixed(static_cast<double>(movie.ticks) * world::kTick, 1), movie.frames,
                     movie.frames == 1 ? "picture" : "pictures");
}

// The sign of recording, left of the text.
void draw_dot(bool recording) {
  const float height = ImGui::GetTextLineHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::GetWindowDrawList()->AddCircleFilled({at.x + height * 0.5f, at.y + height * 0.5f}, height * 0.32f,
                                              packed(recording ? palette().error : palette().accent), 24);
  ImGui::Dummy(sized({height, height}));
  ImGui::SameLine();
}

// Returns a card in the middle of the scene's width, `top` px below its upper edge.
Card card_in(const view::Viewport& scene, const char* id, std::string_view panel, float width, float top) {
  const ImVec2 at(std::floor(scene.x + (scene.width - width) * 0.5f), std::floor(scene.y + top));
  return {.id = id, .panel = panel, .at = at, .width = width};
}

constexpr double kFade = 0.4;          // s, the end of its lifetime
constexpr double kMoreTime = 2;        // s for each line above the newest notice
constexpr std::size_t kMostLines = 3;  // above it

double lifetime(edit::NoticeKind kind) { return kind == edit::NoticeKind::info ? 4.0 : 6.0; }

std::uint32_t colour_of(edit::NoticeKind kind) {
  switch (kind) {
    case edit::NoticeKind::info: return palette().accent;
    case edit::NoticeKind::warning: return palette().warning;
    case edit::NoticeKind::error: return palette().error;
  }
  return palette().accent;
}

}  // namespace

std::string foot_text(const ViewportTool& tool, const edit::Session& session, const KeyMap& keys) {
  if (tool.transform().active())
    return fmt::format("{}     X Y Z axis \u00B7 Shift plane \u00B7 digits \u00B7 Enter \u00B7 {}",
                       tool.transform().status(), keys.shown("Cancel"));
  if (tool.box_waits())
    return fmt::format("Drag a box around knots. Shift adds, Ctrl removes, {} cancels.", keys.shown("Cancel"));
  if (GroundBrush::chosen(session))
    return fmt::format("{} The wheel sets the size, with Ctrl it zooms; {} leaves.",
                       base::row_of(session.settings.aids->brush).help, keys.shown("Cancel"));
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
      ui.emit(edit::Set<&world::EditingAids::show_hints>{false});
  });
}

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

void draw_legend(Ui& ui, const view::Viewport& scene) {
  const world::Settings& settings = ui.session().settings;
  if (settings.lab->colouring == world::Colouring::plain || !settings.lab->layers.has(world::Layer::legend)) return;
  const world::ColouringRow& row = base::row_of(settings.lab->colouring);
  const base::ShownUnit unit = base::shown_in(ui.units, row.unit);
  const float scale = ui.scale, margin = std::floor(14 * scale), pad = std::floor(10 * scale),
              bar = std::floor(11 * scale);
  const float text = small_pixels();
  const float width = std::min(std::floor(240 * scale), scene.width - 2 * (margin + pad)),
              height = 2 * text + bar + std::floor(10 * scale);
  if (width < 120 * scale || scene.height < height + 2 * (margin + pad)) return;
  const ImVec2 low(scene.x + margin + pad, scene.y + margin + pad);  // notices and hints are at the bottom
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddRectFilled({low.x - pad, low.y - pad}, {low.x + width + pad, low.y + height + pad},
                     packed(palette().background, 0.82f), std::floor(6 * scale));
  draw_small(list, low, palette().text, fmt::format("{} ({})", row.label, unit.name));
  const ImVec2 bar_at(low.x, low.y + text + std::floor(5 * scale));
  draw_bar(list, bar_at, width, bar);
  const AxisRange axis{ui.state.stats.colour_low * unit.factor, ui.state.stats.colour_high * unit.factor};
  const Ticks marks = ticks(axis, 6);
  float free_from = low.x;  // texts that would touch the previous one are left out
  for (const double value : marks.major) {
    const float x = std::floor(low.x + width * static_cast<float>(part_of(axis, value)));
    const std::string number = tick_text(axis, marks, value, true);
    const float wide = small_size(number).x;
    list.AddLine({x, bar_at.y + bar}, {x, bar_at.y + bar + 4 * scale}, packed(palette().dim));
    const float left = std::clamp(x - wide * 0.5f, low.x, low.x + width - wide);
    if (left < free_from) continue;
    draw_small(list, {left, bar_at.y + bar + std::floor(5 * scale)}, palette().dim, number);
    free_from = left + wide + std::floor(6 * scale);
  }
}

bool LessonGuide::begins(const query::LessonCard* lesson) const {
  constexpr int kFrames = 10;  // a panel that opens, then a column that scrolls
  return lesson != nullptr && (lesson->number != number || frames < kFrames);
}

void LessonGuide::follow(const query::LessonCard* lesson, const std::vector<Widget>& widgets) {
  target.reset(), marked.reset();
  frames = lesson != nullptr && lesson->number == number ? frames + 1 : 0;
  number = lesson != nullptr ? lesson->number : 0;
  if (lesson == nullptr) return;
  for (std::string path = lesson->widget; !path.empty() && !marked;) {
    for (const Widget& widget : widgets) {
      if (!widget.is(path)) continue;
      if (path == lesson->widget) target = widget;
      if (widget.visible) marked = widget;
    }
    const std::size_t slash = path.rfind('/');
    path.resize(slash == std::string::npos ? 0 : slash);
  }
}

LessonLine lesson_line(const LessonBox& card, const LessonBox& target) {
  const glm::vec2 from = glm::clamp(0.5f * (target.low + target.high), card.low, card.high);
  return {from, glm::clamp(from, target.low, target.high)};
}

void draw_lesson(Ui& ui, const view::Viewport& scene, const LessonGuide& guide) {
  const query::LessonCard* const lesson = ui.state.lesson;
  if (lesson == nullptr) return;
  const float width = std::min(std::floor(430 * ui.scale), scene.width - 16 * ui.scale);
  const ImVec2 middle(std::floor(scene.x + 0.5f * scene.width), std::floor(scene.y + 14 * ui.scale));
  LessonBox box;
  ImGui::PushStyleColor(ImGuiCol_Border, colour(palette().warning));
  const Card card{.id = "##lesson",
                  .panel = "Lesson",
                  .at = middle,
                  .pivot = {0.5f, 0},
                  .width = width,
                  .padding = {16, 12},
                  .alpha = 0.95f};
  build_card(ui, card, [&] {
    // The buttons are above the text, so that they stay in place from lesson to lesson.
    ImGui::AlignTextToFramePadding();
    tinted_line(fmt::format("Lesson {} of {}", lesson->number, lesson->count), palette().warning);
    const ImGuiStyle& style = ImGui::GetStyle();
    const float buttons =
        text_size("Show me").x + text_size("Leave").x + 4 * style.FramePadding.x + style.ItemSpacing.x;
    ImGui::SameLine(std::floor(ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x - buttons));
    if (button(ui, "Show me", "Let the tutorial do this step.")) ui.out.lesson_answer = query::LessonAnswer::show;
    ImGui::SameLine();
    if (button(ui, "Leave", "Leave the tutorial. The track stays as it is."))
      ui.out.lesson_answer = query::LessonAnswer::leave;
    paragraph(ui, "Text", lesson->text, palette().text);
    if (lesson->strayed)
      paragraph(ui, "Strayed", "You changed something else. Show me undoes that and does this step.",
                palette().warning);
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    box = {{low.x, low.y}, {low.x + size.x, low.y + size.y}};
  });
  ImGui::PopStyleColor();
  if (!guide.marked) return;
  const Widget& at = *guide.marked;
  const LessonBox target{{at.x, at.y}, {at.x + at.width, at.y + at.height}};
  ring(ui.state, at, ui.scale, lesson_line(box, target));
}

bool draw_job(WidgetFrame& ui, const view::Viewport& scene, const JobState& job) {
  if (!job.progress) return false;
  bool cancels = false;
  Card card = card_in(scene, "##job", job.panel, std::floor(360 * ui.scale), scene.height * 0.4f);
  card.padding = {14, 12};
  card.flags = ImGuiWindowFlags_NoDecoration;
  ImGui::SetNextWindowFocus();
  build_card(ui, card, [&] {
    ImGui::TextWrapped("%.*s", static_cast<int>(job.title.size()), job.title.data());
    progress_bar(ui, job.progress->done.load(), 8, palette().accent, "Part of the work that is done.");
    cancels = button(ui, "Cancel", "Cancel. The track stays as it is. Key Escape.", !job.progress->cancelled) ||
              ImGui::IsKeyPressed(ImGuiKey_Escape);
  });
  return cancels;
}

void draw_movie(Ui& ui, const view::Viewport& scene) {
  const MovieState* const movie = ui.state.movie;
  if (!movie) return;
  const float width = std::floor(std::min(340 * ui.scale, scene.width - 16 * ui.scale));
  Card card = card_in(scene, "##movie", "Movie", width, 10 * ui.scale);
  card.padding = {12, 9};
  card.flags |= ImGuiWindowFlags_NoNav;
  build_card(ui, card, [&] {
    draw_dot(!movie->encoding);
    const std::string words = words_of(*movie);
    ImGui::TextUnformatted(words.c_str());
    note_item(ui, "State", "label", "Recorded so far.", true, words);
    const float button_width = std::floor(64 * ui.scale);
    ImGui::SameLine(ImGui::GetWindowWidth() - button_width - 12 * ui.scale);
    if (button(ui, "Stop",
               movie->encoding ? "Cancel encoding. The pictures are kept."
                               : "Stop recording. Otherwise it stops at the end of the lap.",
               true, button_width))
      ui.out.movie = MovieRequest::stop;
    progress_bar(ui, movie->done, 6, movie->encoding ? palette().accent : palette().error,
                 "Part of the lap that is recorded, then part of the movie that is encoded.");
  });
}

void NoticeDisplay::update(const edit::Session& session, double seconds, bool scripted, bool over) {
  if (over) since += seconds - updated;
  updated = seconds;
  const std::vector<edit::Notice>& notices = session.notices.list;
  if (!notices.empty() && notices.back().serial != serial) {
    edit::NoticeKind most = notices.back().kind;
    std::string text;
    std::size_t lines = 0, left_out = 0;
    const std::uint64_t seen = std::max(serial, session.notices.before);
    for (const edit::Notice& notice : std::span(notices).first(notices.size() - 1)) {
      if (notice.serial <= seen || notice.kind == edit::NoticeKind::info) continue;
      most = std::max(most, notice.kind);
      if (lines < kMostLines) text += notice.text + "\n", ++lines;
      else ++left_out;
    }
    if (left_out > 0) text += fmt::format("and {} more\n", left_out);
    serial = notices.back().serial;
    show(most, text + notices.back().text, seconds);
    lasts += kMoreTime * static_cast<double>(lines);
  }
  if (!scripted && seconds - since > lasts) shown.clear();
}

void NoticeDisplay::show(edit::NoticeKind what, std::string text, double seconds) {
  kind = what;
  shown = std::move(text);
  since = seconds;
  lasts = lifetime(kind);
}

double NoticeDisplay::still_for(double seconds) const {
  if (shown.empty()) return std::numeric_limits<double>::infinity();
  return std::max(0.0, lasts - kFade - (seconds - since));
}

void NoticeDisplay::draw(const Ui& ui, const view::Viewport& viewport) const {
  if (shown.empty()) return;
  const std::string words = in_units(ui, shown);
  const float scale = ui.scale;
  const double seconds = ui.state.seconds;
  const float alpha =
      ui.state.scripted ? 1.0f : static_cast<float>(std::clamp((lasts - (seconds - since)) / kFade, 0.0, 1.0));
  const float margin = 12 * scale, pad = 10 * scale, bar = 4 * scale;
  const float room = std::max(40.0f, std::min(520 * scale, viewport.width - 2 * margin) - 2 * pad - bar);
  const ImVec2 size = ImGui::CalcTextSize(words.c_str(), nullptr, false, room);
  const float width = size.x + 2 * pad + bar, height = size.y + 2 * pad * 0.8f;
  const ImVec2 low(std::floor(viewport.x + (viewport.width - width) * 0.5f),
                   std::floor(viewport.y + viewport.height - height - margin));
  const ImVec2 high(low.x + width, low.y + height);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddRectFilled(low, high, packed(palette().raised, 0.96f * alpha), 4 * scale);
  list.AddRectFilled(low, {low.x + bar, high.y}, packed(colour_of(kind), alpha), 4 * scale,
                     ImDrawFlags_RoundCornersLeft);
  list.AddRect(low, high, packed(palette().border, alpha), 4 * scale);
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {low.x + bar + pad, low.y + pad * 0.8f},
               packed(palette().text, alpha), words.c_str(), nullptr, room + 1);
}

}  // namespace coaster::ui
