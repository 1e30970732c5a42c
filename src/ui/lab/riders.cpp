// Riders: g, jerk, roll, speed and height of one seat over the whole ride, one plot below the other with one cursor.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ui/lab/cache.h"
#include "ui/lab/page_parts.h"
#include "ui/lab/ride_plots.h"

namespace coaster::ui {
namespace {

using sim::RideValue;

constexpr RideValue kPlots[] = {RideValue::vertical, RideValue::lateral,   RideValue::longitudinal,
                                RideValue::jerk,     RideValue::roll_rate, RideValue::roll_acceleration,
                                RideValue::speed,    RideValue::height};

void largest(Ui& ui, std::string_view label, const sim::Extreme& extreme, RideValue value) {
  const sim::RideValueRow& row = base::row_of(value);
  read_out(ui, label, std::abs(extreme.value), 2, row.unit,
           fmt::format("Largest of the ride: car {} at {:.1f} m. {}", extreme.car + 1, extreme.distance, row.help));
}

}  // namespace

void riders_page(Ui& ui) {
  if (!need_probe(ui)) return;
  const auto plots = RidePlots::make(ui, ui.lab.forces_over_time);
  if (!plots) return small_note("No train: add one in the Track panel.");
  Page page(ui, 210);
  choose_seat(ui, plots->ride().start.cars);
  choose_x_axis(ui);
  largest(ui, "Most jerk", plots->study().jerk, RideValue::jerk);
  largest(ui, "Most roll rate", plots->study().roll_rate, RideValue::roll_rate);
  largest(ui, "Most roll acc.", plots->study().roll_acceleration, RideValue::roll_acceleration);

  constexpr float kLeastHeight = 170, kLeastWidth = 420;  // design px
  constexpr int kCount = static_cast<int>(std::size(kPlots));
  (void)page.pictures();
  const bool stacked = page.stacked();
  const float gap = std::floor(8 * ui.scale);
  const int columns = page.pictures_width() >= 2 * kLeastWidth * ui.scale ? 2 : 1,
            rows = (kCount + columns - 1) / columns;
  const auto gaps = static_cast<float>(rows - 1) * gap;
  const float fitting = std::floor((ImGui::GetContentRegionAvail().y - gaps) / static_cast<float>(rows));
  const float least = std::floor(kLeastHeight * ui.scale), height = stacked ? least : std::max(least, fitting);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(gap, gap));
  ImGui::BeginChild("##plots", {0, stacked ? sized(static_cast<float>(rows) * height + gaps) : 0}, false,
                    ImGuiWindowFlags_NoNav);
  const float width = std::floor((ImGui::GetContentRegionAvail().x - static_cast<float>(columns - 1) * gap) /
                                 static_cast<float>(columns));
  for (int i = 0; i < kCount; ++i) {
    if (i % columns > 0) ImGui::SameLine(0, gap);
    plots->plot(ui, kPlots[i], fmt::format("{} plot", base::row_of(kPlots[i]).label), width, height);
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

}  // namespace coaster::ui
