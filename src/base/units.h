// The units in which lengths and speeds are shown and typed. Everything else is metric: documents, files, scripts,
// queries, and the values that panels pass to widgets.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/enum_names.h"
#include "base/status.h"

namespace coaster::base {

enum class UnitSystem : std::uint8_t { m_s, kmh, feet };
inline constexpr NameRow kUnitSystems[] = {{"m_s", "Metres, m/s", "Lengths in metres, speeds in metres per second."},
                                           {"kmh", "Metres, km/h", "Lengths in metres, speeds in km/h."},
                                           {"feet", "Feet, mph", "Lengths in feet, speeds in miles per hour."}};
constexpr std::span<const NameRow> rows_of(UnitSystem) { return kUnitSystems; }

// Converts values of a metric unit to the shown one.
struct ShownUnit {
  std::string_view name;  // null-terminated
  double factor = 1;      // shown = factor * metric
  int more_decimals = 0;  // additional decimals that keep the precision of the metric value
};
// Returns the unit that shows values of a metric one: "m", "mm", "m/s", "1/m" and similar. Units that scripts write in
// ASCII, such as "deg/s^2", get their signs. Other units are unchanged.
ShownUnit shown_in(UnitSystem units, std::string_view metric);

// Returns the limit of a ride's figures in a metric unit: 1,000 g, 100,000 g/s, 10,000 kN; infinity for other units.
// Where a track bends at once, the arithmetic goes beyond it, to infinity; no train passes there.
double figure_limit(std::string_view metric);
// Returns a figure with these decimals, in `units`; "over 1,000", or "under -1,000", at its limit and beyond.
std::string figure_text(double value, int decimals, std::string_view metric, UnitSystem units = UnitSystem::m_s);
// Returns the figure, but at most its limit.
double limited_figure(double value, std::string_view metric);

// Returns the metric value of a shown one, rounded to 15 digits, so that 33 ft is 10.0584 m.
double metric_value(double shown, const ShownUnit& unit);

// Returns a sentence with converted lengths and speeds: "Rolled back 2 m." becomes "Rolled back 6.56 ft.", "0 to 20
// m/s" becomes "0 to 44.7 mph", "Position (m)" becomes "Position (ft)". Keeps the decimals, and at least three digits
// that are not zeros at the end. Text in double quotes is unchanged.
std::string in_units(std::string_view text, UnitSystem units);
enum class Dimension : std::uint8_t { length, speed, acceleration, time, angle, spin, mass };

struct Unit {
  std::string_view name;
  Dimension dimension;
  double size;  // in the dimension's first unit of the table
};
// Returns all units that can be typed. To add one: a row.
std::span<const Unit> units();

// Evaluates numbers with + - * / and brackets, by the usual precedence, from left to right, in double precision. The
// result is in `unit`, a name of the table or any other text ("" for a plain number). A number or bracket may be
// followed by a unit, if it is `unit` itself or has the same dimension; a term without one is in `unit`. Code::usage
// with the reason for everything else: other words, a decimal comma, a unit of another dimension, a product of two
// units, division by zero, results beyond double. The result is finite, never inf or NaN.
Result<double> evaluate(std::string_view text, std::string_view unit = {});

}  // namespace coaster::base
