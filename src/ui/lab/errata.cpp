// Errata: wrong claims of the 2012 paper and the correct statements, with the numbers of the current segment.
#include <imgui.h>

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "sim/study/live_errata.h"
#include "ui/context/rows.h"
#include "ui/lab/cache.h"
#include "ui/widgets/table.h"
#include "ui/widgets/theme.h"
#include "world/evaluation.h"

namespace coaster::ui {
namespace {

// One claim: the paper's words and number, then the correct number and why.
void claim_row(Ui& ui, const sim::Erratum& e) {
  const auto number = [&](double value, std::string_view unit) {
    const base::ShownUnit users = base::shown_in(ui.units, unit);
    return fmt::format("{}{}{}", significant(value * users.factor, 4), unit.empty() ? "" : " ", users.name);
  };
  const std::string wrong = number(e.wrong, e.wrong_unit), right = number(e.right, e.unit);
  ImGui::TableNextRow();
  ImGui::TableSetColumnIndex(0);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const std::string explanation = in_units(ui, e.explanation);
  tinted(in_units(ui, e.claim), palette().text);
  ImGui::TableSetColumnIndex(1);
  tinted_line(wrong, palette().error);
  ImGui::TableSetColumnIndex(2);
  tinted_line(right, palette().good);
  ImGui::TableSetColumnIndex(3);
  tinted(explanation, palette().dim);
  ImGui::TableSetColumnIndex(0);
  note(ui, fmt::format("Erratum {}", e.name), "label", e.explanation, true, fmt::format("{} | {}", wrong, right), low,
       {low.x + width, low.y + ImGui::GetTextLineHeight()});
}

}  // namespace

void errata_page(Ui& ui) {
  const auto probe = need_probe(ui);
  if (!probe) return;
  const world::Settings& settings = ui.session().settings;
  const double speed = std::abs(number_of(ui, "ride.speed").value_or(NAN));
  const auto& rows = ui.lab.errata.get(
      {probe->shape->shape_build, ui.session().derived.last_build, settings.evaluation->steps, speed},
      [&] { return sim::errata(ui.session().derived, probe->segment, speed, settings.evaluation->steps); });
  push_table_style(ui, 2);
  if (ImGui::BeginTable("##errata", 4, kTableFlags)) {
    const std::pair<std::string, float> columns[] = {{"The paper says", 2.1f},
                                                     {"Its value", 0.95f},
                                                     {"Truth on " + world::to_text(probe->name), 1.15f},
                                                     {"Why", 3.0f}};
    for (const auto& [title, weight] : columns)
      ImGui::TableSetupColumn(title.c_str(), ImGuiTableColumnFlags_WidthStretch, weight);
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    for (int i = 0; i < 4; ++i) {
      ImGui::TableSetColumnIndex(i);
      draw_text(*ImGui::GetWindowDrawList(), ImGui::GetCursorScreenPos(), palette().dim,
                shortened(columns[i].first, ImGui::GetContentRegionAvail().x));
      ImGui::Dummy(sized({1, ImGui::GetTextLineHeight()}));
    }
    for (const sim::Erratum& e : rows) claim_row(ui, e);
    ImGui::EndTable();
  }
  pop_table_style();
}

}  // namespace coaster::ui
