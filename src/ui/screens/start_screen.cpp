// The start screen: choices on the left, pictures on the right.
#include "ui/screens/start_screen.h"
#include "ui/context/query_widgets.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "base/folders.h"
#include "edit/commands/commands_challenge.h"
#include "edit/commands/commands_session.h"
#include "ui/screens/dialogs.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/imgui_compat.h"
#include "ui/widgets/theme.h"
#include "world/track_name.h"

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

void draw_title(const Ui& ui) {
  const float size = std::floor(64 * ui.scale);
  draw_emblem(ImGui::GetCursorScreenPos(), size);
  ImGui::Dummy(sized({size, size}));
  ImGui::PushFont(title_font());
  ImGui::TextUnformatted("coaster");
  ImGui::PopFont();
  tinted_line("Build it, measure it, ride it.", palette().dim);
  ImGui::Dummy(sized({0, std::floor(8 * ui.scale)}));
}

}  // namespace

void StartScreen::build_choices(Ui& ui, float width) {
  if (constexpr float kWithTitle = 480; ImGui::GetContentRegionAvail().y >= kWithTitle * ui.scale) draw_title(ui);
  ui.panel = "Start";
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(8 * ui.scale, 8 * ui.scale));
  const UserState* const kept = ui.state.kept;
  std::error_code ignored;
  const std::filesystem::path last =
      kept != nullptr && !kept->settings.recent.empty() ? kept->settings.recent.front() : "";
  const auto choice = [&](std::string_view label, std::string_view help, std::string_view action, ScreenRequest want) {
    if (button(ui, label, with_keys(ui.keys, help, action), true, width)) ui.want = std::move(want);
  };
  if (button(ui, "Continue",
             last.empty() ? "No recent track." : fmt::format("Open {}, the most recent track.", last.string()),
             !last.empty() && std::filesystem::exists(last, ignored), width))
    ui.replace(edit::LoadTrack{last.string()});
  choice("New track", "Start an empty track. Click on the ground to place knots.", "New",
         {ScreenRequest::Kind::replace, ui.new_track()});
  choice("Open or import", "Open a track, or import one of NoLimits or openFVD (.csv, .nltrack, .nl2elem, .fvd).",
         "Open", {ScreenRequest::Kind::browse});
  choice("Tutorial", "Build and ride your first coaster, step by step.", "", {ScreenRequest::Kind::tutorial});
  choice("Challenges", "Tracks to improve, each with a goal and three medals.", "Challenges",
         {ScreenRequest::Kind::challenges});
  if (button(ui, "Back to the track###Build on", "Close this page. Key Escape.", true, width)) open_ = false;
  choice("Quit", "Quit coaster.", "Quit", {ScreenRequest::Kind::quit});
  ImGui::PopStyleVar();
  if (kept != nullptr)
    if (const auto on = checkbox(ui, "Show at start", kept->settings.start_screen,
                                 "Show this page at start when no track is given."))
      change_kept(ui).start_screen = *on;
}

bool StartScreen::draw(Ui& ui, const Card& card, float width) {
  const TrackPicture* picture = nullptr;
  if (ui.state.pictures != nullptr)
    if (const auto found = ui.state.pictures->find(card.picture); found != ui.state.pictures->end())
      picture = &found->second;
  ImGui::PushFont(small_font());
  const float height = std::floor(width * 9 / 16), line = ImGui::GetTextLineHeight(), round = 5 * ui.scale;
  const ImVec2 low = ImGui::GetCursorScreenPos(), high(low.x + width, low.y + height);
  const bool clicked = ImGui::InvisibleButton(hidden(card.label).c_str(),
                                              sized({width, height + std::floor(1.4f * line)}), kChosenByKeys);
  const bool hot = ImGui::IsItemHovered();
  if (!card.picture.empty() && ImGui::IsItemVisible()) ui.out.wanted_pictures.push_back(card.picture);
  ui.out.picture_width = static_cast<int>(width);
  const std::string name = !card.name.empty()   ? card.name
                           : picture != nullptr ? world::track_name(picture->name, card.picture)
                                                : "";
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
      card.name.empty() && picture != nullptr && picture->length > 0 ? measured(ui, picture->length, 0, "m") : "";
  const float foot = high.y + 0.2f * line, room = text_size(length).x;
  draw_text(list, {low.x + 2, foot}, palette().text, shortened(name, high.x - low.x - room - 8 * ui.scale));
  draw_text(list, {high.x - room - 2, foot}, palette().dim, length);
  ImGui::PopFont();
  return clicked;
}

