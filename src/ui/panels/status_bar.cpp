// The status bar: selection, length, speed, g, fps, unsaved changes, and the last message. Parts that do not fit are
// left out, the least important first.
#include <imgui.h>

#include <cmath>

#include <fmt/format.h>

#include "base/utf8.h"
#include "ui/context/rows.h"
#include "ui/panels/panels.h"
#include "ui/widgets/theme.h"

namespace coaster::ui {
namespace {

struct Part {
  std::string label, value;
  std::string_view tooltip;
  float cell;  // design px kept for the value, so that neighbours stand still
};

std::string real(const Ui& ui, std::string_view name, int decimals, const char* unit) {
  const auto number = number_of(ui, name);
  return number ? measured(ui, *number, decimals, unit) : "--";
}

std::vector<Part> parts(const Ui& ui) {
  const edit::Session& session = ui.session();
  const double fps = ui.state.stats.fps;
  const bool timed = !ui.state.scripted && fps > 0;
  return {{"Selection", world::label_of(session.document, session.settings.selected), "The selection.", 36},
          {"Length", real(ui, "length", 1, "m"), "Length of the track.", 76},
          {"Speed", real(ui, "ride.speed", 1, "m/s"), "Speed of the first cart.", 68},
          {"g", real(ui, "ride.g_up", 1, "g"), "Felt acceleration towards the rider's head.", 40},
          {"fps", timed ? fixed(fps, 0) : "--", "Frames per second.", 28}};
}

std::string shortened(std::string words, float room) {
  if (text_size(words).x <= room) return words;
  while (!words.empty() && text_size(words).x + text_size("\u2026").x > room)
    words.resize(base::utf8_start(words, words.size() - 1).size());
  return words + "\u2026";
}

}  // namespace

void build_status_bar(Ui& ui, const view::Viewport& area) {
  if (area.width < 1 || area.height < 1) return;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, colour(palette().raised));
  if (begin_area("##status", {area.x, area.y}, {area.width, area.height})) {
    ui.panel = "Status";
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float pad = std::floor(10 * ui.scale), gap = std::floor(6 * ui.scale), between = std::floor(18 * ui.scale);
    const float top = std::floor(area.y + (area.height - ImGui::GetTextLineHeight()) * 0.5f),
                right = area.x + area.width - pad;
    float x = area.x + pad;
    const bool unsaved = edit::dirty(ui.state.find);
    const auto draw = [&](const std::string& words, std::uint32_t tint, float at) {
      draw_text(list, {at, top}, tint, words);
    };
    const auto place = [&](std::string_view label, std::string_view kind_tooltip, std::string value, float from,
                           float to) {
      note(ui, label, "label", kind_tooltip, true, std::move(value), {from, area.y}, {to, area.y + area.height});
    };
    const std::string mark = unsaved ? "\u25CF unsaved" : "saved";
    draw(mark, unsaved ? palette().warning : palette().dim, x);
    const float mark_end = x + std::max(text_size(mark).x, text_size("\u25CF unsaved").x);
    place("Unsaved", "Whether the track has unsaved changes.", unsaved ? "on" : "off", x, mark_end);
    x = mark_end + between;
    for (const Part& part : parts(ui)) {
      const float value_width = std::max(text_size(part.value).x, std::floor(part.cell * ui.scale));
      const float end = x + text_size(part.label).x + gap + value_width;
      if (end > right) break;
      draw(part.label, palette().dim, x);
      draw(part.value, palette().text, end - text_size(part.value).x);
      place(part.label, part.tooltip, part.value, x, end);
      x = end + between;
    }
    // The last message stays here after its toast is gone, shortened to fit.
    const auto& notices = ui.session().notices.list;
    if (!notices.empty() && right - x > 60 * ui.scale) {
      const edit::Notice& last = notices.back();
      const std::uint32_t tint = last.kind == edit::NoticeKind::error     ? palette().error
                                 : last.kind == edit::NoticeKind::warning ? palette().warning
                                                                          : palette().dim;
      const std::string message = in_units(ui, last.text), words = shortened(message, right - x);
      draw(words, tint, right - text_size(words).x);
      place("Message", message, message, right - text_size(words).x, right);
    }
  }
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  ui.panel.clear();
}

}  // namespace coaster::ui
