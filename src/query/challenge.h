// The referee of challenges: reads their expressions, tells which hold now, and judges. Rules are conditions as scripts
// have them, over the queries that speak of track and ride alone, so that a verdict does not depend on machine, picture
// or panels.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "edit/session/session.h"
#include "query/condition.h"

namespace coaster::query {

// Whether rules may ask it: true for what follows from document, ride and envelope.
bool may_judge(const Query& query);

// One rule, read.
struct Rule {
  exchange::RuleList list{};
  std::size_t index = 0;  // in that list
  Condition condition;
  const Query* query = nullptr;
};

// All rules in the order of exchange::RuleList. Code::bad_file with "PATH: error: goals[1].expect:5: ..." (the column
// counts from 1) for the first that cannot be read or asks what may not be judged.
base::Result<std::vector<Rule>> read_rules(const exchange::ChallengeFile& challenge, std::string_view path);

// The same, and for the first that compares what cannot be compared.
base::Status check_rules(const exchange::ChallengeFile& challenge, const std::string& path);

// A rule against the session as it is.
struct Finding {
  bool holds = false;
  std::string found;            // the value as people read it, with its unit: "1.40 g"
  std::optional<double> value;  // of numbers
  std::optional<double> place;  // m along the track, where the value is taken; nothing where it has no place
};
Finding look_at(const edit::Session& session, const Rule& rule);

// "wanted <= 1.2 g": what the rule's operator asks for.
std::string wanted(const Rule& rule);

// Judges the session's challenge: bronze when the ride was ridden as the challenge asks and all goals, limits and
// bronze's own rules hold; silver and gold when theirs hold as well, gold with silver's. `result`: of the ride that has
// just ended, null for Judged::build.
edit::Verdict judge(const edit::Session& session, const edit::RideResult* result);

// What a session is handed.
edit::Referee referee();

// "silver" ...; "" for 0.
std::string_view medal_name(int medal);

}  // namespace coaster::query
