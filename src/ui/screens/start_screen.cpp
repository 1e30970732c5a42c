// Choices on the left, pictures on the right.
#include "ui/screens/start_screen.h"
#include "ui/context/rows.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <variant>

#include "base/folders.h"
#include "ui/widgets/medals.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widget_parts.h"

namespace coaster::ui {
namespace {

constexpr float kCardsInARow = 4, kChoices = 220;  // cards in a row; design px of the left part

// A hill, a loop and a dip in one line: the program's mark.
void draw_emblem(ImVec2 at, float size) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto p = [&](float x, float y) { return ImVec2(at.x + x * size, at.y + y * size); };
  const ImU32 colour = packed(palette().accent);
  const float thick = std::max(2.0f, size * 0.075f);
  list.AddBezierCubic(p(0.0f, 0.86f), p(0.14f, 0.86f), p(0.1f, 0.3f), p(0.24f, 0.3f), colour, thick);
  list.AddBezierCubic(p(0.24f, 0.3f), p(0.38f, 0.3f), p(0.34f, 0.86f), p(0.62f, 0.86f), colour, thick);
  list.AddCircle(p(0.62f, 0.56f), 0.3f * size, colour, 48, thick);
  list.AddBezierCubic(p(0.62f, 0.86f), p(0.8f, 0.86f), p(0.86f, 0.7f), p(1.0f, 0.7f), colour, thick);
}

std::vector<std::filesystem::path> sample_tracks() {
  std::vector<std::filesystem::path> files;
  const std::filesystem::path folder = base::data_folder() / "tracks";
  if (const auto entries = base::list_folder(folder))
    for (const base::FolderEntry& entry : *entries)
      if (!entry.folder && entry.name.ends_with(".json")) files.push_back(folder / entry.name);
  return files;
}

bool escaped(const platform::Events& events) {
  return std::any_of(events.begin(), events.end(), [](const platform::Event& event) {
    const auto* press = std::get_if<platform::KeyPress>(&event);
    return press != nullptr && press->down && !press->repeat && press->key == platform::Key::escape;
  });
}

}  // namespace

void StartScreen::load(Ui& ui, const std::filesystem::path& file) { ui.want = {Want::Kind::load, file.string()}; }

void StartScreen::build_choices(Ui& ui, float width) {
  const float size = std::floor(64 * ui.scale);
  draw_emblem(ImGui::GetCursorScreenPos(), size);
  ImGui::Dummy({size, size});
  ImGui::PushFont(title_font());
  ImGui::TextUnformatted("coaster");
  ImGui::PopFont();
  ImGui::PushStyleColor(ImGuiCol_Text, colour(palette().dim));
  ImGui::TextUnformatted("Build it, measure it, ride it.");
  ImGui::PopStyleColor();
  ImGui::Dummy({0, std::floor(8 * ui.scale)});
  ui.panel = "Start";
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(8 * ui.scale, 8 * ui.scale));
  const UserState* const kept = ui.state.kept;
  std::error_code ignored;
  const std::filesystem::path last =
      kept != nullptr && !kept->settings.recent.empty() ? kept->settings.recent.front() : "";
  if (button(ui, "Continue", last.empty() ? "No recent track." : "Open " + last.string() + ", the most recent track.",
             !last.empty() && std::filesystem::exists(last, ignored), width))
    load(ui, last);
  if (button(ui, "New track", with_keys(ui.keys, "Start an empty track. Click on the ground to place knots.", "New"),
             true, width))
    ui.want = {Want::Kind::fresh};
  if (button(ui, "Open or import",
             with_keys(ui.keys, "Open a coaster track, or import one of NoLimits (.csv, .nltrack, .nl2elem).", "Open"),
             true, width))
    ui.want = {Want::Kind::browse};
  if (button(ui, "Tutorial", "Build and ride your first coaster, step by step.", true, width))
    ui.want = {Want::Kind::tutorial};
  if (button(ui, "Challenges",
             with_keys(ui.keys, "Tracks to improve, each with a goal and three medals.", "Challenges"), true, width))
    ui.want = {Want::Kind::challenges};
  if (button(ui, "Back to the track###Build on", "Close this page. Key Escape.", true, width)) open_ = false;
  if (button(ui, "Quit", with_keys(ui.keys, "Quit coaster.", "Quit"), true, width)) ui.want = {Want::Kind::quit};
  ImGui::PopStyleVar();
  if (kept != nullptr)
    if (const auto on = checkbox(ui, "Show at start", kept->settings.start_screen,
                                 "Show this page at start when no track is given.")) {
      ui.out.settings = kept->settings;
      ui.out.settings->start_screen = *on;
    }
}

