// Errata: claims of the 2012 paper and what holds, in numbers of the current segment.
#include <imgui.h>

#include <cmath>
#include <string>

#include "sim/study/live_errata.h"
#include "ui/context/rows.h"
#include "ui/lab/cache.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widget_parts.h"
#include "world/evaluation.h"

namespace coaster::ui {
namespace {

double number_of(Ui& ui, std::string_view query) {
  const auto value = value_of(ui, query);
  const double* number = value ? std::get_if<double>(&*value) : nullptr;
  return number != nullptr ? std::abs(*number) : 0;
}

// One claim: the paper's words and number, then the right number and why.
void claim_row(Ui& ui, const sim::Erratum& e) {
  const auto number = [](double value, std::string_view unit) {
    return significant(value, 4) + (unit.empty() ? ""
                                                 : " " + std::string(unit == "m^2"   ? "m\u00B2"
                                                                     : unit == "deg" ? "\u00B0"
                                                                                     : unit));
  };
  const std::string wrong = number(e.wrong, e.wrong_unit), right = number(e.right, e.unit);
  ImGui::TableNextRow();
  ImGui::TableSetColumnIndex(0);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::TextWrapped("%s", std::string(e.claim).c_str());
  ImGui::TableSetColumnIndex(1);
  ImGui::PushStyleColor(ImGuiCol_Text, colour(palette().error));
  ImGui::TextUnformatted(wrong.c_str());
  ImGui::PopStyleColor();
  ImGui::TableSetColumnIndex(2);
  ImGui::PushStyleColor(ImGuiCol_Text, colour(palette().good));
  ImGui::TextUnformatted(right.c_str());
  ImGui::PopStyleColor();
  ImGui::TableSetColumnIndex(3);
  ImGui::PushStyleColor(ImGuiCol_Text, colour(palette().dim));
  ImGui::TextWrapped("%s", std::string(e.explanation).c_str());
  ImGui::PopStyleColor();
  ImGui::TableSetColumnIndex(0);
  note(ui, "Erratum " + std::string(e.name), "label", e.explanation, true, wrong + " | " + right, low,
       {low.x + width, low.y + ImGui::GetTextLineHeight()});
}

}  // namespace

void errata_page(Ui& ui) {
  const auto probe = need_probe(ui);
  if (!probe) return;
  const world::Settings& settings = ui.session().settings;
  const double speed = number_of(ui, "ride.speed");
  const auto& rows = ui.lab.errata.get(
      {probe->shape->shape_build, ui.session().derived.last_build, settings.evaluation->steps, speed},
      [&] { return sim::errata(ui.session().derived, probe->segment, speed, settings.evaluation->steps); });
  ImGui::PushFont(small_font());
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(std::floor(6 * ui.scale), std::floor(2 * ui.scale)));
  ImGui::PushStyleColor(ImGuiCol_TableHeaderBg, colour(palette().raised));
  ImGui::PushStyleColor(ImGuiCol_TableRowBgAlt, colour(palette().raised, 0.35f));
  if (ImGui::BeginTable("##errata", 4,
                        ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp |
                            ImGuiTableFlags_PadOuterX)) {
    const std::string segment = "On " + world::to_text(probe->name);
    const std::pair<const char*, float> columns[] = {
        {"The paper says", 2.2f}, {"By the paper", 0.9f}, {"In truth", 0.9f}, {"Why", 3.2f}};
    for (const auto& [title, weight] : columns)
      ImGui::TableSetupColumn(title, ImGuiTableColumnFlags_WidthStretch, weight);
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    for (int i = 0; i < 4; ++i) {
      ImGui::TableSetColumnIndex(i);
      ImGui::TextDisabled(
          "%s", (std::string(columns[i].first) + (i == 2 ? ", on " + world::to_text(probe->name) : "")).c_str());
    }
    for (const sim::Erratum& e : rows) claim_row(ui, e);
    ImGui::EndTable();
  }
  ImGui::PopStyleColor(2);
  ImGui::PopStyleVar();
  ImGui::PopFont();
}

}  // namespace coaster::ui
