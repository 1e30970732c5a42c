// The status bar: unsaved changes, evaluator and steps, length, speed, g, selection, fps, and the last message. Parts
// that do not fit are left out, the least important first.
#include <imgui.h>

#include <cmath>

#include <fmt/format.h>

#include "ui/context/rows.h"
#include "ui/panels/panels.h"
#include "ui/widgets/theme.h"
#include "world/sections.h"

namespace coaster::ui {
namespace {

struct Part {
  std::string label, value;
  std::string_view tooltip;
  float cell;  // design px reserved for the value, so that neighbours do not move
};

std::string real(const Ui& ui, std::string_view name, int decimals, const char* unit) {
  const auto number = number_of(ui, name);
  return number ? measured(ui, *number, decimals, unit) : "--";
}

// Returns "Climb" for a section, "3 sections" or "4 knots" for several, else the name.
std::string selection_text(const edit::Session& session) {
  const world::Entity selected = session.settings.selected;
  const auto* const section = session.document.entities.find<world::Section>(selected);
  if (!session.settings.also.empty())
    return fmt::format("{} {}", session.settings.also.size() + 1, section ? "sections" : "knots");
  return section ? world::title_of(*section) : world::label_of(session.document, selected);
}

std::vector<Part> parts(const Ui& ui) {
  const edit::Session& session = ui.session();
  const double fps = ui.state.stats.fps;
  const bool timed = !ui.state.scripted && fps > 0;
  return {{"Length", real(ui, "length", 1, "m"), "Length of the track, by the method selected in Evaluation.", 76},
          {"Speed", real(ui, "ride.speed", 1, "m/s"), "Speed of the first train.", 68},
          {"g", real(ui, "ride.g_up", 1, "g"), "Felt g towards the rider's head, not low-passed.", 40},
          {"Selection", selection_text(session), "The selection.", 36},
          {"fps", timed ? fixed(fps, 0) : "--", "Frames per second.", 28}};
}

// Position of the next part of the bar.
struct Bar {
  Ui& ui;
  ImDrawList& list;
  float top, bottom, text_top;  // px
  float x, right;
  float between;

  void draw(std::string_view words, std::uint32_t tint, float at) const {
    draw_text(list, {at, text_top}, tint, words);
  }
  void place(std::string_view label, std::string_view tooltip, std::string value, float from, float to) const {
    note(ui, label, "label", tooltip, true, std::move(value), {from, top}, {to, bottom});
  }
};

void unsaved_mark(Bar& bar) {
  const bool unsaved = edit::dirty(bar.ui.find);
  const bool none = bar.ui.session().file.path.empty();  // it has no file
  const std::string_view word = unsaved ? (none ? "not saved yet" : "unsaved") : none ? "no file" : "saved";
  const std::string mark = unsaved ? fmt::format("\u25CF {}", word) : std::string(word);
  bar.draw(mark, unsaved ? palette().warning : palette().dim, bar.x);
  const float end = bar.x + std::max(text_size(mark).x, text_size("\u25CF unsaved").x);
  bar.place("Unsaved", "Whether the track's file has all of it.", std::string(word), bar.x, end);
  bar.x = end + bar.between;
}

// Shows the evaluator and its steps. A click opens the list of all evaluators.
void evaluator(Bar& bar) {
  Ui& ui = bar.ui;
  constexpr const char* kList = "##evaluators";
  const world::Evaluation& now = *ui.session().settings.evaluation;
  const std::string_view label = curve::evaluators()[static_cast<std::size_t>(now.evaluator)].label;
  const std::string words = fmt::format("{}, {} steps", label, now.steps);
  const float arrow = std::floor(16 * ui.scale);
  const ImVec2 low(bar.x, bar.top), high(bar.x + text_size(words).x + arrow, bar.bottom);
  if (high.x > bar.right) return;
  ImGui::SetCursorScreenPos(low);
  if (ImGui::InvisibleButton("##evaluator", sized({high.x - low.x, high.y - low.y}))) ImGui::OpenPopup(kList);
  const bool open = ImGui::IsPopupOpen(kList);
  const float pad = std::floor(4 * ui.scale);
  if (open || ImGui::IsItemHovered())
    bar.list.AddRectFilled({low.x - pad, low.y}, {high.x + pad, high.y}, packed(palette().field));
  bar.draw(words, palette().text, low.x);
  draw_fold_mark(bar.list, {high.x - arrow * 0.5f, (low.y + high.y) * 0.5f}, ui.scale, open);
  const std::string help = with_keys(ui.keys, "Evaluator and steps per segment. Click to choose.", "Next evaluator");
  note(ui, "Evaluator", "combo", open ? "" : help, true, words, low, high);
  bar.x = high.x + bar.between;
  if (!open) return;
  const ImVec2 padding(std::floor(10 * ui.scale), std::floor(8 * ui.scale));
  ImGui::SetNextWindowPos({low.x - pad, low.y}, ImGuiCond_Always, {0, 1});
  ImGui::SetNextWindowSize({sized(std::floor(320 * ui.scale)), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  if (ImGui::BeginPopup(kList)) {
    ui.panel = "Status/Evaluator";
    evaluator_choice(ui);
    steps_slider(ui);
    ui.panel = "Status";
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

void values(Bar& bar) {
  const float gap = std::floor(6 * bar.ui.scale);
  for (const Part& part : parts(bar.ui)) {
    const float value_width = std::max(text_size(part.value).x, std::floor(part.cell * bar.ui.scale));
    const float end = bar.x + text_size(part.label).x + gap + value_width;
    if (end > bar.right) return;
    bar.draw(part.label, palette().dim, bar.x);
    bar.draw(part.value, palette().text, end - text_size(part.value).x);
    bar.place(part.label, part.tooltip, part.value, bar.x, end);
    bar.x = end + bar.between;
  }
}

// Shows the last message after its toast is gone, shortened to fit.
void message(const Bar& bar) {
  const auto& notices = bar.ui.session().notices.list;
  if (notices.empty() || bar.right - bar.x <= 60 * bar.ui.scale) return;
  const edit::Notice& last = notices.back();
  const std::uint32_t tint = last.kind == edit::NoticeKind::error     ? palette().error
                             : last.kind == edit::NoticeKind::warning ? palette().warning
                                                                      : palette().dim;
  const std::string text = in_units(bar.ui, last.text), words = shortened(text, bar.right - bar.x);
  const float left = bar.right - text_size(words).x;
  bar.draw(words, tint, left);
  bar.place("Message", text, text, left, bar.right);
}

}  // namespace

void build_status_bar(Ui& ui, const view::Viewport& area) {
  if (area.width < 1 || area.height < 1) return;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, colour(palette().raised));
  if (begin_area("##status", {area.x, area.y}, {area.width, area.height})) {
    ui.panel = "Status";
    const float pad = std::floor(10 * ui.scale);
    Bar bar{ui,
            *ImGui::GetWindowDrawList(),
            area.y,
            area.y + area.height,
            std::floor(area.y + (area.height - ImGui::GetTextLineHeight()) * 0.5f),
            area.x + pad,
            area.x + area.width - pad,
            std::floor(18 * ui.scale)};
    unsaved_mark(bar);
    evaluator(bar);
    values(bar);
    message(bar);
  }
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  ui.panel.clear();
}

}  // namespace coaster::ui
