#include "exchange/nolimits/nl2_numbers.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace coaster::exchange {
namespace {

constexpr double kTens[]{1, 10, 100, 1e3, 1e4, 1e5, 1e6};

// Returns whether an axis has float numbers only, as far as they can be read from so many decimals.
bool floats(std::span<const sim::FitRow> rows, int axis, double decimal_step) {
  return std::all_of(rows.begin(), rows.end(), [&](const sim::FitRow& row) {
    const double at = row.position[axis];
    return std::abs(at - static_cast<double>(static_cast<float>(at))) <= 0.51 * decimal_step;
  });
}

}  // namespace

void Decimals::add(double number) {
  constexpr double kNoise = 1e-8;  // of numbers that a program has calculated with
  while (count < kMost && std::abs(number * kTens[count] - std::round(number * kTens[count])) > kNoise * kTens[count])
    ++count;
}

double Decimals::step() const { return 1 / kTens[count]; }

sim::RowSteps row_steps(std::span<const sim::FitRow> rows, const Decimals& positions, const Decimals& directions) {
  const auto coarse = [](double step) { return step > 0.99e-4 ? step : 0; };  // finer steps are not felt
  double step = positions.step();
  for (int axis = 0; axis < 3; ++axis)
    if (const double spacing = sim::float_spacing(rows, axis);
        spacing > 2 * positions.step() && floats(rows, axis, positions.step()))
      step = std::max(step, spacing);
  return {coarse(step), coarse(directions.step())};
}

std::string told_steps(const sim::RowSteps& steps) {
  std::string told;
  if (steps.position > 0) told = fmt::format("positions are rounded to steps of {:.3g} m", steps.position);
  if (steps.direction > 0)
    told += fmt::format("{}directions are rounded to steps of {:.3g}", told.empty() ? "" : ", ", steps.direction);
  return told + ": followed only within the steps, because riders would feel them as jolts; export with six decimals";
}

}  // namespace coaster::exchange
