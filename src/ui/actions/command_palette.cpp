#include "ui/actions/command_palette.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "base/text.h"
#include "edit/commands/codec.h"
#include "ui/widgets/theme.h"

namespace coaster::ui {
namespace {

constexpr int kShown = 12;

// One line of the list: an action, a command, or the typed text if it is a command.
struct PaletteLine {
  std::string name, keys;
  std::string_view help;
  const Action* action = nullptr;
  std::string_view command;  // its first word
  bool typed = false;
  bool enabled = true;  // otherwise `help` says why not
  Match match;
};

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words(1);
  for (const char c : base::lower(text))
    if (std::string_view(" ._/,:;|").find(c) == std::string_view::npos) words.back() += c;
    else if (!words.back().empty()) words.emplace_back();
  if (words.back().empty()) words.pop_back();
  return words;
}

// True if the word is nearly one of the name, or its beginning.
bool is_typo(const std::string& word, const std::vector<std::string>& in_name) {
  constexpr std::size_t kShort = 4;  // letters; nearly everything is near to shorter words
  if (word.size() < kShort) return false;
  std::vector<std::string> near = in_name;
  for (const std::string& whole : in_name) near.push_back(whole.substr(0, word.size()));
  return base::nearest(word, near).has_value();
}

std::optional<edit::Command> parsed(const char* line) {
  std::vector<base::Token> tokens;
  base::TextError error;
  if (!base::tokenise(line, tokens, error) || tokens.empty()) return std::nullopt;
  const auto command = edit::parse(tokens, error);
  return command ? std::optional(*command) : std::nullopt;
}

// Returns what is wrong in a line that begins with the command and goes on; "" for other lines.
std::string wrong_in(const char* line, std::string_view command) {
  std::vector<base::Token> tokens;
  base::TextError error;
  if (!base::tokenise(line, tokens, error)) return base::sentence(error.message);
  if (tokens.size() < 2 || tokens[0].text != command || edit::parse(tokens, error)) return "";
  return base::sentence(error.message);
}

// Returns the entries that miss the least of the words, best first: what can run now, then the grey ones. A name typed
// in full is first in any case, to say why it cannot run.
std::vector<PaletteLine> entries(ActionContext& act, const char* words) {
  std::vector<PaletteLine> list;
  for (const Action& action : actions())
    if (action.name != "Command palette") {
      const bool enabled = action.enabled.holds(act);
      list.push_back({.name = std::string(action.name),
                      .keys = act.ui.keys.shown(action.name),
                      .help = enabled ? action.help : action.enabled.otherwise,
                      .action = &action,
                      .enabled = enabled,
                      .match = match(words, action.name, action.help)});
    }
  for (const edit::CommandHelp& command : edit::command_table())
    list.push_back({.name = command.usage,
                    .help = command.info.help,
                    .command = command.info.name,
                    .match = match(words, command.info.name, fmt::format("{} {}", command.usage, command.info.help))});
  const int all = 2 * static_cast<int>(words_of(words).size());
  int least = all;
  for (const PaletteLine& line : list) least = std::min(least, line.match.missing);
  if (all > 0 && least == all) list.clear();
  std::erase_if(list, [&](const PaletteLine& line) { return line.match.missing > least; });
  const std::string wanted = base::lower(words);
  const auto rank = [&](const PaletteLine& line) {
    return std::tuple(base::lower(line.name) == wanted, line.enabled, line.match.score);
  };
  std::stable_sort(list.begin(), list.end(),
                   [&](const PaletteLine& a, const PaletteLine& b) { return rank(a) > rank(b); });
  if (parsed(words))
    list.insert(list.begin(), PaletteLine{.name = words, .keys = "Enter", .help = "Run this command.", .typed = true});
  return list;
}

// Commands that replace the track ask about unsaved changes first.
void run_command(Ui& ui, const edit::Command& command) {
  if (edit::info(command).traits.replaces) ui.replace(command);
  else ui.out.commands.push_back(command);
}

void choose(ActionContext& act, CommandPalette& palette, const PaletteLine& entry) {
  if (!entry.enabled) {
    act.ui.warn(base::sentence(std::string(entry.help)));
    palette.filled = true;
  } else if (entry.action) {
    palette.open = false;
    entry.action->run(act);
  } else if (entry.typed) {
    palette.open = false;
    run_command(act.ui, *parsed(palette.text.data()));
  } else if (const std::string problem = wrong_in(palette.text.data(), entry.command); !problem.empty()) {
    act.ui.warn(problem);
    palette.filled = true;
  } else {  // a command needs its arguments
    const std::string line = std::string(entry.command) + " ";
    std::memcpy(palette.text.data(), line.c_str(), std::min(line.size() + 1, palette.text.size()));
    palette.filled = true, palette.row = 0;
    if (const auto whole = parsed(line.c_str()); whole && entry.name == entry.command) {  // unless it has none
      palette.open = false;
      run_command(act.ui, *whole);
    }
  }
}

int to_end(ImGuiInputTextCallbackData* data) {
  auto& palette = *static_cast<CommandPalette*>(data->UserData);
  if (!palette.filled) return 0;
  data->DeleteChars(0, data->BufTextLen);
  data->InsertChars(0, palette.text.data());
  data->CursorPos = data->SelectionStart = data->SelectionEnd = data->BufTextLen;
  palette.filled = false;
  return 0;
}

// Draws a row. Returns true if it was clicked.
bool draw_row(Ui& ui, const PaletteLine& entry, bool chosen) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x;
  const bool pressed = ImGui::Selectable(hidden(entry.name).c_str(), chosen);
  note_item(ui, entry.name, "item", entry.help, entry.enabled, entry.keys);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float gap = 14 * ui.scale, keys = entry.keys.empty() ? 0 : text_size(entry.keys).x + gap;
  const std::string name = shortened(entry.name, room - keys);
  const float help = text_size(name).x + gap;
  draw_text(list, at, entry.enabled ? palette().text : palette().dim, name);
  draw_text(list, {at.x + help, at.y}, palette().dim, shortened(entry.help, room - keys - help));
  draw_text(list, {at.x + room - text_size(entry.keys).x, at.y}, palette().accent, entry.keys);
  return pressed;
}

}  // namespace

