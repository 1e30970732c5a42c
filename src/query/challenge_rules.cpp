// Rules and verdicts.
#include "query/challenge_rules.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/text.h"
#include "base/units.h"
#include "edit/commands/command_list.h"
#include "query/rows.h"

namespace coaster::query {
namespace {

using exchange::RuleList;

std::optional<double> place_of_knot(const edit::Session& session, std::string_view label) {
  const auto name = world::parse_name(label);
  if (!name) return std::nullopt;
  const auto index = world::index_of(session.document.track.knots, world::find(session.document, *name));
  return index && *index < session.derived.starts.size() ? std::optional(session.derived.starts[*index]) : std::nullopt;
}

// Returns the distance along the track where the value of a query is taken.
std::optional<double> place_of(const edit::SessionFindings& find, std::string_view query) {
  struct Row {
    std::string_view query;
    sim::Extreme sim::Ratings::*extreme;
  };
  constexpr std::array kRows{Row{"ride.g_up_max", &sim::Ratings::up_most},
                             Row{"ride.g_up_min", &sim::Ratings::up_least},
                             Row{"ride.g_side_max", &sim::Ratings::side_most},
                             Row{"ride.g_forward_max", &sim::Ratings::forward_most},
                             Row{"ride.g_back_max", &sim::Ratings::back_most},
                             Row{"ride.road_load_max", &sim::Ratings::road_most},
                             Row{"ride.up_stop_load_max", &sim::Ratings::up_stop_most},
                             Row{"ride.side_load_max", &sim::Ratings::side_load_most},
                             Row{"ride.speed_max", &sim::Ratings::top_speed},
                             Row{"ride.jolt_max", &sim::Ratings::jolt_most},
                             Row{"ride.height_max", &sim::Ratings::highest}};
  if (find.ride() == nullptr) return std::nullopt;
  for (const Row& row : kRows)
    if (row.query == query) return (find.ratings().*row.extreme).distance;
  if (query == "ride.envelope") {
    const std::span<const sim::Overload> spans = find.overloads();
    return spans.empty() ? std::nullopt : std::optional(spans.front().from_distance);
  }
  return std::nullopt;
}

// Returns the knot that a rule is about: that of the weakest joint, or the one it names; empty without one.
std::string knot_of(const edit::SessionFindings& find, const ParsedRule& rule) {
  const Query& query = *rule.query;
  if (const bool parametric = query.name == "parametric_min"; parametric || query.name == "geometric_min") {
    const auto weakest =
        find_query(parametric ? "weakest_parametric" : "weakest_geometric")->evaluate(context_of(find), {});
    return weakest ? to_text(*weakest) : "";
  }
  if (query.argument.size() != 1 || query.argument[0].kind != world::EntityKind::knot) return {};
  const std::string& argument = rule.condition.argument;
  return argument.starts_with('@') ? argument.substr(1) : argument;
}

std::string shown(const Query& query, const Value& value) {
  const double* const number = std::get_if<double>(&value);
  if (number == nullptr) return to_text(value);
  const bool whole = *number == std::round(*number) && std::abs(*number) < 1e9 && query.unit.empty();
  return fmt::format("{}{}{}", base::figure_text(*number, whole ? 0 : 2, query.unit), query.unit.empty() ? "" : " ",
                     query.unit);
}

base::Status at_rule(std::string_view path, RuleList list, std::size_t index, int column, const std::string& message) {
  return {base::Code::bad_file,
          fmt::format("{}: error: {}[{}].expect:{}: {}", path, base::name_of(list), index, column, message)};
}

std::optional<bool> less_is_better(const Condition& condition) {
  if (!condition.op || condition.negated) return std::nullopt;
  if (*condition.op == ComparisonOperator::less || *condition.op == ComparisonOperator::less_equal) return true;
  if (*condition.op == ComparisonOperator::greater || *condition.op == ComparisonOperator::greater_equal) return false;
  return std::nullopt;
}

std::string full_name(const ParsedRule& rule) {
  const std::string& argument = rule.condition.argument;
  return fmt::format("{}{}{}", rule.query->name, argument.empty() ? "" : " ", argument);
}

// Returns "at most" for <=, or what "not" makes of it.
std::string_view words_of(ComparisonOperator op, bool negated) {
  struct Row {
    std::string_view plain, negated;
  };
  constexpr std::array<Row, 7> kRows{{{"exactly", "anything but"},
                                      {"anything but", "exactly"},
                                      {"less than", "at least"},
                                      {"at most", "more than"},
                                      {"more than", "at most"},
                                      {"at least", "less than"},
                                      {"text with", "text without"}}};
  const Row& row = kRows[static_cast<std::size_t>(op)];
  return negated ? row.negated : row.plain;
}

// Returns "at most 1.2 g": the values that meet the rule. Empty for a rule that only holds or does not.
std::string needed(const ParsedRule& rule) {
  const Condition& condition = rule.condition;
  if (!condition.op || (condition.values.size() == 1 && base::parse_switch(condition.values[0].text))) return {};
  std::string text(words_of(*condition.op, condition.negated));
  for (const base::Token& value : condition.values) text += " " + value.text;
  if (condition.tolerance) text += " \u00B1 " + base::to_text(*condition.tolerance);
  return rule.query->unit.empty() ? text : fmt::format("{} {}", text, rule.query->unit);
}

// Returns why a rule fails: for an overload, its kind and duration.
std::string reason_of(const edit::SessionFindings& find, const ParsedRule& rule, const RuleResult& finding) {
  const auto overloads = rule.query->name == "ride.envelope" ? find.overloads() : std::span<const sim::Overload>();
  if (!overloads.empty()) {
    const sim::Overload& span = overloads.front();
    return fmt::format("{} {} g at {:.1f} m; the limit for that duration is {:.2f} g", base::row_of(span.axis).label,
                       base::figure_text(sim::signed_g(span.axis, span.worst), 2, "g"), span.from_distance,
                       sim::signed_g(span.axis, span.allowed));
  }
  return explain(rule, finding);
}

// Returns why the ride itself does not count; empty if it does.
std::string unridden(const edit::ActiveChallenge& challenge, const edit::RideResult* result) {
  if (challenge.file.judged == exchange::JudgedWhen::build) return {};
  if (result == nullptr) return "not ridden yet";
  if (result->end == edit::RideEnd::failed) return result->reason;
  if (!result->whole) return "you changed the track or moved the train during the ride: start it again";
  if (challenge.file.judged == exchange::JudgedWhen::time && result->end != edit::RideEnd::time)
    return "the ride ended early: " + result->reason;
  return {};
}

}  // namespace

bool may_judge(const Query& query) {
  if (query.name == "challenge.deviation") return true;
  if (query.values.of_view) return false;
  return std::ranges::any_of(std::array{document_rows(), ride_rows(), simulated_rows(), joint_rows()},
                             [&](std::span<const Query> rows) { return has_row(rows, query.name); });
}

base::Result<std::vector<ParsedRule>> read_rules(const exchange::ChallengeFile& challenge, std::string_view path) {
  std::vector<ParsedRule> rules;
  for (std::size_t list = 0; list < challenge.rules.size(); ++list)
    for (std::size_t i = 0; i < challenge.rules[list].size(); ++i) {
      const auto wrong = [&](int column, const std::string& message) {
        return at_rule(path, static_cast<RuleList>(list), i, column, message);
      };
      std::vector<base::Token> tokens;
      base::TextError error;
      ParsedRule rule{static_cast<RuleList>(list), i, {}, nullptr};
      if (!base::tokenise(challenge.rules[list][i].expect, tokens, error)) return wrong(error.column, error.message);
      base::WordReader words(tokens, error);
      if (!parse_condition(words, rule.condition) || !words.end()) return wrong(error.column, error.message);
      rule.query = find_query(rule.condition.query);
      if (!may_judge(*rule.query))
        return wrong(rule.condition.column, base::quoted_start(rule.condition.query) +
                                                " cannot be used in a rule: expected a query of track or ride");
      rules.push_back(std::move(rule));
    }
  return rules;
}

base::Status check_rules(const exchange::ChallengeFile& challenge, const std::string& path) {
  const base::Result<std::vector<ParsedRule>> rules = read_rules(challenge, path);
  if (!rules) return rules.status();
  for (std::size_t i = 0; i < challenge.locks.size(); ++i)
    if (!edit::is_command_word(challenge.locks[i]))
      return {base::Code::bad_file, fmt::format("{}: error: locks[{}]: there is no command {}", path, i,
                                                base::quoted_start(challenge.locks[i]))};
  return {};
}

RuleResult look_at(const edit::SessionFindings& find, const ParsedRule& rule) {
  RuleResult finding;
  const base::Result<Value> value = rule.query->evaluate(context_of(find), rule.condition.argument);
  if (!value) {
    finding.found = value.status().message;  // a knot that no longer exists
    finding.missing = true;
    return finding;
  }
  const base::Result<bool> held = holds(rule.condition, *value);
  finding.holds = held && *held;
  finding.found = shown(*rule.query, *value);
  if (const NoValue* const none = std::get_if<NoValue>(&*value); none != nullptr && !finding.holds) {
    finding.found = none->why.empty() ? "none" : none->why;
    finding.missing = true;
    return finding;
  }
  if (rule.query->name == "ride.envelope" && !is_none(*value))
    finding.found += finding.found == "1" ? " overload" : " overloads";
  if (const double* const number = std::get_if<double>(&*value)) finding.value = *number;
  finding.place = place_of(find, rule.query->name);
  const std::string knot = knot_of(find, rule);
  if (!finding.place) finding.place = place_of_knot(find.session(), knot);
  if (rule.query->name.starts_with("geometric"))
    if (const auto step = find_query("ride.g_step")->evaluate(context_of(find), "@" + knot); step && !is_none(*step))
      finding.found += fmt::format(" (g-step {:.3f} g)", std::get<double>(*step));
  return finding;
}

std::string explain(const ParsedRule& rule, const RuleResult& finding) {
  if (finding.missing) return finding.found;
  const std::string needs = needed(rule);
  if (needs.empty()) return finding.holds ? "this holds" : "this does not hold";
  return fmt::format("you have {}{}; you need {}", finding.found,
                     finding.place ? fmt::format(" at {:.1f} m", *finding.place) : "", needs);
}

edit::ChallengeVerdict judge(edit::Session& session, const edit::RideResult* result) {
  COASTER_CHECK(session.game.challenge, "judging needs an active challenge");
  const edit::ActiveChallenge& challenge = *session.game.challenge;
  edit::ChallengeVerdict verdict;
  const base::Result<std::vector<ParsedRule>> rules = read_rules(challenge.file, challenge.path);
  if (!rules) {
    verdict.reason = rules.status().message;
    return verdict;
  }
  verdict.reason = unridden(challenge, result);
  if (!verdict.reason.empty() && result != nullptr) verdict.place = result->place;
  bool silver = true, gold = true;
  for (const ParsedRule& rule : *rules) {
    const RuleResult finding = look_at(session, rule);
    const auto better = less_is_better(rule.condition);
    const bool known = std::any_of(verdict.values.begin(), verdict.values.end(),
                                   [&](const exchange::BestValue& v) { return v.query == full_name(rule); });
    if (finding.value && better && !known) verdict.values.push_back({full_name(rule), *finding.value, *better});
    if (finding.holds) continue;
    if (rule.list == RuleList::silver) silver = false;
    if (!must_hold(rule)) {
      gold = false;
    } else if (verdict.reason.empty()) {
      verdict.reason =
          fmt::format("{}: {}", challenge.file.list(rule.list)[rule.index].text, reason_of(session, rule, finding));
      verdict.place = finding.place;
    }
  }
  verdict.medal = !verdict.reason.empty() ? 0 : !silver ? 1 : !gold ? 2 : 3;
  return verdict;
}

edit::ExpressionEvaluator referee() { return {check_rules, judge, measure_goal}; }

std::string_view medal_name(int medal) {
  constexpr std::array<std::string_view, 4> kNames{"", "bronze", "silver", "gold"};
  return kNames[static_cast<std::size_t>(std::clamp(medal, 0, 3))];
}

}  // namespace coaster::query
