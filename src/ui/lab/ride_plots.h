// Plots of the whole ride for the selected seat, over distance or time, with one cursor: the seat's position on the
// track, shared by the train, the view and all plots.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "sim/study/riders.h"
#include "ui/context/ui.h"
#include "ui/plots/plot.h"

namespace coaster::ui {

// The ride of the selected seat, and its parts that exceed the force limits.
struct SeatStudy {
  sim::SeatCurves curves;
  // Vertical, lateral and longitudinal g; NaN where no car of the seat is overloaded.
  std::array<std::vector<double>, 3> beyond;
  sim::Extreme jerk, roll_rate, roll_acceleration;  // the largest values of the seat's cars
};

class RidePlots {
 public:
  // Returns nothing without a train.
  static std::optional<RidePlots> make(Ui& ui, bool over_time);

  // Draws a plot of a value and registers it as "Panel/label". Dragging in it moves the train; the mouse over it marks
  // the position in the view and in every plot.
  void plot(Ui& ui, sim::RideValue value, std::string_view label, float width, float height) const;
  // Draws several values in one plot: those of `left`, in one unit, use the left axis, those of `right` the right axis.
  void plot_all(Ui& ui, std::span<const sim::RideValue> left, std::span<const sim::RideValue> right,
                std::string_view label) const;
  // Adds the curve of a value over the axis, and its parts beyond the limits.
  void add_curves(sim::RideValue value, std::string label, std::vector<Series>& series) const;
  // Draws a plot over the axis with the cursor, and handles the mouse in it.
  void show(Ui& ui, std::string_view label, Plot& picture, std::string_view tooltip) const;
  // Returns the value at the mouse, or else at the train; "--" without either.
  std::string shown(const Ui& ui, sim::RideValue value) const;
  // Returns the colour of a value's curve.
  static std::uint32_t colour_of(sim::RideValue value);
  const sim::SimulatedRide& ride() const { return *ride_; }
  const SeatStudy& study() const { return *study_; }

 private:
  const std::vector<double>& axis() const { return over_time_ ? study_->curves.time : study_->curves.place; }
  std::optional<double> at_place(double distance) const;
  std::size_t index_at(double x) const;
  double place_at(double x) const;
  std::string shown_at(const Ui& ui, sim::RideValue value, double x) const;
  Series curve(sim::RideValue value, std::string label) const;
  void add_overloads(sim::RideValue value, std::vector<Series>& series) const;

  const sim::SimulatedRide* ride_ = nullptr;
  const SeatStudy* study_ = nullptr;
  bool over_time_ = false;
  double behind_ = 0;                   // m, distance of the seat's car behind the first one
  std::optional<double> train_, mark_;  // on the x axis
};

// Selects the seat, in a train of `cars` cars, and the x axis.
void choose_seat(Ui& ui, int cars);
void choose_x_axis(Ui& ui);

}  // namespace coaster::ui
