// Reads and writes progress as JSON.
#include "exchange/own/challenge_progress_file.h"

#include <algorithm>
#include <limits>

#include "exchange/own/json.h"

namespace coaster::exchange {
namespace {

bool read_value(JsonFieldReader& fields, BestValue& best) {
  std::string better;
  constexpr double kLargest = std::numeric_limits<double>::max();
  if (!fields.text("query", best.query) || !fields.number("value", best.value, -kLargest, kLargest) ||
      !fields.text("better", better))
    return false;
  best.less_is_better = better == "less";
  return best.less_is_better || better == "more" || fields.reject("better", "\"less\" or \"more\"");
}

bool read_entry(JsonFieldReader& fields, PlayerProgress& progress) {
  ChallengeProgress entry;
  std::int64_t medal = 0;
  if (!fields.text("challenge", entry.challenge) || !fields.whole("medal", medal, 0, kMostMedals)) return false;
  entry.medal = static_cast<int>(medal);
  if (entry.challenge.empty() || find(progress, entry.challenge)) return fields.reject("challenge", "a unique name");
  const auto read_best = [&](JsonFieldReader& value, auto) { return read_value(value, entry.best.emplace_back()); };
  if (!fields.each("best", kMaxProgressValues, read_best)) return false;
  progress.challenges.push_back(std::move(entry));
  return true;
}

}  // namespace

base::Result<PlayerProgress> parse_progress(std::string_view text, std::string_view name) {
  return read_object<PlayerProgress>(text, name, [](JsonFieldReader& fields, PlayerProgress& progress) {
    return fields.head(kProgressFormat, kProgressVersion) &&
           fields.each("challenges", kMaxProgressEntries,
                       [&](JsonFieldReader& entry, auto) { return read_entry(entry, progress); });
  });
}

std::string print_progress(const PlayerProgress& progress) {
  Json list = Json::array();
  for (const ChallengeProgress& entry : progress.challenges) {
    Json best = Json::array();
    for (const BestValue& value : entry.best)
      best.push_back(
          {{"query", value.query}, {"value", value.value}, {"better", value.less_is_better ? "less" : "more"}});
    list.push_back({{"challenge", entry.challenge}, {"medal", entry.medal}, {"best", std::move(best)}});
  }
  const Json file{
      {"format", std::string(kProgressFormat)}, {"version", kProgressVersion}, {"challenges", std::move(list)}};
  return json_file(file);
}

const ChallengeProgress* find(const PlayerProgress& progress, std::string_view challenge) {
  const auto found = std::ranges::find(progress.challenges, challenge, &ChallengeProgress::challenge);
  return found == progress.challenges.end() ? nullptr : &*found;
}

bool merge(PlayerProgress& progress, const ChallengeProgress& success) {
  const auto found = std::ranges::find(progress.challenges, success.challenge, &ChallengeProgress::challenge);
  if (found == progress.challenges.end()) {
    progress.challenges.push_back(success);
    return true;
  }
  const ChallengeProgress before = *found;
  found->medal = std::max(found->medal, success.medal);
  for (const BestValue& value : success.best) {
    const auto known = std::ranges::find(found->best, value.query, &BestValue::query);
    if (known == found->best.end()) found->best.push_back(value);
    else if (known->less_is_better != value.less_is_better) *known = value;  // the challenge has been rewritten
    else if (value.less_is_better ? value.value < known->value : value.value > known->value) known->value = value.value;
  }
  return !(before == *found);
}

}  // namespace coaster::exchange
