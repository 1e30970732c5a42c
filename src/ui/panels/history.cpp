// History: undo and redo steps. A click goes to a step.
#include <imgui.h>

#include <algorithm>

#include <fmt/format.h>

#include "edit/commands/commands_session.h"
#include "ui/context/ui.h"
#include "ui/widgets/theme.h"

namespace coaster::ui {
namespace {

constexpr std::size_t kMostShown = 200;  // rows on either side of the present state

template <class Command>
void repeat(Ui& ui, std::size_t steps) {
  for (std::size_t i = 0; i < steps; ++i) ui.emit(Command{});
}

// Returns "Undo to this step." and the command, which may name thousands of knots.
std::string tooltip_of(std::string_view does, const edit::HistoryStep& step) {
  constexpr std::size_t kMost = 120;  // bytes
  const std::string_view command = step.text.command;
  return fmt::format("{} Command: {}{}", does, command.substr(0, kMost), command.size() > kMost ? " ..." : "");
}

// Shows a step as a line to click; `name` is its path for scripts.
bool step_row(Ui& ui, const std::string& text, const std::string& name, std::uint32_t tint, std::string_view tooltip) {
  ImGui::PushStyleColor(ImGuiCol_Text, colour(tint));
  const bool pressed = ImGui::Selectable(fmt::format("{}##{}", text, name).c_str());
  ImGui::PopStyleColor();
  note_item(ui, name, "item", tooltip, true, text);
  return pressed;
}

}  // namespace

void history_panel(Ui& ui) {
  const edit::History& history = ui.session().history;
  const std::size_t undo = history.undo.size(), redo = history.redo.size();
  const double megabytes = static_cast<double>(history.bytes) / (1 << 20);
  read_out(ui, "Steps", fmt::format("{} undo, {} redo", undo, redo), "",
           "Steps that can be undone and redone. Camera, panels and selection are not included.");
  read_out(ui, "Memory", fixed(megabytes, 2), "MiB", "Memory of the steps. Beyond 256 MiB the oldest are dropped.");
  const std::size_t first = undo > kMostShown ? undo - kMostShown : 0;
  if (first == 0 && undo > 0 && step_row(ui, "Start", "Start", palette().dim, "Undo everything."))
    repeat<edit::Undo>(ui, undo);
  for (std::size_t i = first; i < undo; ++i) {
    const bool now = i + 1 == undo;
    if (step_row(ui, fmt::format("{}  {}", i + 1, in_units(ui, history.undo[i].text.sentence)), std::to_string(i + 1),
                 now ? palette().accent : palette().text,
                 tooltip_of(now ? "The current step." : "Undo to this step.", history.undo[i])))
      repeat<edit::Undo>(ui, undo - 1 - i);
  }
  // The redo stack has the next step last.
  for (std::size_t k = 0; k < std::min(redo, kMostShown); ++k) {
    const std::size_t number = undo + k + 1;
    if (step_row(ui, fmt::format("{}  {}", number, in_units(ui, history.redo[redo - 1 - k].text.sentence)),
                 std::to_string(number), palette().dim, tooltip_of("Redo to this step.", history.redo[redo - 1 - k])))
      repeat<edit::Redo>(ui, k + 1);
  }
}

}  // namespace coaster::ui
