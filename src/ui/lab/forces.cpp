// Forces: the simulated ride of the selected cart, else of the first: speed, height and g by distance or time,
// overloads, and which knot to move to reduce them.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "edit/commands/commands_operation.h"
#include "edit/commands/commands_ride.h"
#include "sim/study/ratings.h"
#include "ui/lab/cache.h"
#include "ui/lab/table.h"
#include "world/layers.h"

namespace coaster::ui {
namespace {

constexpr const char* kQuantities[] = {"Vertical g", "Lateral g", "Longitudinal g", "Speed", "Height"};
constexpr const char* kUnits[] = {"g", "g", "g", "m/s", "m"};
constexpr sim::ForceAxis kAxesOf[][2] = {{sim::ForceAxis::down, sim::ForceAxis::lift},
                                         {sim::ForceAxis::side, sim::ForceAxis::side},
                                         {sim::ForceAxis::forward, sim::ForceAxis::back}};

// A quantity for the middle car at one of the ghost's forces.
double value_at(const sim::Ghost& ghost, const sim::RailTables& tables, std::size_t entry, int quantity,
                std::size_t& hint) {
  const auto cars = static_cast<std::size_t>(ghost.start.cars);
  const sim::Force& force = ghost.forces[entry * cars + cars / 2];
  const std::size_t sample = entry * sim::kForceEvery;
  switch (quantity) {
    case 0: return force.up;
    case 1: return force.left;
    case 2: return force.forward;
    case 3: return ghost.samples[sample].speed;
    default: {
      const double s = tables.locate(ghost.distance(sample), hint);
      return sim::rail_at(tables.segment(hint), s).height;
    }
  }
}

ForceStudy study_of(const edit::Findings& found) {
  const sim::Ghost& ghost = *found.ride;
  const sim::RailTables& tables = *found.tables;
  ForceStudy study;
  study.ratings = *found.ratings;
  study.red.assign(found.overloads.begin(), found.overloads.end());
  const std::size_t entries = ghost.forces.size() / static_cast<std::size_t>(ghost.start.cars);
  std::size_t hint = 0;
  for (std::size_t k = 0; k < entries; ++k) {
    study.distance.push_back(ghost.samples[k * sim::kForceEvery].travelled);
    study.time.push_back(static_cast<double>(k * sim::kForceEvery) * world::kTick);
  }
  for (int quantity = 0; quantity < kForceQuantities; ++quantity) {
    std::vector<double>&values = study.values[static_cast<std::size_t>(quantity)],
    &beyond = study.beyond[static_cast<std::size_t>(quantity)];
    for (std::size_t k = 0; k < entries; ++k) values.push_back(value_at(ghost, tables, k, quantity, hint));
    beyond.assign(entries, std::numeric_limits<double>::quiet_NaN());
    if (quantity > 2) continue;
    for (const sim::RedSpan& span : study.red) {
      if (span.axis != kAxesOf[quantity][0] && span.axis != kAxesOf[quantity][1]) continue;
      for (std::size_t k = 0; k < entries; ++k)
        if (study.time[k] >= span.from && study.time[k] <= span.to) beyond[k] = values[k];
    }
  }
  return study;
}

// Distance and time (m, s) of that cart in the ghost's ride; nothing if the ghost does not reach it.
struct Cursor {
  double distance = 0, time = 0;
};
std::optional<Cursor> cursor_of(const edit::Session& session, const sim::Ghost& ghost, const ForceStudy& study) {
  const world::CartMotion* const cart = session.motion.carts.find(edit::chosen_cart(session));
  if (!cart || study.distance.empty()) return std::nullopt;
  const double distance = sim::within_lap(cart->track_distance - ghost.start.front, ghost.track_length, ghost.closed);
  const auto at = std::lower_bound(study.distance.begin(), study.distance.end(), distance);
  if (at == study.distance.end()) return std::nullopt;
  return Cursor{distance, study.time[static_cast<std::size_t>(at - study.distance.begin())]};
}

void seek_to(Ui& ui, const sim::Ghost& ghost, const ForceStudy& study, double x) {
  if (ui.lab.forces_over_time) {
    const auto at = std::lower_bound(study.time.begin(), study.time.end(), x);
    if (at == study.time.end()) return;
    x = study.distance[static_cast<std::size_t>(at - study.time.begin())];
  }
  ui.emit(edit::RideSeek{ghost.start.front + x});
}

void force_plot(Ui& ui, const sim::Ghost& ghost, const ForceStudy& study, int quantity, const char* label, float width,
                float height) {
  const bool over_time = ui.lab.forces_over_time;
  const auto which = static_cast<std::size_t>(quantity);
  const std::vector<double>& x = over_time ? study.time : study.distance;
  const Series series[] = {
      {"", x, study.values[which], row_colour(which), SeriesKind::line, 1.8f},
      {quantity <= 2 ? "over the limit" : "", x, study.beyond[which], kBadColour, SeriesKind::line, 3.0f}};
  const auto cursor = cursor_of(ui.session(), ghost, study);
  Plot picture{.x = {over_time ? "time" : "distance", over_time ? "s" : "m"},
               .y = {kQuantities[quantity], kUnits[quantity]},
               .series = series,
               .empty = "no ride",
               .width = width,
               .height = height};
  if (cursor) picture.cursor = over_time ? cursor->time : cursor->distance;
  if (const auto drag = plot(ui, label, picture,
                             "The whole ride over the current track, for riders of the middle car. Drag to move the "
                             "train. Red: overload."))
    seek_to(ui, ghost, study, drag->x);
}

void side(Ui& ui, const sim::Ghost& ghost, const ForceStudy& study) {
  std::vector<Choice> choices;
  for (const char* name : kQuantities) choices.push_back({name, {}});
  if (const auto to = combo(ui, "Left", choices, ui.lab.force_plots[0], "Quantity of the left plot."))
    ui.lab.force_plots[0] = *to;
  if (const auto to = combo(ui, "Right", choices, ui.lab.force_plots[1], "Quantity of the right plot."))
    ui.lab.force_plots[1] = *to;
  choose_side(ui, ui.lab.forces_over_time, {"By distance###Over way", "Plot by distance along the track."},
              {"By time###Over time", "Plot by time since the start."});
  if (button(ui, "Auto-bank", "Bank every knot so that riders feel no lateral g there. One undo step."))
    ui.emit(edit::AutoBank{});
  (void)beside_last(ui, base::row_of(world::Layer::limits).label);
  layer_box(ui, world::Layer::limits);
  if (study.red.empty()) small_note("All forces are within limits.");
  const sim::Ratings& r = study.ratings;
  read_out(ui, ghost.lap ? "Lap time" : "Ride time", fixed(r.seconds, 2), "s", "Time of the whole simulated ride.");
  read_out(ui, "Top speed", fixed(r.top_speed.value, 2), "m/s", "Highest speed of the ride.");
  read_out(ui, "Vertical", fmt::format("{} .. {}", fixed(r.up_least.value, 2), fixed(r.up_most.value, 2)), "g",
           "Smallest and largest, low-pass filtered at 5 Hz, all cars.");
  read_out(ui, "Lateral", fixed(r.side_most.value, 2), "g", "Largest to either side, low-pass filtered.");
  read_out(ui, "Airtime", fixed(r.airtime, 2), "s", "Time with vertical g below 0.");
  read_out(ui, "Inversions", std::to_string(r.inversions), "", "Number of times that riders are upside down.");
  for (const auto& [label, value] :
       {std::pair{"Excitement", r.excitement}, {"Intensity", r.intensity}, {"Nausea", r.nausea}})
    read_out(ui, label, fixed(value, 2), "", "After OpenRCT2's published rating terms, with real g.");
}

constexpr TableColumn kRedColumns[] = {
    {"Where", "m", 1.2f, "Distance along the track. Click to move the train there."},
    {"Force", "", 1.6f, "Direction of the force."},
    {"Actual###Is", "g", 0.8f, "Low-pass filtered, where the limit is exceeded most."},
    {"Limit###May", "g", 0.8f, "Limit for this duration by the envelope (command envelope). Not a compliance check."}};

std::string advice_text(const edit::Session& session, const std::optional<sim::Advice>& advice) {
  if (!advice) return "Moving one nearby knot does not help.";
  for (int axis = 0; axis < 3; ++axis) {
    const float part = advice->direction[axis];
    if (part == 0) continue;
    const double less = advice->before > 0 ? 100 * (1 - advice->after / advice->before) : 0;
    return fmt::format("Move {} by {}{} m in {}: {} % less.", world::label_of(session.document, advice->knot),
                       part > 0 ? "+" : "-", fixed(sim::kAdviceStep, 2), "xyz"[axis], fixed(less, 0));
  }
  return {};
}

// `brief`: shows only where a span begins, and the short name of its force.
void red_table(Ui& ui, const ForceStudy& study, float height, bool brief) {
  const edit::Session& session = ui.session();
  if (ui.lab.red_chosen < static_cast<int>(study.red.size())) {
    if (button(ui, "Suggest a fix###What helps?",
               "Try moves of the knots near the selected overload and report the one that reduces it most.",
               ui.lab.red_chosen >= 0))
      ui.lab.advice =
          advice_text(session, sim::advise(session.document, edit::chosen_cart(session), session.limits.envelope,
                                           study.red[static_cast<std::size_t>(ui.lab.red_chosen)]));
    if (!ui.lab.advice.empty()) small_note(ui.lab.advice);
    height -= 2 * ImGui::GetFrameHeightWithSpacing();
  }
  if (!begin_table(ui, "Red spans", kRedColumns, height)) return;
  for (std::size_t i = 0; i < study.red.size(); ++i) {
    const sim::RedSpan& span = study.red[i];
    const Cell cells[] = {
        {brief ? fixed(span.from_distance, 1)
               : fmt::format("{}..{}", fixed(span.from_distance, 1), fixed(span.to_distance, 1))},
        {std::string(brief ? base::name_of(span.axis) : base::row_of(span.axis).label), kPlainColour, true},
        {fixed(span.worst, 2), kBadColour},
        {fixed(span.allowed, 2)}};
    if (!table_row(ui, fmt::format("Span {}", i + 1), cells, ui.lab.red_chosen == static_cast<int>(i),
                   fixed(span.worst, 2), "Click to move the train there."))
      continue;
    ui.lab.red_chosen = static_cast<int>(i);
    ui.lab.advice.clear();
    ui.emit(edit::RideSeek{span.from_distance});
  }
  end_table();
}

}  // namespace

void forces_page(Ui& ui) {
  if (!need_probe(ui)) return;
  const edit::Session& session = ui.session();
  const sim::Ghost* const ghost = ui.find(edit::Want::ride).ride;
  if (!ghost) return small_note("No cart: add one in the Track panel.");
  const ForceStudy& study = ui.lab.forces.get({ghost->serial, session.limits.serial}, [&] {
    return study_of(ui.find(edit::Want::ratings | edit::Want::overloads));
  });
  Page page(ui, 230);
  side(ui, *ghost, study);
  const float height = page.pictures(), room = ImGui::GetContentRegionAvail().x, gap = std::floor(12 * ui.scale);
  const int parts = room <= 340 * ui.scale ? 1 : study.red.empty() || room <= 560 * ui.scale ? 2 : 3;
  const float width = std::floor((room - gap * static_cast<float>(parts - 1)) / static_cast<float>(parts));
  force_plot(ui, *ghost, study, ui.lab.force_plots[0], "Left plot", width, height);
  if (parts > (study.red.empty() ? 1 : 2)) {  // else the table takes the place of the second plot
    ImGui::SameLine(0, gap);
    force_plot(ui, *ghost, study, ui.lab.force_plots[1], "Right plot", width, height);
  }
  if (study.red.empty()) return;
  if (parts > 1) ImGui::SameLine(0, gap);
  ImGui::BeginGroup();
  red_table(ui, study, height, parts < 3);
  ImGui::EndGroup();
}

}  // namespace coaster::ui