bool StartScreen::draw(Ui& ui, const Card& card, float width) {
  const TrackPicture* picture = nullptr;
  if (ui.state.pictures != nullptr)
    if (const auto found = ui.state.pictures->find(card.picture); found != ui.state.pictures->end())
      picture = &found->second;
  if (!card.picture.empty()) ui.out.wanted_pictures.push_back(card.picture);
  ImGui::PushFont(small_font());
  const float height = std::floor(width * 9 / 16), line = ImGui::GetTextLineHeight(), round = 5 * ui.scale;
  const ImVec2 low = ImGui::GetCursorScreenPos(), high(low.x + width, low.y + height);
  const bool clicked = ImGui::InvisibleButton(hidden(card.label).c_str(), {width, height + std::floor(1.4f * line)});
  const bool hot = ImGui::IsItemHovered();
  const std::string name = !card.name.empty() ? card.name : picture != nullptr ? picture->name : "";
  note_item(ui, card.label, "button", picture != nullptr && !picture->problem.empty() ? picture->problem : card.help,
            true, name);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (picture != nullptr && picture->texture != 0)
    list.AddImageRounded((ImTextureID)(std::uintptr_t)picture->texture, low, high, {0, 0}, {1, 1}, IM_COL32_WHITE,
                         round);
  else list.AddRectFilled(low, high, packed(palette().field), round);
  list.AddRect(low, high, packed(hot ? palette().accent : palette().border), round, 0, hot ? 2.5f * ui.scale : 1.0f);
  const float medal = std::floor(26 * ui.scale);
  if (card.medal > 0) draw_medal(list, {high.x - medal - 4 * ui.scale, low.y + 4 * ui.scale}, medal, card.medal, true);
  const std::string length =
      card.name.empty() && picture != nullptr && picture->length > 0 ? fixed(picture->length, 0) + " m" : "";
  const float foot = high.y + 0.2f * line, room = text_size(length).x;
  list.PushClipRect(low, {high.x - room - 4 * ui.scale, high.y + 1.4f * line}, true);
  list.AddText({low.x + 2, foot}, packed(palette().text), name.c_str());
  list.PopClipRect();
  list.AddText({high.x - room - 2, foot}, packed(palette().dim), length.c_str());
  ImGui::PopFont();
  return clicked;
}

void StartScreen::build_challenges(Ui& ui, float width, float gap) {
  if (shelf_.empty()) shelf_.read(ui.state.kept != nullptr ? ui.state.kept->challenges : std::filesystem::path());
  heading(ui, "Challenges", "Tracks to improve, each with a goal and three medals.");
  int place = 0;
  for (const ChallengeEntry& entry : shelf_.entries()) {
    if (place++ % static_cast<int>(kCardsInARow) != 0) ImGui::SameLine(0, gap);
    const std::string help = entry.problem.empty() ? entry.teaches : entry.problem;
    if (draw(ui, {"Challenges/" + entry.name, entry.track.string(), help, entry.name, known_medal(ui, entry.path)},
             width) &&
        entry.problem.empty())
      ui.want = {Want::Kind::challenge, entry.path.string()};
  }
}

void StartScreen::build_tracks(Ui& ui) {
  if (samples_.empty()) samples_ = sample_tracks();
  const float gap = std::floor(12 * ui.scale);
  const float width = std::floor((ImGui::GetContentRegionAvail().x - (kCardsInARow - 1) * gap) / kCardsInARow);
  const auto grid = [&](std::string_view group, const std::vector<std::filesystem::path>& files) {
    int place = 0;
    for (const std::filesystem::path& file : files) {
      if (place++ % static_cast<int>(kCardsInARow) != 0) ImGui::SameLine(0, gap);
      const auto namesakes = std::count_if(
          files.begin(), files.end(), [&](const std::filesystem::path& other) { return other.stem() == file.stem(); });
      const std::string name =
          namesakes > 1 ? (file.parent_path().filename() / file.stem()).string() : file.stem().string();
      if (draw(ui, {std::string(group) + "/" + name, file.string(), "Open " + file.string() + ".", {}, 0}, width))
        load(ui, file);
    }
  };
  std::vector<std::filesystem::path> recent;
  std::error_code ignored;
  if (ui.state.kept != nullptr)
    for (const std::string& file : ui.state.kept->settings.recent)
      if (recent.size() < static_cast<std::size_t>(kCardsInARow) && std::filesystem::exists(file, ignored))
        recent.emplace_back(file);
  if (!recent.empty()) {
    heading(ui, "Recent", "Recently used tracks.");
    grid("Recent", recent);
  }
  heading(ui, "Samples", "Sample tracks.");
  grid("Samples", samples_);
  build_challenges(ui, width, gap);
}

void StartScreen::build(Ui& ui, const platform::Events& events, float width, float height) {
  if (!open_) return;
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({width, height});
  ImGui::SetNextWindowBgAlpha(0.72f);
  constexpr ImGuiWindowFlags kFlags =
      ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
  ImGui::Begin("##start", nullptr, kFlags);
  ui.panel = "Start";
  const float wide = std::min(width - 24 * ui.scale, 1180 * ui.scale),
              high = std::min(height - 24 * ui.scale, 760 * ui.scale);
  ImGui::SetCursorPos({std::floor((width - wide) / 2), std::floor((height - high) / 2)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(24 * ui.scale, 22 * ui.scale));
  ImGui::PushStyleColor(ImGuiCol_ChildBg, colour(palette().background, 0.97f));
  if (ImGui::BeginChild("##page", {wide, high}, true)) {
    const float left = std::floor(kChoices * ui.scale);
    ImGui::BeginChild("##choices", {left, 0});
    build_choices(ui, left);
    ImGui::EndChild();
    ImGui::SameLine(0, std::floor(24 * ui.scale));
    ImGui::BeginChild("##tracks", {0, 0});
    ui.panel = "Start";
    build_tracks(ui);
    ImGui::EndChild();
  }
  ImGui::EndChild();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  ui.panel.clear();
  ImGui::End();
  if (escaped(events)) open_ = false;
}

}  // namespace coaster::ui
