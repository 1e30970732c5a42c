#include "query/goal.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "query/challenge_rules.h"
#include "query/condition.h"
#include "query/rows.h"

namespace coaster::query {
namespace {

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
