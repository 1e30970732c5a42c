#include "base/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "base/text.h"

namespace coaster::base {
namespace {

constexpr double kFoot = 0.3048, kInch = 0.0254, kMilePerHour = 0.44704;  // exact by definition; m, m, m/s

struct UnitRow {
  std::array<ShownUnit, 3> in;  // by UnitSystem; the first one is the metric unit itself
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

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// True for letters, including those beyond ASCII, which unit names consist of.
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
}

// True for letters, digits and characters that join them to one word.
bool in_word(char c) { return is_digit(c) || is_letter(c) || c == '_' || c == '/' || c == '^'; }

// Returns the length of the number at the start of a text, such as 12 or 0.25. 0: none.
std::size_t number_size(std::string_view text) {
  std::size_t size = 0;
  while (size < text.size() && is_digit(text[size])) ++size;
  if (size == 0 || size + 1 >= text.size() || text[size] != '.' || !is_digit(text[size + 1])) return size;
  for (++size; size < text.size() && is_digit(text[size]);) ++size;
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
struct NumbersOfUnit {
  std::vector<std::string_view> numbers, before;  // the numbers, and the text before each
  std::size_t size = 0;                           // of all numbers, with the blank before the unit
  const UnitRow* unit = nullptr;                  // null: no metric unit follows
};
NumbersOfUnit run_at(std::string_view text) {
  NumbersOfUnit run;
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

constexpr std::array kUnits{Unit{"m", Dimension::length, 1},
                            Unit{"cm", Dimension::length, 0.01},
                            Unit{"mm", Dimension::length, 0.001},
                            Unit{"km", Dimension::length, 1000},
                            Unit{"ft", Dimension::length, kFoot},
                            Unit{"in", Dimension::length, kInch},
                            Unit{"m/s", Dimension::speed, 1},
                            Unit{"km/h", Dimension::speed, 1 / 3.6},
                            Unit{"ft/s", Dimension::speed, kFoot},
                            Unit{"mph", Dimension::speed, kMilePerHour},
                            Unit{"m/s\u00B2", Dimension::acceleration, 1},
                            Unit{"m/s^2", Dimension::acceleration, 1},
                            Unit{"m/s2", Dimension::acceleration, 1},
                            Unit{"ft/s\u00B2", Dimension::acceleration, kFoot},
                            Unit{"ft/s^2", Dimension::acceleration, kFoot},
                            Unit{"g", Dimension::acceleration, 9.80665},
                            Unit{"s", Dimension::time, 1},
                            Unit{"ms", Dimension::time, 0.001},
                            Unit{"min", Dimension::time, 60},
                            Unit{"\u00B0", Dimension::angle, 1},
                            Unit{"deg", Dimension::angle, 1},
                            Unit{"degrees", Dimension::angle, 1},
                            Unit{"rad", Dimension::angle, 180 / kPi},
                            Unit{"\u00B0/m", Dimension::spin, 1},
                            Unit{"deg/m", Dimension::spin, 1},
                            Unit{"\u00B0/ft", Dimension::spin, 1 / kFoot},
                            Unit{"deg/ft", Dimension::spin, 1 / kFoot},
                            Unit{"kg", Dimension::mass, 1},
                            Unit{"t", Dimension::mass, 1000},
                            Unit{"lb", Dimension::mass, 0.45359237}};

constexpr std::array<std::string_view, 7> kDimensions{
    "a length", "a speed", "an acceleration", "a time", "an angle", "an angle by length", "a mass"};

bool is_sign(char c) { return c == '+' || c == '-'; }

const Unit* find_unit(std::string_view name) {
  for (const Unit& unit : kUnits)
    if (unit.name == name) return &unit;
  return nullptr;
}

// Returns the units that a field in `unit` accepts, for messages.
std::string known_units(std::string_view unit) {
  const Unit* const own = find_unit(unit);
  std::vector<std::string> names;
  if (own == nullptr) names.emplace_back(unit);
  else
    for (const Unit& other : kUnits)
      if (other.dimension == own->dimension) names.emplace_back(other.name);
  return alternatives(names);
}

struct QuantityValue {
  double number = 0;
  bool measured = false;  // has a unit, and is in the wanted one
};

// Reads by recursive descent, one function for each level of precedence; keeps the first error.
class QuantityReader {
 public:
  QuantityReader(std::string_view text, std::string_view unit) : rest_(text), unit_(unit) {}

  Result<double> read() {
    const QuantityValue value = sum();
    skip_blanks();
    if (error_.empty() && !rest_.empty()) fail(fmt::format("unexpected {}", quoted_start(next_word())));
    if (!error_.empty()) return Status{Code::usage, error_};
    return value.number;
  }

 private:
  QuantityValue sum() {
    QuantityValue value = product();
    for (char sign = take_one_of("+-"); sign != 0; sign = take_one_of("+-")) {
      const QuantityValue other = product();
      value.number = checked(sign == '+' ? value.number + other.number : value.number - other.number);
      value.measured = value.measured || other.measured;
    }
    return value;
  }

  QuantityValue product() {
    QuantityValue value = signed_value();
    for (char sign = take_one_of("*/"); sign != 0; sign = take_one_of("*/")) {
      const QuantityValue other = signed_value();
      if (sign == '*' && value.measured && other.measured) fail("a product of two units");
      if (sign == '/' && other.measured && !value.measured) fail("a unit below the division line");
      if (sign == '/' && other.number == 0) fail("a division by zero");
      value.number = checked(sign == '*' ? value.number * other.number : value.number / other.number);
      value.measured = sign == '*' ? value.measured || other.measured : value.measured && !other.measured;
    }
    return value;
  }

  QuantityValue signed_value() {
    bool negative = false;
    for (char sign = take_one_of("+-"); sign != 0; sign = take_one_of("+-")) negative ^= sign == '-';
    QuantityValue value = measured(take_one_of("(") != 0 ? bracket() : plain_number());
    if (negative) value.number = -value.number;
    return value;
  }

  QuantityValue bracket() {
    constexpr int kMostNested = 64;
    if (++nested_ > kMostNested) return fail("too many brackets");
    const QuantityValue value = sum();
    --nested_;
    if (take_one_of(")") == 0) return fail("expected a closing bracket");
    return value;
  }

  QuantityValue plain_number() {
    std::size_t size = 0;
    const auto digits = [&] {
      const std::size_t from = size;
      while (size < rest_.size() && is_digit(rest_[size])) ++size;
      return size > from;
    };
    const bool whole = digits();
    const bool point = size < rest_.size() && rest_[size] == '.';
    if (point) ++size;
    const bool part = point && digits();
    if (!whole && !part)
      return fail(rest_.empty() ? "expected a number at the end"
                                : fmt::format("expected a number, found {}", quoted_start(next_word())));
    if (const std::size_t before = size; size < rest_.size() && (rest_[size] == 'e' || rest_[size] == 'E')) {
      ++size;
      if (size < rest_.size() && is_sign(rest_[size])) ++size;
      if (!digits()) size = before;  // no exponent
    }
    const std::string_view word = rest_.substr(0, size);
    const auto number = parse_double(word.back() == '.' ? word.substr(0, size - 1) : word);
    if (!number) return fail(fmt::format("{} is too large or too small", word));
    rest_.remove_prefix(size);
    if (!rest_.empty() && rest_.front() == ',') return fail("a comma; decimals follow a point, as in 7.25");
    return {*number, false};
  }

  // Converts a value followed by a unit.
  QuantityValue measured(QuantityValue value) {
    skip_blanks();
    if (!error_.empty() || rest_.empty() || !is_letter(rest_.front())) return own_sign(value);
    const std::string_view name = unit_name();
    const Unit* const unit = find_unit(name);
    const Unit* const wanted = find_unit(unit_);
    if (value.measured) return fail(fmt::format("a second unit, {}", quoted_start(name)));
    if (name != unit_) {
      if (unit_.empty()) return fail(fmt::format("{}, but the number takes no unit", quoted_start(name)));
      if (!unit) return fail(fmt::format("no unit {}; expected {}", quoted_start(name), known_units(unit_)));
      if (!wanted || unit->dimension != wanted->dimension)
        return fail(fmt::format("{} is {}; expected {}", name, kDimensions[static_cast<std::size_t>(unit->dimension)],
                                known_units(unit_)));
      value.number = checked(value.number * (unit->size / wanted->size));
    }
    rest_.remove_prefix(name.size());
    value.measured = true;
    return value;
  }

  // Accepts a wanted unit that is not a word, such as "%".
  QuantityValue own_sign(QuantityValue value) {
    if (error_.empty() && !unit_.empty() && !is_letter(unit_.front()) && rest_.starts_with(unit_) && !value.measured) {
      rest_.remove_prefix(unit_.size());
      value.measured = true;
    }
    return value;
  }

  // Returns the longest name of a unit here, else the word.
  std::string_view unit_name() const {
    std::size_t longest = 0;
    const auto consider = [&](std::string_view name) {
      const bool ends = rest_.size() <= name.size() || !(is_letter(rest_[name.size()]) || is_digit(rest_[name.size()]));
      if (rest_.starts_with(name) && ends && name.size() > longest) longest = name.size();
    };
    for (const Unit& unit : kUnits) consider(unit.name);
    consider(unit_);
    return longest > 0 ? rest_.substr(0, longest) : next_word();
  }
  // Returns a run of letters, digits and points, or one character.
  std::string_view next_word() const {
    std::size_t size = 0;
    while (size < rest_.size() && (is_letter(rest_[size]) || is_digit(rest_[size]) || rest_[size] == '.')) ++size;
    return rest_.substr(0, std::max<std::size_t>(size, 1));
  }

  char take_one_of(std::string_view wanted) {
    skip_blanks();
    if (!error_.empty() || rest_.empty() || wanted.find(rest_.front()) == std::string_view::npos) return 0;
    const char taken = rest_.front();
    rest_.remove_prefix(1);
    skip_blanks();
    return taken;
  }
  void skip_blanks() {
    while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\t')) rest_.remove_prefix(1);
  }
  double checked(double number) {
    if (!std::isfinite(number)) fail("the result is too large");
    return number;
  }
  QuantityValue fail(std::string reason) {
    if (error_.empty()) error_ = std::move(reason);
    return {};
  }

  std::string_view rest_, unit_;
  std::string error_;
  int nested_ = 0;
};

}  // namespace

ShownUnit shown_in(UnitSystem units, std::string_view metric) {
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

std::string figure_text(double value, int decimals, std::string_view metric, UnitSystem units) {
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

std::string in_units(std::string_view text, UnitSystem units) {
  if (units == UnitSystem::m_s) return std::string(text);
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
    if (const NumbersOfUnit run = word_begins && is_digit(rest.front()) ? run_at(rest) : NumbersOfUnit{};
        run.unit != nullptr) {
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

std::span<const Unit> units() { return kUnits; }
Result<double> evaluate(std::string_view text, std::string_view unit) { return QuantityReader(text, unit).read(); }

}  // namespace coaster::base
