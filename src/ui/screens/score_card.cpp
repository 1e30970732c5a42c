#include "ui/screens/hud.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "base/text.h"
#include "base/units.h"
#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_sections.h"
#include "ui/context/query_widgets.h"
#include "ui/tools/show_places.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/theme.h"

namespace coaster::ui {
namespace {

using edit::RideEnd;

// Lays out widgets side by side, as many to a row as fit.
struct CardRow {
  Ui& ui;
  bool first = true;
  void place(float width) {
    const float gap = std::floor(14 * ui.scale), end = ImGui::GetItemRectMax().x + gap + width;
    const float room = ImGui::GetWindowPos().x + ImGui::GetWindowWidth() - ImGui::GetStyle().WindowPadding.x;
    if (!std::exchange(first, false) && end <= room) ImGui::SameLine(0, gap);
  }
  void value(const char* label, const std::string& shown, std::string_view tooltip) {
    const float width = text_size(label).x + std::floor(6 * ui.scale) + text_size(shown).x;
    place(width);
    const ImVec2 low = ImGui::GetCursorScreenPos(), high(low.x + width, low.y + ImGui::GetTextLineHeight());
    ImGui::Dummy(sized({width, high.y - low.y}));
    labelled_value(ui, label, shown, tooltip, low, high);
  }
  bool button(std::string_view label, std::string_view tooltip) {
    place(text_size(shown(label)).x + 2 * ImGui::GetStyle().FramePadding.x);
    return ui::button(ui, label, tooltip);
  }
};

std::string range(double low, double high) {
  return fmt::format("{} .. {} g", base::figure_text(low, 1, "g"), base::figure_text(high, 1, "g"));
}

// The five numbers that players compare.
void values(Ui& ui, const edit::RideResult& result) {
  const sim::Ratings& r = result.ratings;
  CardRow row{ui};
  if (result.end == RideEnd::failed)
    row.value("Time", fixed(result.seconds, 2) + " s", "Time from the start to the failure.");
  else row.value(result.end == RideEnd::lap ? "Lap time" : "Time", fixed(r.seconds, 2) + " s", "Time of the ride.");
  row.value("Top speed", measured(ui, r.top_speed.value, 1, "m/s"), "Highest speed of the ride.");
  row.value("Vertical g", range(r.up_least.value, r.up_most.value),
            "Smallest and largest felt g, low-passed, all cars.");
  row.value("Airtime", fixed(r.airtime, 1) + " s", "Time with vertical g below 0.");
  row.value("Excitement", fixed(r.excitement, 1),
            "From 0 to 10: from g, drops, airtime, near misses, jolts, overloads.");
}

void details(Ui& ui, const edit::RideResult& result) {
  const sim::Ratings& r = result.ratings;
  read_out(ui, "Length", r.length, 1, "m", "Length of the track.");
  read_out(ui, "Highest drop", r.highest_drop, 1, "m", fmt::format("Largest of {} descents of 3 m or more.", r.drops));
  read_out(ui, "Lateral g", digits(ui, r.side_most.value, 2, "g"), "g", "Largest felt g to either side, low-passed.");
  read_out(ui, "Inversions", std::to_string(r.inversions), "", "Number of times that riders are upside down.");
  constexpr std::string_view kTerms = "From g, drops, airtime, near misses, jolts and overloads.";
  read_out(ui, "Intensity", fixed(r.intensity, 1), "", kTerms);
  read_out(ui, "Nausea", fixed(r.nausea, 1), "", kTerms);
  if (!result.whole)
    paragraph(
        ui, "Note",
        "The track or the train was changed during the ride. These values are of a whole ride on the current track.",
        palette().dim);
}

// Shows how the ride ended, and the medal.
void title(Ui& ui, const edit::RideResult& result) {
  const bool failed = result.end == RideEnd::failed;
  std::string words(base::row_of(result.end).label);
  std::uint32_t tint = failed ? palette().error : palette().text;
  if (result.verdict) {
    const int medal = result.verdict->medal;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float size = std::floor(24 * ui.scale);
    draw_medal(*ImGui::GetWindowDrawList(), low, size, std::max(1, medal), medal > 0);
    ImGui::Dummy(sized({size, size}));
    const std::string verdict = medal > 0 ? fmt::format("{} medal", medal_title(medal)) : "Not passed yet";
    note_item(ui, "Verdict", "label", "Verdict of the challenge.", true, verdict);
    ImGui::SameLine();
    words = fmt::format("{}. {}", verdict, words);
    if (!failed) tint = medal > 0 ? palette().good : palette().warning;
  }
  paragraph(ui, "Title", words, tint);
  if (!result.reason.empty())
    paragraph(ui, "Reason", base::sentence(result.reason), failed ? palette().warning : palette().dim);
  if (result.verdict && !result.verdict->reason.empty() && result.verdict->reason != result.reason)
    paragraph(ui, "Why not", base::sentence(result.verdict->reason), palette().warning);
}

// Returns the file of the next challenge in the folder, if the present one is passed.
std::optional<std::filesystem::path> next_challenge(const edit::Session& session) {
  const edit::RideResult& result = *session.game.result;
  if (!session.game.challenge || !result.verdict || result.verdict->medal == 0) return std::nullopt;
  return challenge_after(*session.game.challenge);
}

// Shows the buttons. Returns true if the details show.
bool buttons(Ui& ui, const edit::Session& session) {
  bool* const more = ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("##details"), false);
  CardRow row{ui};
  if (const auto next = next_challenge(session); next && row.button("Next challenge", "Begin the next challenge."))
    ui.replace(edit::StartChallenge{next->string()});
  if (const auto climb = climb_without_lift(session);
      climb && row.button("Add a lift", "Put a lift on the section where the train stopped."))
    ui.emit(edit::EquipSection{{world::name_of(session.document, *climb)}, {world::EquipmentKind::lift}});
  if (row.button("Ride again", "Start the ride again.")) {
    ui.emit(edit::RideStop{});
    ui.emit(edit::RideStart{});
  }
  if (const auto place = failed_place(session);
      place && row.button("Show where", with_keys(ui.keys, "Go to the place of the failure and select the segment.",
                                                  "Show where it failed")))
    show_place(ui, *place);
  if (row.button(*more ? "Fewer details###Details" : "Details", "More values of this ride.")) *more = !*more;
  if (row.button("Close", with_keys(ui.keys, "Close this card.", "Cancel"))) ui.emit(edit::CloseCard{});
  return *more;
}

void build(Ui& ui, const edit::Session& session) {
  const edit::RideResult& result = *session.game.result;
  title(ui, result);
  values(ui, result);
  if (!buttons(ui, session)) return;
  ImGui::Separator();
  details(ui, result);
}

}  // namespace

view::Viewport draw_score_card(Ui& ui, const view::Viewport& scene) {
  const edit::Session& session = ui.session();
  if (!card_shows(session)) return scene;
  const float margin = std::floor(14 * ui.scale);
  const float width = std::min(std::floor(690 * ui.scale), scene.width - 2 * margin);
  if (width < 240 * ui.scale || scene.height < 240 * ui.scale) return scene;
  const ImVec2 foot(std::floor(scene.x + scene.width * 0.5f), std::floor(scene.y + scene.height - margin));
  ImGui::SetNextWindowSizeConstraints({sized(width), 0}, sized({width, scene.height - 2 * margin}));
  Card card{.id = "##score", .panel = "Score", .at = foot, .pivot = {0.5f, 1}, .width = width, .alpha = 0.9f};
  card.flags &= ~ImGuiWindowFlags_NoScrollbar;
  card.flags |= ImGuiWindowFlags_NoNav;
  const float height = build_card(ui, card, [&] { build(ui, session); });
  return {scene.x, scene.y, scene.width, scene.height - margin - height};
}

}  // namespace coaster::ui
