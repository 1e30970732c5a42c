#include "ui/screens/overlays.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/text.h"
#include "edit/commands/commands_challenge.h"
#include "edit/commands/commands_ride.h"
#include "ui/screens/challenge_list.h"
#include "ui/tools/places.h"
#include "ui/widgets/medals.h"
#include "ui/widgets/theme.h"
#include "world/aids.h"

namespace coaster::ui {
namespace {

using edit::RideEnd;

// A name, a bar towards 10 and the number.
void rating(Ui& ui, const char* name, double value, std::uint32_t rgb, std::string_view tooltip) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x, line = ImGui::GetTextLineHeight(),
              bar = std::floor(6 * ui.scale);
  const float left = low.x + std::floor(room * 0.36f), right = low.x + room - std::floor(48 * ui.scale),
              y = std::floor(low.y + (line - bar) * 0.5f + 1);
  constexpr double kFull = 10;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_text(list, low, palette().dim, name);
  list.AddRectFilled({left, y}, {right, y + bar}, packed(palette().field), bar * 0.5f);
  const float filled = left + (right - left) * static_cast<float>(std::clamp(value / kFull, 0.0, 1.0));
  if (filled > left + bar) list.AddRectFilled({left, y}, {filled, y + bar}, packed(ink(rgb)), bar * 0.5f);
  const std::string number = fixed(value, 2);
  draw_text(list, {low.x + room - text_size(number).x, low.y}, palette().text, number);
  ImGui::Dummy({room, line});
  note(ui, name, "label", tooltip, true, number, low, {low.x + room, low.y + line});
}

constexpr std::string_view kTerms = "From g, drops, airtime, near misses, jolts and overloads.";

void few_numbers(Ui& ui, const edit::RideResult& result) {
  const sim::Ratings& r = result.ratings;
  if (result.end == RideEnd::failed)
    read_out(ui, "Time", fixed(result.seconds, 2), "s", "Time from the start to the failure.");
  else read_out(ui, result.end == RideEnd::lap ? "Lap time" : "Time", fixed(r.seconds, 2), "s", "Time of the ride.");
  read_out(ui, "Top speed", r.top_speed.value, 1, "m/s", "Highest speed of the ride.");
  rating(ui, "Excitement", r.excitement, 0x4FB477, kTerms);
}

void more_numbers(Ui& ui, const sim::Ratings& r) {
  rating(ui, "Intensity", r.intensity, 0xF2B84B, kTerms);
  rating(ui, "Nausea", r.nausea, 0xE5534B, kTerms);
  read_out(ui, "Length", r.length, 1, "m", "Length of the track.");
  read_out(ui, "Highest drop", r.highest_drop, 1, "m", fmt::format("Largest of {} descents of 3 m or more.", r.drops));
  read_out(ui, "Airtime", fixed(r.airtime, 2), "s", "Time with vertical g below 0.");
  read_out(ui, "Vertical g", fmt::format("{} .. {}", fixed(r.up_least.value, 2), fixed(r.up_most.value, 2)), "g",
           "Smallest and largest, low-pass filtered, all cars.");
  read_out(ui, "Lateral g", fixed(r.side_most.value, 2), "g", "Largest to either side, low-pass filtered.");
  read_out(ui, "Inversions", std::to_string(r.inversions), "", "Number of times that riders are upside down.");
}

void verdict(Ui& ui, const edit::Verdict& verdict) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float size = std::floor(40 * ui.scale), line = ImGui::GetTextLineHeight(),
              room = ImGui::GetContentRegionAvail().x;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_medal(list, low, size, std::max(1, verdict.medal), verdict.medal > 0);
  const std::string words = verdict.medal > 0 ? fmt::format("{} medal", medal_title(verdict.medal)) : "Not passed yet";
  const edit::Session& session = ui.session();
  const std::string name = session.game.challenge && session.game.challenge->file.name != session.document.name
                               ? session.game.challenge->file.name
                               : std::string();
  const float x = low.x + size + std::floor(10 * ui.scale),
              y = std::floor(low.y + (size - (name.empty() ? 1 : 2) * line) * 0.5f);
  draw_text(list, {x, y}, verdict.medal > 0 ? palette().good : palette().warning, words);
  const ImVec4 clip(x, low.y, low.x + room, low.y + size);
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {x, y + line}, packed(palette().dim), name.c_str(), nullptr, 0,
               &clip);
  ImGui::Dummy({room, size});
  note(ui, "Verdict", "label", "Verdict of the challenge.", true, words, low, {low.x + room, low.y + size});
}

