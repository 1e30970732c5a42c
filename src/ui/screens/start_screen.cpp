// The start screen: choices on the left, pictures on the right.
#include "ui/screens/start_screen.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "base/folders.h"
#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_session.h"
#include "exchange/challenge_file.h"
#include "query/challenge_rules.h"
#include "ui/screens/dialogs.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/imgui_compat.h"
#include "ui/widgets/theme.h"
#include "world/document.h"

namespace coaster::ui {
namespace {

// --- Lists of challenges

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
