#include "ui/lab/ride_plots.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>

#include "edit/commands/commands_operation.h"
#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_shape.h"
#include "edit/commands/set_setting.h"
#include "sim/study/ratings.h"
#include "ui/lab/page_widgets.h"
#include "ui/tools/show_places.h"
#include "ui/widgets/table.h"
#include "world/laboratory_settings.h"
#include "world/layers.h"

namespace coaster::ui {
namespace {

using sim::RideValue;

// The value limited on this axis, and whether a large value exceeds the limit (else a small one).
struct LimitedValue {
  RideValue value;
  bool large;
};
LimitedValue limited_by(sim::ForceAxis axis) {
  switch (axis) {
    case sim::ForceAxis::down: return {RideValue::vertical, true};
    case sim::ForceAxis::lift: return {RideValue::vertical, false};
    case sim::ForceAxis::side: return {RideValue::lateral, true};
    case sim::ForceAxis::forward: return {RideValue::longitudinal, true};
    case sim::ForceAxis::back: return {RideValue::longitudinal, false};
  }
  return {};
}

void mark_overload(const sim::Rider& rider, const sim::Overload& span, bool over_time, SeatStudy& study) {
  const sim::SeatCurves& curves = study.curves;
  const LimitedValue limited = limited_by(span.axis);
  const auto v = static_cast<std::size_t>(limited.value);
  const std::vector<double>& values = limited.large && !curves.most[v].empty() ? curves.most[v] : curves.least[v];
  const auto place_of = [&](double seconds) {
    return rider.place(static_cast<std::size_t>(seconds / (sim::kForceEvery * world::kTick) + 0.5));
  };
  const double from = over_time ? span.from : place_of(span.from), to = over_time ? span.to : place_of(span.to);
  const double lap = !over_time && rider.simulated->closed ? rider.simulated->track_length : 0;
  const std::vector<double>& x = over_time ? curves.time : curves.place;
  for (const double turn : {-lap, 0.0, lap}) {
    const auto begin = std::lower_bound(x.begin(), x.end(), std::min(from, to) + turn);
    for (auto at = begin; at != x.end() && *at <= std::max(from, to) + turn; ++at) {
      const auto i = static_cast<std::size_t>(at - x.begin());
      study.beyond[v][i] = values[i];
    }
  }
}

SeatStudy study_of(const edit::SessionFindings& find, sim::CarRange cars, bool over_time) {
  const std::vector<sim::Rider> riders = find.seat()->cars(cars);
  SeatStudy study{over_time ? sim::curves_by_time(riders) : sim::curves_by_place(riders), {}, {}, {}, {}};
  for (std::vector<double>& one : study.beyond)
    one.assign(study.curves.place.size(), std::numeric_limits<double>::quiet_NaN());
  for (const sim::Overload& span : find.overloads())
    if (span.car >= cars.first && span.car <= cars.last)
      mark_overload(find.seat()->car(span.car), span, over_time, study);
  study.jerk = sim::most_of(riders, RideValue::jerk);
  study.roll_rate = sim::most_of(riders, RideValue::roll_rate);
  study.roll_acceleration = sim::most_of(riders, RideValue::roll_acceleration);
  return study;
}

// Returns the distance along the track under the mouse, in the viewport or in a plot.
std::optional<double> pointed_distance(const Ui& ui) {
  const sim::DerivedTrack& derived = ui.session().derived;
  if (ui.hovered.kind != view::PickKind::curve) return std::nullopt;
  const auto index = world::index_of(derived.order, ui.hovered.entity);
  if (!index) return std::nullopt;
  return derived.starts[*index] + derived.shape_at(*index).arc.distance(ui.hovered.t);
}

view::Pick pick_at(const sim::DerivedTrack& derived, double distance) {
  const sim::TrackPlace place = sim::place_at(derived, distance);
  const sim::SegmentShape& shape = derived.shape_at(place.index);
  const double t = shape.arc.parameter(place.s);
  return {view::PickKind::curve, derived.order[place.index], t, glm::vec3(curve::point(shape.key.cubic, t))};
}

PlotAxis y_axis(RideValue value, std::string_view title) {
  const sim::RideValueRow& row = base::row_of(value);
  return {.title = std::string(title), .unit = std::string(row.unit), .least_span = row.least_span};
}

// --- Pages about the simulated ride of the selected train, else of the first: Forces and Riders

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

constexpr RideValue kPlots[] = {RideValue::vertical, RideValue::lateral,   RideValue::longitudinal,
                                RideValue::jerk,     RideValue::roll_rate, RideValue::roll_acceleration,
                                RideValue::speed,    RideValue::height};

void largest(Ui& ui, std::string_view label, const sim::Extreme& extreme, RideValue value) {
  const sim::RideValueRow& row = base::row_of(value);
  read_out(ui, label, std::abs(extreme.value), 2, row.unit,
           fmt::format("Largest of the ride: car {} at {:.1f} m. {}", extreme.car + 1, extreme.distance, row.help));
}

}  // namespace

// A component of the jerk has the colour of its g.
std::uint32_t RidePlots::colour_of(RideValue value) {
  constexpr std::size_t kRows[sim::kRideValueCount] = {0, 1, 2, 3, 0, 1, 2, 4, 7, 6, 5};
  return row_colour(kRows[static_cast<std::size_t>(value)]);
}

std::optional<RidePlots> RidePlots::make(Ui& ui, bool over_time) {
  const edit::Session& session = ui.session();
  const sim::SimulatedRide* const ride = ui.find.ride();
  if (ride == nullptr) return std::nullopt;
  const world::LabView& lab = *session.settings.lab;
  const sim::CarRange cars = sim::cars_of(lab.seat, lab.seat_car, ride->start.cars);
  RidePlots plots;
  plots.ride_ = ride;
  plots.over_time_ = over_time;
  plots.study_ = &ui.lab.seat.get({ride->serial, session.limits.serial, cars.first, cars.last, plots.over_time_},
                                  [&] { return study_of(ui.find, cars, plots.over_time_); });
  plots.behind_ = cars.middle() * ride->start.spacing;
  if (const world::TrainMotion* const train = session.motion.carts.find(edit::chosen_cart(session)))
    plots.train_ = plots.at_place(train->track_distance - plots.behind_);
  if (const auto distance = pointed_distance(ui)) plots.mark_ = plots.at_place(*distance);
  return plots;
}

// Returns the x of a distance along the track; nothing if the seat does not reach it.
std::optional<double> RidePlots::at_place(double distance) const {
  const std::vector<double>&place = study_->curves.place, &time = study_->curves.time;
  if (place.empty()) return std::nullopt;
  constexpr double kRounding = 1e-6;  // m, so that the start is not one lap later
  distance = place.front() - kRounding +
             sim::within_lap(distance - place.front() + kRounding, ride_->track_length, ride_->closed);
  if (!(distance >= place.front() - kRounding && distance <= *std::max_element(place.begin(), place.end())))
    return std::nullopt;
  if (!over_time_) return distance;
  const auto at = std::find_if(place.begin(), place.end(), [&](double one) { return one >= distance; });
  return time[static_cast<std::size_t>(at - place.begin())];
}

// Returns the index of the first value of the axis that is not before x, or of its last one.
std::size_t RidePlots::index_at(double x) const {
  const auto at = std::lower_bound(axis().begin(), axis().end(), x);
  return std::min(static_cast<std::size_t>(at - axis().begin()), axis().size() - 1);
}

// Returns the seat's position at an x of the axis, m along the track.
double RidePlots::place_at(double x) const { return over_time_ ? study_->curves.place[index_at(x)] : x; }

std::string RidePlots::shown_at(const Ui& ui, RideValue value, double x) const {
  const std::size_t i = index_at(x);
  const auto v = static_cast<std::size_t>(value);
  const std::vector<double>&least = study_->curves.least[v], &most = study_->curves.most[v];
  const int decimals = std::abs(least[i]) < 100 ? 2 : 1;
  const auto words = [&](double one) { return digits(ui, one, decimals, base::row_of(value).unit); };
  return most.empty() ? words(least[i]) : fmt::format("{} .. {}", words(least[i]), words(most[i]));
}

std::string RidePlots::shown(const Ui& ui, RideValue value) const {
  const std::optional<double> x = mark_ ? mark_ : train_;
  return x ? shown_at(ui, value, *x) : "--";
}

Series RidePlots::curve(RideValue value, std::string label) const {
  const auto v = static_cast<std::size_t>(value);
  return {std::move(label), axis(), study_->curves.least[v], colour_of(value),
          SeriesKind::line, 1.8f,   study_->curves.most[v]};
}

void RidePlots::add_overloads(RideValue value, std::vector<Series>& series) const {
  const auto v = static_cast<std::size_t>(value);
  if (v >= study_->beyond.size()) return;
  if (std::ranges::any_of(study_->beyond[v], [](double one) { return std::isfinite(one); }))
    series.push_back({"over the limit", axis(), study_->beyond[v], kBadColour, SeriesKind::line, 3.0f});
}

void RidePlots::add_curves(RideValue value, std::string label, std::vector<Series>& series) const {
  series.push_back(curve(value, std::move(label)));
  add_overloads(value, series);
}

void RidePlots::show(Ui& ui, std::string_view label, Plot& picture, std::string_view tooltip) const {
  std::optional<double> pointed;
  picture.cursor = train_;
  picture.mark = mark_;
  picture.pointed = &pointed;
  picture.drags_point = !train_.has_value();
  picture.empty = "no ride";
  const auto drag = ui::plot(ui, label, picture,
                             fmt::format("{} The whole ride over the current track. Drag to move the train.", tooltip));
  if (pointed) ui.pointed = pick_at(ui.session().derived, place_at(*pointed));
  if (!drag) return;
  const sim::DerivedTrack& derived = ui.session().derived;
  const double to = place_at(drag->x) + behind_;  // beyond an open end where the train's middle is drawn
  ui.emit(edit::RideSeek{derived.closed ? to : std::clamp(to, 0.0, derived.length)});
}

void RidePlots::plot(Ui& ui, RideValue value, std::string_view label, float width, float height) const {
  const sim::RideValueRow& row = base::row_of(value);
  const std::optional<double> at = mark_ ? mark_ : train_;
  const std::string now =
      at ? fmt::format("{} {}", shown_at(ui, value, *at), base::shown_in(ui.units, row.unit).name) : "";
  std::vector<Series> series{curve(value, now)};
  if (value == RideValue::jerk && series.front().high.empty())
    for (const auto& [part, name] : {std::pair{RideValue::jerk_up, "vertical"},
                                     {RideValue::jerk_side, "lateral"},
                                     {RideValue::jerk_forward, "longitudinal"}}) {
      series.push_back(curve(part, name));
      series.back().width = 1.0f;
    }
  add_overloads(value, series);
  Plot picture{.x = {over_time_ ? "time" : "distance", over_time_ ? "s" : "m"},
               .y = y_axis(value, row.label),
               .series = series,
               .width = width,
               .height = height,
               .labels = small_size("-00.00").x};
  show(ui, label, picture, row.help);
  const ImVec2 low = ImGui::GetItemRectMin(), high(ImGui::GetItemRectMax().x, low.y + ImGui::GetTextLineHeight());
  if (at) note(ui, fmt::format("{}/value", label), "label", "", true, now, low, high);
}

void RidePlots::plot_all(Ui& ui, std::span<const RideValue> left, std::span<const RideValue> right,
                         std::string_view label) const {
  std::vector<Series> at_left, at_right;
  for (const RideValue value : left) at_left.push_back(curve(value, ""));
  for (const RideValue value : left) add_overloads(value, at_left);
  for (Series& series : at_left) series.label.clear();
  // The right axis has several units, so its curves are converted to the user's units.
  std::vector<std::vector<double>> in_user_units;
  in_user_units.reserve(right.size());
  std::string units;
  double least_span = 0;
  for (const RideValue value : right) {
    const base::ShownUnit unit = base::shown_in(ui.units, base::row_of(value).unit);
    least_span = std::max(least_span, base::row_of(value).least_span * unit.factor);
    Series series = curve(value, "");
    std::vector<double>& scaled = in_user_units.emplace_back(series.y.begin(), series.y.end());
    for (double& one : scaled) one *= unit.factor;
    series.y = scaled, series.high = {};
    at_right.push_back(series);
    units += fmt::format("{}{}", units.empty() ? "" : ", ", unit.name);
  }
  Plot picture{.x = {.unit = "m"},
               .y = left.empty() ? PlotAxis{} : y_axis(left.front(), ""),
               .series = at_left,
               .right = {.title = units, .least_span = least_span},
               .right_series = at_right,
               .labels = small_size("-0.0").x};
  show(ui, label, picture, "Forces, speed and height along the track.");
}

void choose_seat(Ui& ui, int cars) {
  const world::LabView& lab = *ui.session().settings.lab;
  constexpr int kOwn = static_cast<int>(world::Seat::car);
  std::vector<Choice> choices = choices_of<world::Seat>();
  choices.pop_back();
  for (int car = 1; car <= cars; ++car)
    choices.push_back({fmt::format("Car {}", car), "Riders of this car, counted from the front."});
  const bool own = lab.seat == world::Seat::car;
  const int current = own ? kOwn + std::clamp(lab.seat_car, 1, cars) - 1 : static_cast<int>(lab.seat);
  const auto chosen = combo(ui, "Seat", choices, current, "Seat whose ride the plots show.");
  if (!chosen) return;
  if (*chosen >= kOwn) ui.emit(edit::Set<&world::LabView::seat_car>{*chosen - kOwn + 1});
  ui.emit(edit::Set<&world::LabView::seat>{static_cast<world::Seat>(std::min(*chosen, kOwn))});
}

void choose_x_axis(Ui& ui) {
  choose_side(ui, ui.lab.forces_over_time, {"By distance###Over way", "Plot by distance along the track."},
              {"By time###Over time", "Plot by time since the start."});
}

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