void StartScreen::build_challenges(Ui& ui, float width, float gap) {
  if (challenges_.empty()) challenges_ = read_challenges(ui);
  heading(ui, "Challenges", "Tracks to improve, each with a goal and three medals.");
  int place = 0;
  for (const ChallengeEntry& entry : challenges_) {
    if (place++ % static_cast<int>(kCardsInARow) != 0) ImGui::SameLine(0, gap);
    const Card card{"Challenges/" + entry.name, entry.track.string(), entry.help(), entry.name,
                    known_medal(ui, entry.path)};
    if (draw(ui, card, width) && entry.problem.empty()) ui.replace(edit::StartChallenge{entry.path.string()});
  }
}

void StartScreen::build_tracks(Ui& ui) {
  if (samples_.empty()) {
    samples_ = json_files(base::data_folder() / "tracks");
    const auto in_park = [](const std::filesystem::path& file) {
      return file.filename().string().starts_with("park_");
    };
    std::stable_partition(samples_.begin(), samples_.end(), in_park);  // those first
  }
  const float gap = std::floor(12 * ui.scale);
  const float width = std::floor((ImGui::GetContentRegionAvail().x - (kCardsInARow - 1) * gap) / kCardsInARow);
  const auto grid = [&](std::string_view group, const std::vector<std::filesystem::path>& files) {
    int place = 0;
    for (const std::filesystem::path& file : files) {
      if (place++ % static_cast<int>(kCardsInARow) != 0) ImGui::SameLine(0, gap);
      const Card card{fmt::format("{}/{}", group, name_among(file, files, false)),
                      file.string(),
                      fmt::format("Open {}.", file.string()),
                      {},
                      0};
      if (draw(ui, card, width)) ui.replace(edit::LoadTrack{file.string()});
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
  ImGui::SetNextWindowSize(sized({width, height}));
  ImGui::SetNextWindowBgAlpha(0.72f);
  constexpr ImGuiWindowFlags kFlags =
      ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
  ImGui::Begin("##start", nullptr, kFlags);
  if (std::exchange(appearing_, false)) choose_first();
  ui.panel = "Start";
  const float wide = std::min(width - 24 * ui.scale, 1180 * ui.scale),
              high = std::min(height - 24 * ui.scale, 760 * ui.scale);
  ImGui::SetCursorPos({std::floor((width - wide) / 2), std::floor((height - high) / 2)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(24 * ui.scale, 22 * ui.scale));
  ImGui::PushStyleColor(ImGuiCol_ChildBg, colour(palette().background, 0.97f));
  ImGui::PushStyleColor(ImGuiCol_NavHighlight, colour(palette().accent));
  if (begin_part("##page", sized({wide, high}), true)) {
    const float left = std::floor(kChoices * ui.scale);
    begin_part("##choices", {sized(left), 0});
    build_choices(ui, left);
    ImGui::EndChild();
    ImGui::SameLine(0, std::floor(24 * ui.scale));
    begin_part("##tracks", {0, 0});
    ui.panel = "Start";
    build_tracks(ui);
    ImGui::EndChild();
  }
  ImGui::EndChild();
  ImGui::PopStyleColor(2);
  ImGui::PopStyleVar();
  ui.panel.clear();
  ImGui::End();
  if (pressed(events, platform::Key::escape)) open_ = false;
  if (pasted(events)) ui.out.wants_link = true;
}

}  // namespace coaster::ui
