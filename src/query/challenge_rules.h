// The referee of challenges: parses their expressions, evaluates them, and judges. Rules are conditions as in scripts,
// but only over queries of track and ride, so a verdict does not depend on machine, picture or panels.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "edit/session/session.h"
#include "query/condition.h"

namespace coaster::query {

// True for queries that rules may use: they follow from document, ride and envelope.
bool may_judge(const Query& query);

// One parsed rule.
struct ParsedRule {
  exchange::RuleList list{};
  std::size_t index = 0;  // index in that list
  Condition condition;
  const Query* query = nullptr;
};

// True for rules that every medal needs.
inline bool must_hold(const ParsedRule& rule) {
  return rule.list != exchange::RuleList::silver && rule.list != exchange::RuleList::gold;
}

// Parses all rules in the order of exchange::RuleList. Code::bad_file with "PATH: error: goals[1].expect:5: ..."
// (columns count from 1) for the first rule that cannot be parsed or uses a query that may not judge.
base::Result<std::vector<ParsedRule>> read_rules(const exchange::ChallengeFile& challenge, std::string_view path);

// Checks all rules; also fails for the first rule with operands that cannot be compared.
base::Status check_rules(const exchange::ChallengeFile& challenge, const std::string& path);

// A rule evaluated on the present session.
struct RuleResult {
  bool holds = false;
  bool missing = false;         // there is no value; `found` says why
  std::string found;            // the value as text with its unit: "1.40 g"
  std::optional<double> value;  // of numeric queries
  std::optional<double> place;  // m along the track, where the value is taken; nothing if it has no position
};
RuleResult look_at(const edit::SessionFindings& find, const ParsedRule& rule);

// Returns "you have 1.41 g at 87.3 m; you need at most 1.2 g", or why there is no value.
std::string explain(const ParsedRule& rule, const RuleResult& finding);

// Judges the session's challenge. Bronze: the ride counts and all goals, limits and bronze's own rules hold. Silver and
// gold need their own rules too, gold also silver's. `result`: of the ride that has just ended; null for
// JudgedWhen::build.
edit::ChallengeVerdict judge(edit::Session& session, const edit::RideResult* result);

// Returns the functions that a session needs.
edit::ExpressionEvaluator referee();

// Returns "bronze", "silver" or "gold"; "" for 0.
std::string_view medal_name(int medal);

}  // namespace coaster::query