// The challenge after the present one in the list, or the list itself.
Want next_challenge(const Ui& ui) {
  const std::vector<ChallengeEntry> all = read_challenges(ui);
  const std::filesystem::path name = std::filesystem::path(ui.session().game.challenge->path).filename();
  const auto is_now = [&](const ChallengeEntry& entry) { return entry.path.filename() == name; };
  const auto now = std::find_if(all.begin(), all.end(), is_now);
  const auto next = now == all.end() ? now : std::find_if(now + 1, all.end(), [](const ChallengeEntry& entry) {
    return entry.problem.empty();
  });
  return next == all.end() ? Want{Want::Kind::challenges} : Want{Want::Kind::challenge, next->path.string()};
}

void buttons(Ui& ui, const edit::Session& session) {
  const auto place = failed_place(session);
  const edit::RideResult& result = *session.game.result;
  const bool passed = result.verdict && result.verdict->medal > 0 && session.game.challenge;
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x, half = (ImGui::GetContentRegionAvail().x - gap) / 2;
  if (button(ui, "Ride again", "Start the ride again.", true, half)) {
    ui.emit(edit::RideStop{});
    ui.emit(edit::RideStart{});
  }
  ImGui::SameLine(0, gap);
  if (passed) {
    if (button(ui, "Next challenge", "Start the next challenge of the list.", true, half)) ui.want = next_challenge(ui);
  } else if (button(
                 ui, "Show where",
                 with_keys(ui.keys, "Go to the place of the failure and select the segment.", "Show where it failed"),
                 place.has_value(), half)) {
    show_place(ui, *place);
  }
  bool& details = ui.inputs.score_details;
  if (button(ui, details ? "Fewer values###Details" : "Details", "Show or hide the other values of the ride.", true,
             half))
    details = !details;
  ImGui::SameLine(0, gap);
  if (button(ui, "Close", with_keys(ui.keys, "Close this card.", "Cancel"), true, half)) ui.emit(edit::CloseCard{});
}

void build(Ui& ui, const edit::Session& session) {
  const edit::RideResult& result = *session.game.result;
  tinted_line(session.document.name.empty() ? "The ride" : session.document.name, palette().accent);
  note_item(ui, "Track", "label", "", true, session.document.name);
  const bool failed = result.end == RideEnd::failed;
  paragraph(ui, "Title", std::string(base::row_of(result.end).label), failed ? palette().error : palette().text);
  if (!result.reason.empty())
    paragraph(ui, "Reason", base::sentence(result.reason), failed ? palette().warning : palette().dim);
  if (result.verdict) {
    verdict(ui, *result.verdict);
    if (!result.verdict->reason.empty() && result.verdict->reason != result.reason)
      paragraph(ui, "Why not", base::sentence(result.verdict->reason), palette().warning);
  }
  ImGui::Separator();
  few_numbers(ui, result);
  if (ui.inputs.score_details) more_numbers(ui, result.ratings);
  if (!result.whole)
    paragraph(
        ui, "Note",
        "The track or the train was changed during the ride. These values are of a whole ride on the current track.",
        palette().dim);
  ImGui::Separator();
  buttons(ui, session);
}

}  // namespace

void draw_score_card(Ui& ui, const view::Viewport& scene) {
  const edit::Session& session = ui.session();
  if (!card_shows(session)) return;
  const float width = std::floor(288 * ui.scale), margin = std::floor(14 * ui.scale);
  if (scene.width < width + 2 * margin || scene.height < 240 * ui.scale) return;
  // Below a lesson, which is at the top.
  const bool low = ui.state.lesson != nullptr;
  const ImVec2 corner(std::floor(scene.x + scene.width - margin),
                      std::floor(low ? scene.y + scene.height - margin : scene.y + margin));
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, scene.height - 2 * margin});
  Card card{
      .id = "##score", .panel = "Score", .at = corner, .pivot = {1, low ? 1.0f : 0.0f}, .width = width, .alpha = 0.92f};
  card.flags &= ~ImGuiWindowFlags_NoScrollbar;
  card.flags |= ImGuiWindowFlags_NoNav;
  build_card(ui, card, [&] { build(ui, session); });
}

}  // namespace coaster::ui
