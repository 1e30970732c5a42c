#include "base/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/text.h"

namespace coaster::base {
namespace {

constexpr double kFoot = 0.3048, kInch = 0.0254, kMilePerHour = 0.44704;  // exact by definition; m, m, m/s

struct UnitRow {
  std::array<ShownUnit, 3> in;  // by Units; the first one is the metric unit itself
};
constexpr UnitRow kRows[] = {
    {{{{"m"}, {"m"}, {"ft", 1 / kFoot}}}},
    {{{{"cm"}, {"cm"}, {"in", 0.01 / kInch, 1}}}},
    {{{{"mm"}, {"mm"}, {"in", 0.001 / kInch, 2}}}},
    {{{{"m/s"}, {"km/h", 3.6}, {"mph", 1 / kMilePerHour}}}},
    {{{{"m/s\u00B2"}, {"m/s\u00B2"}, {"ft/s\u00B2", 1 / kFoot}}}},
    {{{{"m\u00B2"}, {"m\u00B2"}, {"ft\u00B2", 1 / (kFoot * kFoot)}}}},
    {{{{"1/m"}, {"1/m"}, {"1/ft", kFoot, 1}}}},
    {{{{"\u00B0/m"}, {"\u00B0/m"}, {"\u00B0/ft", kFoot, 1}}}},
};

// Units as scripts write them, and as panels do.
constexpr std::pair<std::string_view, std::string_view> kSigns[] = {
    {"deg", "\u00B0"}, {"deg/m", "\u00B0/m"}, {"deg/s", "\u00B0/s"}, {"deg/s^2", "\u00B0/s\u00B2"}, {"m^2", "m\u00B2"}};

bool is_decimal(char c) { return c >= '0' && c <= '9'; }
// True for letters, digits and characters that join them to one word.
bool in_word(char c) {
  return is_decimal(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '/' || c == '^' ||
         static_cast<unsigned char>(c) >= 0x80;
}

// Returns the length of the number at the start of a text, such as 12 or 0.25. 0: none.
std::size_t number_size(std::string_view text) {
  std::size_t size = 0;
  while (size < text.size() && is_decimal(text[size])) ++size;
  if (size == 0 || size + 1 >= text.size() || text[size] != '.' || !is_decimal(text[size + 1])) return size;
  for (++size; size < text.size() && is_decimal(text[size]);) ++size;
  return size;
}

// Returns the metric unit that a text begins with as a whole word, or null.
const UnitRow* unit_at(std::string_view text) {
  for (const UnitRow& row : kRows) {
    const std::string_view name = row.in[0].name;
    if (text.starts_with(name) && (text.size() == name.size() || !in_word(text[name.size()]))) return &row;
  }
  return nullptr;
}

std::string converted(std::string_view number, const ShownUnit& unit) {
  const double shown = unit.factor * parse_double(number).value_or(0);
  const std::size_t point = number.find('.');
  const int decimals = point == std::string_view::npos ? 0 : static_cast<int>(number.size() - point - 1);
  const int leading = shown > 0 ? static_cast<int>(std::floor(std::log10(shown))) : 2;
  std::string text = fmt::format("{:.{}f}", shown, std::max({decimals + unit.more_decimals, 2 - leading, 0}));
  std::size_t whole = text.find('.');
  if (whole == std::string::npos) return text;
  while (text.size() > whole + 1 + static_cast<std::size_t>(decimals) && text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

// Numbers that share a unit: "0 to 20 m", "3..5 m", "-1.5 m".
struct Run {
  std::vector<std::string_view> numbers, before;  // the numbers, and the text before each
  std::size_t size = 0;                           // of all numbers, with the blank before the unit
  const UnitRow* unit = nullptr;                  // null: no metric unit follows
};
Run run_at(std::string_view text) {
  Run run;
  std::size_t from = 0;
  for (std::size_t at = 0;;) {
    const std::size_t size = number_size(text.substr(at));
    if (size == 0) return {};
    run.before.push_back(text.substr(from, at - from));
    run.numbers.push_back(text.substr(at, size));
    from = at = at + size;
    const std::string_view rest = text.substr(at);
    if (rest.starts_with(' ')) run.unit = unit_at(rest.substr(1));
    if (run.unit != nullptr) {
      run.size = at + 1;
      return run;
    }
    bool joined = false;
    for (const std::string_view join : {" to ", "..", " .. ", " and "})
      if (!joined && rest.starts_with(join)) at += join.size(), joined = true;
    if (!joined) return {};
    if (at < text.size() && (text[at] == '-' || text[at] == '+')) ++at;
  }
}

}  // namespace

ShownUnit shown_in(Units units, std::string_view metric) {
  for (const auto& [ascii, sign] : kSigns)
    if (metric == ascii) metric = sign;
  for (const UnitRow& row : kRows)
    if (row.in[0].name == metric) return row.in[static_cast<std::size_t>(units)];
  return {metric};
}

double figure_limit(std::string_view metric) {
  constexpr std::pair<std::string_view, double> kLimits[] = {{"g", 1e3}, {"g/s", 1e5}, {"kN", 1e4}};
  for (const auto& [unit, limit] : kLimits)
    if (unit == metric) return limit;
  return std::numeric_limits<double>::infinity();
}

std::string figure_text(double value, int decimals, std::string_view metric, Units units) {
  if (std::isnan(value)) return "--";
  if (const double limit = figure_limit(metric); std::abs(value) >= limit) {
    std::string text = fmt::format("{:.0f}", std::isinf(limit) ? 1e15 : limit);
    for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, ",");
    return (value < 0 ? "under -" : "over ") + text;
  }
  const ShownUnit unit = shown_in(units, metric);
  std::string text = fmt::format("{:.{}f}", value * unit.factor, decimals + unit.more_decimals);
  return text.find_first_not_of("-0.") == std::string::npos && text[0] == '-' ? text.substr(1) : text;
}

double limited_figure(double value, std::string_view metric) {
  const double limit = figure_limit(metric);
  return std::clamp(value, -limit, limit);
}

double metric_value(double shown, const ShownUnit& unit) {
  if (unit.factor == 1) return shown;
  return parse_double(fmt::format("{:.15g}", shown / unit.factor)).value_or(shown / unit.factor);
}

std::string in_units(std::string_view text, Units units) {
  if (units == Units::m_s) return std::string(text);
  const auto row = static_cast<std::size_t>(units);
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::string_view rest = text.substr(at);
    const bool word_begins = at == 0 || !(in_word(text[at - 1]) || text[at - 1] == '.');
    if (rest.front() == '"') {
      const std::size_t end = rest.find('"', 1);
      const std::size_t size = end == std::string_view::npos ? rest.size() : end + 1;
      result += rest.substr(0, size), at += size;
      continue;
    }
    if (const UnitRow* const alone = rest.front() == '(' ? unit_at(rest.substr(1)) : nullptr;
        alone != nullptr && rest.substr(1 + alone->in[0].name.size()).starts_with(')')) {
      result += fmt::format("({})", alone->in[row].name), at += alone->in[0].name.size() + 2;
      continue;
    }
    if (const Run run = word_begins && is_decimal(rest.front()) ? run_at(rest) : Run{}; run.unit != nullptr) {
      for (std::size_t i = 0; i < run.numbers.size(); ++i) {
        result += run.before[i];
        result += converted(run.numbers[i], run.unit->in[row]);
      }
      result += fmt::format(" {}", run.unit->in[row].name), at += run.size + run.unit->in[0].name.size();
      continue;
    }
    result += rest.front(), ++at;
  }
  return result;
}

}  // namespace coaster::base
