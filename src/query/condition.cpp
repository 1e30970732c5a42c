// Conditions of expect and wait, and of challenges.
#include "query/condition.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/enum_names.h"
#include "query/challenge_rules.h"
#include "query/rows.h"

namespace coaster::query {
namespace {

using base::lower;
using base::WordReader;

using base::parse_switch, base::quoted_start;

struct OpName {
  std::string_view text;
  ComparisonOperator op;
};
constexpr std::array<OpName, 8> kOps{{{"==", ComparisonOperator::equal},
                                      {"=", ComparisonOperator::equal},
                                      {"!=", ComparisonOperator::not_equal},
                                      {"<", ComparisonOperator::less},
                                      {"<=", ComparisonOperator::less_equal},
                                      {">", ComparisonOperator::greater},
                                      {">=", ComparisonOperator::greater_equal},
                                      {"~", ComparisonOperator::contains}}};

std::optional<ComparisonOperator> op_of(const base::Token& word) {
  if (word.quoted) return std::nullopt;
  for (const OpName& row : kOps)
    if (row.text == word.text) return row.op;
  return std::nullopt;
}

// Operators of other languages, and what a condition says in their place.
struct ForeignOperator {
  std::string_view text, here;
};
constexpr ForeignOperator kOtherOps[]{
    {"is", "=="},  {"equals", "=="},  {"eq", "=="}, {"===", "=="},     {"ne", "!="},    {"<>", "!="},
    {"!==", "!="}, {"gt", ">"},       {"ge", ">="}, {"=>", ">="},      {"lt", "<"},     {"le", "<="},
    {"=<", "<="},  {"contains", "~"}, {"has", "~"}, {"includes", "~"}, {"matches", "~"}};

// Returns what the message about an unknown operator ends with; a value alone lacks one.
std::string near_op(const base::Token& word, bool last) {
  for (const ForeignOperator& row : kOtherOps)
    if (row.text == lower(word.text)) return fmt::format("; did you mean \"{}\"?", row.here);
  return last && !word.quoted ? fmt::format("; did you mean {}?", quoted_start("== " + word.text)) : "";
}

constexpr std::string_view kNone = "none";  // a number or word that is not there

constexpr std::array<std::string_view, 3> kToleranceMarks{"+-", "+/-", "\u00b1"};

// Returns the rest of a word that starts a tolerance: "" for "+-" alone; nothing for other words.
std::optional<std::string> tolerance_in(const base::Token& word) {
  if (word.quoted) return std::nullopt;
  for (const std::string_view mark : kToleranceMarks)
    if (word.text.starts_with(mark)) return word.text.substr(mark.size());
  return std::nullopt;
}

bool parse_tolerance(WordReader& words, Condition& condition) {
  const base::Token* const word = words.take("a tolerance");
  const std::string attached = *tolerance_in(*word);
  if (attached.empty()) {
    condition.tolerance = words.number("a tolerance");
  } else {
    condition.tolerance = base::parse_double(attached);
    if (!condition.tolerance)
      return words.fail(word->column, "expected a tolerance such as +-0.01, found " + quoted_start(word->text));
  }
  if (condition.tolerance && !(*condition.tolerance >= 0))
    return words.fail(word->column, "expected a tolerance of 0 or more");
  return condition.tolerance.has_value();
}

std::string joined(const std::vector<base::Token>& values) {
  std::string text;
  for (const base::Token& value : values) text += (text.empty() ? "" : " ") + value.text;
  return text;
}

std::string as_written(const base::Token& word) { return word.quoted ? base::quoted(word.text) : word.text; }

base::Status mismatch(std::string message) { return {base::Code::usage, std::move(message)}; }

// Compares by the sign of (found - wanted); equal within the tolerance.
bool ordered(ComparisonOperator op, double found, double wanted, double tolerance, bool exact) {
  const bool same =
      std::abs(found - wanted) <= tolerance || (!exact && static_cast<float>(found) == static_cast<float>(wanted));
  switch (op) {
    case ComparisonOperator::equal: return same;
    case ComparisonOperator::not_equal: return !same;
    case ComparisonOperator::less: return found < wanted && !(exact && same && tolerance > 0);
    case ComparisonOperator::less_equal: return found <= wanted || same;
    case ComparisonOperator::greater: return found > wanted;
    case ComparisonOperator::greater_equal: return found >= wanted || same;
    case ComparisonOperator::contains: return same;
  }
  return false;
}

bool whole(double value) { return std::floor(value) == value && std::abs(value) < 9e15; }

std::optional<double> number_of(std::string_view text) {
  if (const auto on = parse_switch(text)) return *on ? 1 : 0;
  if (text.starts_with('+')) text.remove_prefix(1);
  return base::parse_double(text);
}

base::Result<bool> meets(const Condition& c, double found) {
  const std::string wanted_text = joined(c.values);
  if (*c.op == ComparisonOperator::contains && !c.tolerance)
    return lower(base::to_text(found)).find(lower(wanted_text)) != std::string::npos;
  if (wanted_text == kNone) return *c.op == ComparisonOperator::not_equal;
  const auto wanted = number_of(wanted_text);
  if (!wanted) return mismatch("expected a number, found " + quoted_start(wanted_text));
  return ordered(*c.op, found, *wanted, c.tolerance.value_or(0), whole(found) && whole(*wanted));
}

// With a tolerance, texts compare by the numbers that they begin with.
base::Result<bool> meets(const Condition& c, const std::string& found) {
  if (c.tolerance) {
    if (const auto number = leading_number(found)) return meets(c, *number);
    return mismatch("expected a text that begins with a number, found " + quoted_start(found));
  }
  const std::string wanted = joined(c.values);
  if (*c.op == ComparisonOperator::contains) return lower(found).find(lower(wanted)) != std::string::npos;
  const auto bare = [](std::string_view t) { return t.starts_with('@') ? t.substr(1) : t; };
  const auto found_switch = parse_switch(found), wanted_switch = parse_switch(wanted);
  const bool same = bare(found) == bare(wanted) || (found_switch && found_switch == wanted_switch);
  return *c.op == ComparisonOperator::equal ? same : *c.op == ComparisonOperator::not_equal && !same;
}

bool meets(const Condition& c, const Ranked& found) {
  const std::string wanted = joined(c.values);
  if (*c.op == ComparisonOperator::contains) return lower(found.text).find(lower(wanted)) != std::string::npos;
  const std::optional<int> rank = rank_of(*find_query(c.query), wanted);
  return rank ? ordered(*c.op, found.rank, *rank, 0, true) : *c.op == ComparisonOperator::not_equal;  // none is no rank
}

bool meets(const Condition&, const NoValue&) { return false; }

bool meets(const Condition& c, glm::dvec3 found) {
  bool same = c.values.size() == 3;
  for (int axis = 0; same && axis < 3; ++axis) {
    const auto wanted = number_of(c.values[static_cast<std::size_t>(axis)].text);
    same = wanted && ordered(ComparisonOperator::equal, found[axis], *wanted, c.tolerance.value_or(0),
                             whole(found[axis]) && whole(*wanted));
  }
  return (*c.op == ComparisonOperator::not_equal) != same;
}

bool check_numbers(WordReader& words, const Query& query, const Condition& c, std::size_t count) {
  const std::string unit = query.unit.empty() ? "" : fmt::format(" ({})", query.unit);
  if (c.values.size() != count)
    return words.fail(c.values.front().column,
                      fmt::format("expected {}{}, found {}", count == 1 ? "one number" : "three numbers", unit,
                                  quoted_start(joined(c.values))));
  for (const base::Token& value : c.values)
    if (!number_of(value.text))
      return words.fail(value.column,
                        fmt::format("expected a number{}, found {}", unit, base::quoted_number(value.text)));
  return true;
}

// Checks that the query can have these values and that the operator can compare them.
bool check_values(WordReader& words, const Query& query, const Condition& c, const base::Token& op, bool tolerance) {
  const auto [type, names] = values_with(query, c.argument);
  if (tolerance && (type == ValueType::ranked || !names.empty() || joined(c.values) == kNone))
    return words.fail(c.values.front().column, "a tolerance needs a number, found " + quoted_start(joined(c.values)));
  if (tolerance && type == ValueType::text) return check_numbers(words, query, c, 1);
  if (c.op == ComparisonOperator::contains) return true;
  const bool equality = c.op == ComparisonOperator::equal || c.op == ComparisonOperator::not_equal;
  if (!equality && (type == ValueType::text || type == ValueType::vector))
    return words.fail(
        op.column,
        fmt::format("a {} can be compared only with {}, found {}", type == ValueType::text ? "text" : "vector",
                    type == ValueType::text ? "==, != and ~" : "== and !=", quoted_start(op.text)));
  const std::string all = joined(c.values);
  if (all == kNone && !equality && type == ValueType::number)
    return words.fail(op.column,
                      fmt::format("none can be compared only with == and !=, found {}", quoted_start(op.text)));
  if (all == kNone && (type != ValueType::ranked || !query.argument.empty())) return true;
  if (type == ValueType::number || type == ValueType::vector)
    return check_numbers(words, query, c, type == ValueType::number ? 1 : 3);
  if (names.empty()) return true;
  if (type == ValueType::ranked ? rank_of(query, all).has_value()
                                : std::find(names.begin(), names.end(), all) != names.end())
    return true;
  return words.fail(c.values.front().column, fmt::format("expected {}, found {}{}", base::alternatives(names),
                                                         quoted_start(all), base::suggestion(all, names)));
}

// Returns what the message about an unknown query ends with: the one that was probably meant, else one with the same
// last part (speed: ride.speed), else where all are listed.
std::string near_query(std::string_view name) {
  const std::vector<std::string> known = base::names_in(queries());
  if (std::string near = base::suggestion(name, known); !near.empty()) return near;
  const std::string end = fmt::format(".{}", name);
  const auto found = std::find_if(known.begin(), known.end(), [&](const std::string& k) { return k.ends_with(end); });
  return found != known.end() ? base::suggestion(*found, known) : "; coaster --help-script lists all";
}

bool is_true(const Value& value) {
  if (const double* const number = std::get_if<double>(&value)) return *number != 0;
  if (const Ranked* const ranked = std::get_if<Ranked>(&value)) return ranked->rank != 0;
  if (const std::string* const text = std::get_if<std::string>(&value))
    return parse_switch(*text).value_or(!text->empty());
  return true;
}

// --- Goals of searches: a query of track and ride, and the value that it should have

constexpr std::array kGoals{GoalRow{"ride.lap_time", "Lap time", 2},
                            GoalRow{"ride.speed_max", "Top speed", 1},
                            GoalRow{"ride.g_up_max", "Most vertical g", 2},
                            GoalRow{"ride.g_up_min", "Least vertical g", 2},
                            GoalRow{"ride.g_side_max", "Most lateral g", 2},
                            GoalRow{"ride.airtime", "Airtime", 2},
                            GoalRow{"ride.excitement", "Excitement", 2},
                            GoalRow{"exact_length", "Length of the track", 1},
                            GoalRow{"ride.height_max", "Largest height", 1},
                            GoalRow{"ride.drop_max", "Highest drop", 1},
                            GoalRow{"open_end.distance", "Open end to start", 1}};

// Returns "Lap time"; for a query that is not in goals(), its name and argument.
std::string name_of(const Query& query, std::string_view argument) {
  for (const GoalRow& row : kGoals)
    if (row.query == query.name) return std::string(row.label);
  return fmt::format("{}{}{}", query.name, argument.empty() ? "" : " ", argument);
}

bool may_be_sought(const Query& query) {
  return may_judge(query) || has_row(rider_rows(), query.name) || has_row(section_rows(), query.name);
}

struct ParsedGoal {
  const Query* query = nullptr;
  std::string argument;
  ComparisonOperator op{};
  double wanted = 0, tolerance = 0;
};

std::optional<ParsedGoal> parse_goal(base::WordReader& words) {
  Condition condition;
  if (!parse_condition(words, condition) || !words.end()) return std::nullopt;
  const auto fail = [&](int column, std::string_view message) {
    words.fail(column, std::string(message));
    return std::nullopt;
  };
  const Query* const query = find_query(condition.query);
  const bool numeric = values_with(*query, condition.argument).type == ValueType::number;
  if (!may_be_sought(*query) || !numeric)
    return fail(condition.column, base::quoted_start(condition.query) +
                                      " cannot be sought: expected a query of track or ride with a number");
  const bool compares =
      condition.op && *condition.op != ComparisonOperator::not_equal && *condition.op != ComparisonOperator::contains;
  if (!compares || condition.negated)
    return fail(condition.column, "expected a goal with == < <= > or >= and a number, such as ride.lap_time == 40");
  const auto number = condition.values.size() == 1 ? base::parse_double(condition.values.front().text) : std::nullopt;
  if (!number)
    return fail(condition.values.front().column,
                "expected one number, found " + base::quoted_start(condition.values.front().text));
  const double usual = 1e-3 * std::max(std::abs(*number), 1.0);
  return ParsedGoal{query, condition.argument, *condition.op, *number,
                    std::max(condition.tolerance.value_or(usual), 1e-9)};
}

base::Result<ParsedGoal> read_goal(const std::string& text) {
  std::vector<base::Token> tokens;
  base::TextError error;
  if (base::tokenise(text, tokens, error)) {
    base::WordReader words(tokens, error);
    if (const auto goal = parse_goal(words)) return *goal;
  }
  return base::Status{base::Code::usage, fmt::format("goal {}: {}", base::quoted_start(text), error.message)};
}

}  // namespace

bool parse_condition(WordReader& words, Condition& condition, std::string_view stop) {
  if (words.accept("not")) condition.negated = true;
  const base::Token* const name = words.take("a query");
  if (!name) return false;
  condition.column = name->column;
  condition.text = name->text;
  const bool hidden = name->text == "hidden", opposite = hidden || name->text == "disabled";
  condition.query = !opposite ? name->text : hidden ? "visible" : "enabled";
  condition.negated = condition.negated != opposite;
  const Query* const query = find_query(condition.query);
  if (!query)
    return words.fail(name->column, fmt::format("no query {}{}", quoted_start(name->text), near_query(name->text)));
  if (!query->argument.empty()) {
    const std::string usage = usage_of(query->argument);
    const base::Token* const argument = words.take(usage);
    if (!argument) return false;
    if (op_of(*argument))
      return words.fail(argument->column, fmt::format("expected {}, found {}", usage, quoted_start(argument->text)));
    if (auto wrong = wrong_argument(query->argument, argument->text)) {
      wrong->column += argument->column + (argument->quoted ? 0 : -1);
      return words.fail(*wrong);
    }
    condition.argument = argument->text;
    condition.text += " " + as_written(*argument);
  }
  const auto stops = [&] {
    return words.at_end() || (!stop.empty() && !words.peek()->quoted && words.peek()->text == stop);
  };
  if (stops()) return true;
  const base::Token* const op = words.peek();
  if (query->values.words == on_off && rank_of(*query, op->text)) {  // "closed off"
    condition.op = ComparisonOperator::equal;
  } else {
    words.take("an operator");
    condition.op = op_of(*op);
    if (!condition.op)
      return words.fail(op->column, fmt::format("expected == != < <= > >= or ~ (contains), found {}{}",
                                                quoted_start(op->text), near_op(*op, stops())));
    condition.text += " " + op->text;
  }
  while (!stops() && !tolerance_in(*words.peek())) {
    const base::Token* const value = words.take("a value");
    condition.text += " " + as_written(*value);
    condition.values.push_back(*value);
  }
  if (condition.values.size() > 1 && !condition.values.back().quoted && condition.values.back().text == query->unit)
    condition.values.pop_back();
  if (condition.values.empty())
    return words.fail(words.at_end() ? words.end_column() : words.peek()->column, "expected a value");
  if (!check_values(words, *query, condition, *op, !stops())) return false;
  if (!stops() && !parse_tolerance(words, condition)) return false;
  if (condition.tolerance) condition.text += " +-" + base::to_text(*condition.tolerance);
  return true;
}

base::Result<bool> holds(const Condition& condition, const Value& value) {
  if (is_none(value)) {
    const bool compares =
        (condition.op == ComparisonOperator::equal || condition.op == ComparisonOperator::not_equal) &&
        joined(condition.values) == kNone;
    return compares && (condition.op == ComparisonOperator::equal) != condition.negated;
  }
  const auto meets_it = [&](const auto& v) -> base::Result<bool> { return meets(condition, v); };
  const base::Result<bool> result = condition.op ? std::visit(meets_it, value) : base::Result<bool>(is_true(value));
  if (!result) return result.status();
  return *result != condition.negated;
}

std::optional<double> leading_number(std::string_view text) {
  std::string_view part = text.substr(0, text.find_first_not_of("0123456789.eE+-"));
  while (!part.empty() && !number_of(part)) part.remove_suffix(1);
  return number_of(part);
}

std::string describe(const Query& query, const Value& value) {
  if (const NoValue* const none = std::get_if<NoValue>(&value))
    return fmt::format("but {} is none{}{}", query.name, none->why.empty() ? "" : ": ", none->why);
  const auto text = std::holds_alternative<std::string>(value) ? quoted_start(to_text(value)) : query.words(value);
  return fmt::format("found {}{}{}", text, query.unit.empty() ? "" : " ", query.unit);
}

std::span<const GoalRow> goals() { return kGoals; }

bool check_goal(base::WordReader& words) { return parse_goal(words).has_value(); }

base::Result<edit::GoalState> measure_goal(edit::Session& session, const std::string& goal) {
  const base::Result<ParsedGoal> read = read_goal(goal);
  if (!read) return read.status();
  const base::Result<Value> value = read->query->evaluate(context_of(session), read->argument);
  if (!value) return value.status();
  const double* const number = std::get_if<double>(&*value);
  if (const NoValue* const none = std::get_if<NoValue>(&*value))
    return base::Status{base::Code::refused,
                        fmt::format("{} is none{}{}", read->query->name, none->why.empty() ? "" : ": ", none->why)};
  if (!number)
    return base::Status{base::Code::refused, fmt::format("{} is {}, not a number", read->query->name, to_text(*value))};
  const bool less = read->op == ComparisonOperator::less || read->op == ComparisonOperator::less_equal;
  const bool equal = read->op == ComparisonOperator::equal;
  edit::GoalState state{*number,
                        read->wanted,
                        read->tolerance,
                        false,
                        name_of(*read->query, read->argument),
                        std::string(read->query->unit)};
  state.met = equal  ? std::abs(*number - read->wanted) <= read->tolerance
              : less ? *number <= read->wanted
                     : *number >= read->wanted;
  if (!equal) state.wanted += (less ? -1 : 1) * read->tolerance, state.tolerance *= 0.99;
  return state;
}

}  // namespace coaster::query
