// Pages about the simulated ride of the selected train, else of the first: Forces and Riders.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "edit/commands/commands_operation.h"
#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_shape.h"
#include "sim/study/ratings.h"
#include "ui/lab/page_widgets.h"
#include "ui/lab/ride_plots.h"
#include "ui/tools/show_places.h"
#include "ui/widgets/table.h"
#include "world/layers.h"

namespace coaster::ui {
namespace {

void auto_bank_button(Ui& ui) {
  const LockedWidgets locked(ui, edit::AutoBank::kInfo.name);
  if (button(ui, "Auto-bank", "Bank every knot so that riders feel no lateral g there. One undo step."))
    ui.emit(edit::AutoBank{});
}

void side(Ui& ui, const sim::SimulatedRide& simulated, const sim::Ratings& r, bool within_limits) {
  if (const auto to = combo_of(ui, "Left", ui.lab.force_plots[0], "Quantity of the left plot."))
    ui.lab.force_plots[0] = *to;
  if (const auto to = combo_of(ui, "Right", ui.lab.force_plots[1], "Quantity of the right plot."))
    ui.lab.force_plots[1] = *to;
  choose_seat(ui, simulated.start.cars);
  choose_x_axis(ui);
  auto_bank_button(ui);
  (void)beside_last(ui, base::row_of(world::Layer::limits).label);
  layer_box(ui, world::Layer::limits);
  if (within_limits) small_note("All forces are within limits.");
  read_out(ui, simulated.lap ? "Lap time" : "Ride time", fixed(r.seconds, 2), "s", "Time of the whole simulated ride.");
  read_out(ui, "Top speed", r.top_speed.value, 2, "m/s", "Highest speed of the ride.");
  read_out(ui, "Vertical",
           fmt::format("{} .. {}", digits(ui, r.up_least.value, 2, "g"), digits(ui, r.up_most.value, 2, "g")), "g",
           fmt::format("Smallest and largest felt g, low-passed at {:.3g} Hz, all cars.",
                       edit::force_limits(ui.session()).cutoff));
  read_out(ui, "Lateral", digits(ui, r.side_most.value, 2, "g"), "g", "Largest felt g to either side, low-passed.");
  read_out(ui, "Airtime", fixed(r.airtime, 2), "s", "Time with vertical g below 0.");
  read_out(ui, "Inversions", std::to_string(r.inversions), "", "Number of times that riders are upside down.");
  for (const auto& [label, value] :
       {std::pair{"Excitement", r.excitement}, {"Intensity", r.intensity}, {"Nausea", r.nausea}})
    read_out(ui, label, fixed(value, 2), "", "From g, drops, airtime, near misses, jolts and overloads.");
}

constexpr TableColumn kRedColumns[] = {
    {"Where", "m", 52, "Distance along the track. Click to move the train there."},
    {"Force", "", 54, "Direction of the force."},
    {"Actual###Is", "g", 52, "Low-pass filtered, where the limit is exceeded most."},
    {"Limit###May", "g", 48, "Limit for this duration by the envelope (command envelope). Not a compliance check."}};

// Returns the move in words: "Raise k7 by 0.25 m", "Move k7 by 0.25 m to the left".
std::string move_text(const world::Document& document, const sim::KnotMoveAdvice& advice) {
  const std::string label = world::label_of(document, advice.knot), by = fixed(sim::kAdviceStep, 2) + " m";
  if (advice.direction.y != 0) return fmt::format("{} {} by {}", advice.direction.y > 0 ? "Raise" : "Lower", label, by);
  const glm::vec3 ahead = world::knot(document, advice.knot).tangent;
  const float along = glm::dot(advice.direction, ahead),
              left = glm::dot(advice.direction, glm::cross(glm::vec3(0, 1, 0), ahead));
  const std::string_view way = std::abs(along) > std::abs(left) ? (along > 0 ? "forwards" : "back")
                               : left > 0                       ? "to the left"
                                                                : "to the right";
  return fmt::format("Move {} by {} {}", label, by, way);
}

// Shows the effect of moving one knot, and buttons that show the knot and move it.
void advice_rows(Ui& ui) {
  const std::optional<sim::KnotMoveAdvice>& advice = ui.lab.advice;
  const world::Document& document = ui.session().document;
  if (!advice || !document.entities.find<world::Knot>(advice->knot))
    return small_note("Moving one knot nearby does not help. Try a lower speed or a wider bend.");
  const double less = advice->before > 0 ? 100 * (1 - advice->after / advice->before) : 0;
  const std::string effect = advice->after > 0 ? fmt::format("shrinks by {} %", fixed(less, 0)) : "disappears";
  small_note(in_units(ui, fmt::format("{}: this overload {}.", move_text(document, *advice), effect)));
  if (button(ui, "Show", "Select this knot and point the camera at it.")) show_knot(ui, advice->knot);
  ImGui::SameLine();
  if (button(ui, "Apply", "Move the knot. One undo step. Suggest again for the next move.")) {
    ui.emit(edit::Translate{world::name_of(document, advice->knot), sim::kAdviceStep * advice->direction, false});
    ui.lab.advised = false;
  }
}

// `brief`: shows only the start of each span.
void red_table(Ui& ui, std::span<const sim::Overload> red, float height, bool brief) {
  const edit::Session& session = ui.session();
  if (ui.lab.red_chosen < static_cast<int>(red.size())) {
    if (button(ui, "Suggest a fix###What helps?",
               "Try moves of the knots near the selected overload and report the one that reduces it most.",
               ui.lab.red_chosen >= 0))
      ui.lab.advised = true,
      ui.lab.advice = sim::advise(session.document, edit::chosen_cart(session), edit::force_limits(session),
                                  red[static_cast<std::size_t>(ui.lab.red_chosen)]);
    if (ui.lab.advised) advice_rows(ui);
    height -= (ui.lab.advised ? 3.0f : 1.0f) * ImGui::GetFrameHeightWithSpacing();
  }
  if (!begin_table(ui, "Overloads###Red spans", kRedColumns, height)) return;
  for (std::size_t i = 0; i < red.size(); ++i) {
    const sim::Overload& span = red[i];
    const std::string from = digits(ui, span.from_distance, 1, "m"),
                      worst = digits(ui, sim::signed_g(span.axis, span.worst), 2, "g");
    const Cell cells[] = {{brief ? from : fmt::format("{}..{}", from, digits(ui, span.to_distance, 1, "m"))},
                          {std::string(base::row_of(span.axis).label), kPlainColour, true},
                          {worst, kBadColour},
                          {fixed(sim::signed_g(span.axis, span.allowed), 2)}};
    if (!table_row(ui, fmt::format("Overload {0}###Span {0}", i + 1), cells, ui.lab.red_chosen == static_cast<int>(i),
                   worst, "Click to move the train there."))
      continue;
    ui.lab.red_chosen = static_cast<int>(i);
    ui.lab.advised = false;
    ui.emit(edit::RideSeek{span.from_distance});
  }
  end_table();
}

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

void forces_page(Ui& ui) {
  if (!need_probe(ui)) return;
  const auto plots = RidePlots::make(ui, ui.lab.forces_over_time);
  if (!plots) return small_note("No train: add one in the Track panel.");
  const std::span<const sim::Overload> red = ui.find.overloads();
  PageLayout page(ui, 230);
  side(ui, plots->ride(), ui.find.ratings(), red.empty());
  const float height = page.pictures(), room = ImGui::GetContentRegionAvail().x, gap = std::floor(12 * ui.scale);
  const int parts = room <= 340 * ui.scale ? 1 : red.empty() || room <= 560 * ui.scale ? 2 : 3;
  const float width = std::floor((room - gap * static_cast<float>(parts - 1)) / static_cast<float>(parts));
  const auto left = [&] { plots->plot(ui, ui.lab.force_plots[0], "Left plot", width, height); };
  const auto right = [&] { plots->plot(ui, ui.lab.force_plots[1], "Right plot", width, height); };
  const auto table = [&] {
    ImGui::BeginGroup();
    red_table(ui, red, height, width < 440 * ui.scale);
    ImGui::EndGroup();
  };
  int drawn = 0;  // what does not fit in a row goes to the next one
  const auto place = [&](const auto& part) {
    if (drawn++ % parts > 0) ImGui::SameLine(0, gap);
    part();
  };
  place(left);
  if (parts != 2) place(right);
  if (!red.empty()) place(table);
  if (parts == 2) place(right);  // the table is beside the first plot
}

void riders_page(Ui& ui) {
  if (!need_probe(ui)) return;
  const auto plots = RidePlots::make(ui, ui.lab.forces_over_time);
  if (!plots) return small_note("No train: add one in the Track panel.");
  PageLayout page(ui, 210);
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
