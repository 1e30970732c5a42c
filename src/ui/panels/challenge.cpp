// Challenge: lesson, goals and limits with their state, medals, hints. The goals also show over the scene.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "edit/commands/commands_ride.h"
#include "edit/session/session.h"
#include "query/challenge_rules.h"
#include "ui/context/query_widgets.h"
#include "ui/panels/panels.h"
#include "ui/tools/show_places.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/theme.h"

namespace coaster::ui {
namespace {

using exchange::RuleList;

// Shows a mark, the rule's text, and its value: on the right if it fits next to the text, else below it.
void rule_row(Ui& ui, const query::ParsedRule& rule, const exchange::ChallengeRule& words) {
  const query::RuleResult finding = query::look_at(ui.find, rule);
  const std::string found = in_units(ui, finding.found), text = in_units(ui, words.text);
  const float line = ImGui::GetTextLineHeight(), mark = std::floor(line * 0.86f),
              indent = std::floor(mark + 8 * ui.scale);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x, value = text_size(found).x, gap = std::floor(10 * ui.scale);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, room - indent);
  const bool beside = size.y < 1.5f * line && indent + size.x + gap + value <= room;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_mark(list, {low.x, std::floor(low.y + (line - mark) * 0.5f)}, mark, finding.holds);
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {low.x + indent, low.y}, packed(palette().text), text.c_str(),
               nullptr, room - indent + 1);
  const float y = beside ? low.y : low.y + size.y;
  draw_text(list, {low.x + room - value, y}, finding.holds ? palette().good : palette().dim, found);
  const float height = beside ? line : size.y + line;
  ImGui::Dummy(sized({room, height}));
  note(ui, words.text, "label", base::sentence(query::explain(rule, finding)), true,
       (finding.holds ? "met " : "not met ") + found, low, {low.x + room, low.y + height});
}

void rules_of(Ui& ui, const std::vector<query::ParsedRule>& rules, std::initializer_list<RuleList> lists) {
  const exchange::ChallengeFile& file = ui.session().game.challenge->file;
  for (const query::ParsedRule& rule : rules)
    if (std::find(lists.begin(), lists.end(), rule.list) != lists.end())
      rule_row(ui, rule, file.list(rule.list)[rule.index]);
}

// Shows the three medals side by side, the earned ones in their metal.
void medals(Ui& ui, const edit::ActiveChallenge& challenge, int best) {
  const float size = std::floor(34 * ui.scale), room = ImGui::GetContentRegionAvail().x, third = std::floor(room / 3);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (int medal = 1; medal <= 3; ++medal) {
    const float left = low.x + third * static_cast<float>(medal - 1);
    const std::string_view name = medal_title(medal);
    draw_medal(list, {std::floor(left + (third - size) * 0.5f), low.y}, size, medal, best >= medal);
    draw_text(list, {left + (third - text_size(name).x) * 0.5f, low.y + size + 2 * ui.scale},
              best >= medal ? palette().text : palette().dim, name);
  }
  const float height = size + ImGui::GetTextLineHeight() + std::floor(4 * ui.scale);
  ImGui::Dummy(sized({room, height}));
  note(ui, "Medals", "label", "Medals earned so far.", true, std::string(medal_title(challenge.medal)), low,
       {low.x + room, low.y + height});
}

void medal_rules(Ui& ui, const std::vector<query::ParsedRule>& rules) {
  for (const auto& [list, title] : {std::pair{RuleList::silver, "Silver also needs###For silver, too"},
                                    std::pair{RuleList::gold, "Gold also needs###For gold, too"}}) {
    if (ui.session().game.challenge->file.list(list).empty()) continue;
    heading(ui, title, "In addition to the rules above.");
    rules_of(ui, rules, {list});
  }
}

void buttons(Ui& ui, const edit::ActiveChallenge& challenge) {
  const edit::Session& session = ui.session();
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x, half = (ImGui::GetContentRegionAvail().x - gap) / 2;
  const bool any = rideable(session);
  const bool by_riding = challenge.file.judged != exchange::JudgedWhen::build;
  if (button(ui, "Ride###Ride it",
             by_riding ? "Start the ride. The challenge is judged at its end."
                       : "Start the ride. This challenge is judged while you build.",
             any, half)) {
    if (session.motion.state != world::RideState::stopped) ui.emit(edit::RideStop{});
    ui.emit(edit::RideStart{});
  }
  ImGui::SameLine(0, gap);
  const int left = static_cast<int>(challenge.file.hints.size()) - challenge.hints;
  if (button(ui, "Hint", left > 0 ? fmt::format("{} left.", left) : "No more hints.", left > 0, half))
    ui.emit(edit::ShowHint{});
  if (button(ui, "Restart###Start over", "Reload the start track.", true, half))
    ui.replace(edit::StartChallenge{challenge.path});
  ImGui::SameLine(0, gap);
  if (button(ui, "Leave", "Leave the challenge. The track stays as it is.", true, half))
    ui.emit(edit::LeaveChallenge{});
}

