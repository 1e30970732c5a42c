#include "ui/screens/challenge_list.h"
#include "ui/context/query_widgets.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/folders.h"
#include "exchange/challenge_file.h"
#include "query/challenge_rules.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/imgui_compat.h"
#include "ui/widgets/theme.h"

namespace coaster::ui {
namespace {

ChallengeEntry entry_of(const std::filesystem::path& path) {
  ChallengeEntry entry{path, path.stem().string(), {}, {}, {}};
  base::Files files;
  const base::Result<exchange::LoadedChallenge> loaded = exchange::load_challenge(files, path);
  if (!loaded) {
    entry.problem = loaded.status().message;
    return entry;
  }
  entry.name = loaded->challenge.name;
  entry.teaches = loaded->challenge.teaches;
  if (!loaded->challenge.track.empty()) entry.track = path.parent_path() / loaded->challenge.track;
  if (const base::Status readable = query::check_rules(loaded->challenge, path.string()); !readable)
    entry.problem = readable.message;
  return entry;
}

// Returns the first whole sentences of a text that fit in two small lines, else its first words.
std::string two_lines(const std::string& text, float width) {
  const auto fits = [&](const std::string& part) {
    const ImVec2 size = small_font()->CalcTextSizeA(small_pixels(), 1e9f, width, part.c_str());
    return size.y < 2.5f * small_pixels();
  };
  if (fits(text)) return text;
  std::string sentences, words;
  for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at + 1)) {
    const std::string part = text.substr(0, at);
    if (part.ends_with('.') && fits(part)) sentences = part;
    if (fits(part + "\u2026")) words = part + "\u2026";
  }
  return sentences.empty() ? words : sentences;
}

void draw_row(const Ui& ui, const ChallengeEntry& entry, int medal, ImVec2 low, ImVec2 high, bool current,
              bool hovered) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float pad = std::floor(8 * ui.scale), size = high.y - low.y - 2 * pad, left = low.x + size + 2.5f * pad;
  list.AddRectFilled(low, high, packed(hovered ? palette().field : palette().raised), 4 * ui.scale);
  if (current) list.AddRect(low, high, packed(palette().accent), 4 * ui.scale, 0, std::max(1.0f, 1.5f * ui.scale));
  draw_medal(list, {low.x + pad, low.y + pad}, size, std::max(medal, 1), medal > 0);
  draw_text(list, {left, low.y + pad * 0.75f}, entry.problem.empty() ? palette().text : palette().error, entry.name);
  const float line = ImGui::GetTextLineHeight();
  const float top = std::floor(low.y + pad * 0.75f + line + 2 * ui.scale);
  const std::string help = two_lines(in_units(ui, entry.help()), high.x - pad - left);
  list.AddText(small_font(), small_pixels(), {left, top}, packed(palette().dim), help.c_str(), nullptr,
               high.x - pad - left);
}

}  // namespace

std::vector<ChallengeEntry> read_challenges(const Ui& ui) {
  std::vector<ChallengeEntry> found;
  const std::filesystem::path data = base::data_folder();
  if (!data.empty())
    for (const std::filesystem::path& file : json_files(data / "challenges")) found.push_back(entry_of(file));
  if (ui.state.kept != nullptr && !ui.state.kept->challenges.empty())  // it need not exist
    for (const std::filesystem::path& file : json_files(ui.state.kept->challenges)) found.push_back(entry_of(file));
  return found;
}

std::optional<std::filesystem::path> draw_challenge_list(Ui& ui, std::span<const ChallengeEntry> challenges,
                                                         int& current, float height) {
  std::optional<std::filesystem::path> chosen;
  const int count = static_cast<int>(challenges.size());
  int step = 0;
  for (const auto& [key, by] :
       {std::pair{ImGuiKey_UpArrow, -1}, {ImGuiKey_DownArrow, 1}, {ImGuiKey_Home, -count}, {ImGuiKey_End, count}})
    if (ImGui::IsKeyPressed(key)) step = by;
  if (count > 0) current = std::clamp(current + step, 0, count - 1);
  const bool seen = ImGui::BeginChild("##challenges", {0, sized(height)});
  if (seen && count == 0) ImGui::TextUnformatted("No challenges found.");
  for (int i = 0; seen && i < count; ++i) {
    const ChallengeEntry& entry = challenges[static_cast<std::size_t>(i)];
    const int medal = known_medal(ui, entry.path);
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, tall = std::floor(62 * ui.scale);
    ImGui::PushID(i);
    const bool pressed = ImGui::InvisibleButton("##row", sized({width, tall}));
    const bool hovered = ImGui::IsItemHovered();
    ImGui::PopID();
    draw_row(ui, entry, medal, low, {low.x + width, low.y + tall}, i == current, hovered);
    if (i == current && step != 0) ImGui::SetScrollHereY();
    note(ui, entry.name, "button", entry.help(), entry.problem.empty(), std::string(medal_title(medal)), low,
         {low.x + width, low.y + tall});
    if (pressed) current = i;
    const bool by_key =
        i == current && (ImGui::IsKeyPressed(ImGuiKey_Enter, false) || ImGui::IsKeyPressed(kKeypadEnter, false));
    if ((pressed || by_key) && entry.problem.empty()) chosen = entry.path;
  }
  ImGui::EndChild();
  return chosen;
}

}  // namespace coaster::ui