Match match(std::string_view words, std::string_view name, std::string_view help) {
  const std::vector<std::string> in_name = words_of(name), in_help = words_of(help);
  const auto starts = [](const std::string& word) {
    return [&](const std::string& other) { return other.starts_with(word); };
  };
  Match result;
  for (const std::string& word : words_of(words)) {
    const auto found = std::ranges::find_if(in_name, starts(word));
    if (found != in_name.end()) result.score += (found == in_name.begin() ? 20 : 12) + (*found == word ? 4 : 0);
    else if (base::lower(name).find(word) != std::string::npos) result.score += 8;
    else if (std::ranges::any_of(in_help, starts(word))) result.score += 2;
    else result.missing += is_typo(word, in_name) ? 1 : 2;
  }
  return result;
}

void toggle_palette(CommandPalette& palette) {
  const bool open = !palette.open;
  palette = {};
  palette.open = palette.appearing = open;
}

void build_palette(ActionContext& act, CommandPalette& palette) {
  if (!palette.open) return;
  Ui& ui = act.ui;
  const float width = std::floor(std::min(620 * ui.scale, ImGui::GetIO().DisplaySize.x - 20)),
              top = act.scene.y + 40 * ui.scale;
  const ImVec2 at(std::floor(act.scene.x + (act.scene.width - width) * 0.5f), std::floor(top));
  const Card card{.id = "##commands",
                  .panel = "Palette",
                  .at = at,
                  .width = width,
                  .padding = {12, 12},
                  .flags = ImGuiWindowFlags_NoDecoration};
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  if (palette.appearing) ImGui::SetNextWindowFocus();
  build_card(ui, card, [&] {
    ImGui::SetNextItemWidth(-1);
    if (palette.appearing || palette.filled)
      ImGui::SetKeyboardFocusHere();  // Enter has left the field; typing continues a completed command
    const std::string before = palette.text.data();
    const bool entered = ImGui::InputTextWithHint(
        "##text", "Type an action or a command", palette.text.data(), palette.text.size(),
        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackAlways, to_end, &palette);
    note_item(ui, "Text", "text", "Part of a name, or a whole command as in scripts.", true, palette.text.data());
    if (before != palette.text.data()) palette.row = 0;
    const std::vector<PaletteLine> list = entries(act, palette.text.data());
    const int count = static_cast<int>(list.size());
    if (ImGui::IsKeyPressed(ImGuiKey_DownArrow)) ++palette.row;
    if (ImGui::IsKeyPressed(ImGuiKey_UpArrow)) --palette.row;
    palette.row = count > 0 ? (palette.row + count) % count : 0;
    const int first = std::clamp(palette.row - kShown + 1, 0, std::max(0, count - kShown));
    for (int i = first; i < std::min(count, first + kShown); ++i)
      if (const PaletteLine& line = list[static_cast<std::size_t>(i)]; draw_row(ui, line, i == palette.row))
        choose(act, palette, line);
    if (count == 0) heading(ui, "No matches.", "");
    if (entered && count > 0) choose(act, palette, list[static_cast<std::size_t>(palette.row)]);
    else if (entered) palette.filled = true;
    // Escape, or a click elsewhere.
    const bool elsewhere = !palette.appearing && ImGui::IsMouseClicked(ImGuiMouseButton_Left) &&
                           !ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows);
    if (ImGui::IsKeyPressed(ImGuiKey_Escape) || elsewhere) palette.open = false;
    palette.appearing = false;
  });
  ImGui::PopStyleVar();
}

}  // namespace coaster::ui