// Shows the hints so far, and scrolls to a new one: it is far below its button.
void hints(Ui& ui, const edit::ActiveChallenge& challenge) {
  for (int i = 0; i < challenge.hints; ++i)
    paragraph(ui, fmt::format("Hint {}", i + 1), challenge.file.hints[static_cast<std::size_t>(i)], palette().text);
  int* const seen = ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("##hints"), challenge.hints);
  if (*seen < challenge.hints) ImGui::SetScrollHereY(1);
  *seen = challenge.hints;
}

// Of a challenge that is judged as you build, so without a score card: the medal, and the way on.
void passed_row(Ui& ui, const edit::ActiveChallenge& challenge) {
  const float size = std::floor(24 * ui.scale);
  draw_medal(*ImGui::GetWindowDrawList(), ImGui::GetCursorScreenPos(), size, challenge.medal, true);
  ImGui::Dummy(sized({size, size}));
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  tinted_line(fmt::format("{} medal", medal_title(challenge.medal)), palette().good);
  const auto next = challenge_after(challenge);
  if (!next) return;
  ImGui::SameLine();
  if (button(ui, "Next challenge", "Begin the next challenge.")) ui.replace(edit::StartChallenge{next->string()});
}

}  // namespace

bool challenge_shown(const Ui& ui) { return ui.session().game.challenge.has_value(); }

void challenge_panel(Ui& ui) {
  const edit::ActiveChallenge& challenge = *ui.session().game.challenge;
  const base::Result<std::vector<query::ParsedRule>> rules = query::read_rules(challenge.file, challenge.path);
  paragraph(ui, "Name", challenge.file.name, palette().accent);
  buttons(ui, challenge);
  paragraph(ui, "Teaches", challenge.file.teaches, palette().dim);
  if (!rules) return paragraph(ui, "Problem", rules.status().message, palette().error);
  heading(ui,
          challenge.file.judged == exchange::JudgedWhen::build ? "To pass###To pass, build so that"
                                                               : "To pass###To pass, ride so that",
          "Goals and limits. Values of the ride come from a simulation of the whole ride.");
  rules_of(ui, *rules, {RuleList::goals, RuleList::limits, RuleList::bronze});
  if (!challenge.file.locks.empty()) paragraph(ui, "Locked", edit::locked_text(challenge.file.locks), palette().dim);
  medals(ui, challenge, std::max(challenge.medal, known_medal(ui, challenge.path)));
  medal_rules(ui, *rules);
  if (!challenge.last.reason.empty()) {
    paragraph(ui, "Not passed", base::sentence(challenge.last.reason), palette().warning);
    if (challenge.last.place &&
        button(ui, "Show where", with_keys(ui.keys, "Go to the place and select the segment.", "Show where it failed")))
      show_place(ui, *challenge.last.place);
  }
  hints(ui, challenge);
  if (wide_button(ui, "All challenges", "Choose another challenge.")) ui.want = {ScreenRequest::Kind::challenges};
}

void draw_goals(Ui& ui, const view::Viewport& scene) {
  const std::optional<edit::ActiveChallenge>& challenge = ui.session().game.challenge;
  if (!challenge) return;
  const base::Result<std::vector<query::ParsedRule>> rules = query::read_rules(challenge->file, challenge->path);
  const float width = std::floor(280 * ui.scale), margin = std::floor(14 * ui.scale);
  if (!rules || scene.width < 2 * width || scene.height < width) return;
  const bool passed = challenge->medal > 0 && challenge->file.judged == exchange::JudgedWhen::build;
  const Card card{.id = "##goals",
                  .panel = "Goals",
                  .at = {std::floor(scene.x + scene.width - margin), std::floor(scene.y + margin)},
                  .pivot = {1, 0},
                  .width = width,
                  .alpha = 0.82f,
                  .flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoFocusOnAppearing |
                           (passed ? ImGuiWindowFlags_NoNav : ImGuiWindowFlags_NoInputs)};
  build_card(ui, card, [&] {
    tinted(challenge->file.name, palette().accent);
    for (const query::ParsedRule& rule : *rules) {
      const bool medal = rule.list == RuleList::silver || rule.list == RuleList::gold;
      if (rule.list == RuleList::goals || (!medal && !query::look_at(ui.find, rule).holds))
        rule_row(ui, rule, challenge->file.list(rule.list)[rule.index]);
    }
    if (passed) passed_row(ui, *challenge);
  });
}

}  // namespace coaster::ui
