// Reads and writes progress as JSON.
#include "exchange/own/progress_file.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "exchange/own/json_fields.h"

namespace coaster::exchange {
namespace {

bool read_values(const Json& list, std::string_view place, ChallengeProgress& to, std::string& error) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    Fields fields(list[i], {place, i}, error);
    BestValue best;
    std::string better;
    constexpr double kLargest = std::numeric_limits<double>::max();
    if (!fields.text("query", best.query) || !fields.number("value", best.value, -kLargest, kLargest) ||
        !fields.text("better", better))
      return false;
    if (better != "less" && better != "more") return fields.reject("better", "\"less\" or \"more\"");
    best.less_is_better = better == "less";
    to.best.push_back(std::move(best));
  }
  return true;
}

bool read_entry(const Json& value, std::size_t index, Progress& progress, std::string& error) {
  Fields fields(value, {"challenges", index}, error);
  ChallengeProgress entry;
  std::int64_t medal = 0;
  if (!fields.text("challenge", entry.challenge) || !fields.whole("medal", medal, 0, kMostMedals)) return false;
  entry.medal = static_cast<int>(medal);
  if (entry.challenge.empty() || find(progress, entry.challenge)) return fields.reject("challenge", "a unique name");
  const Json* const best = fields.list("best", kMaxProgressValues);
  if (!best) return false;
  const std::string place = fmt::format("challenges[{}].best", index);
  if (!read_values(*best, place, entry, error)) return false;
  progress.challenges.push_back(std::move(entry));
  return true;
}

bool read_all(const Json& tree, Progress& progress, std::string& error) {
  Fields fields(tree, {}, error);
  if (!error.empty() || !fields.head(kProgressFormat, kProgressVersion)) return false;
  const Json* const list = fields.list("challenges", kMaxProgressEntries);
  if (!list) return false;
  for (std::size_t i = 0; i < list->size(); ++i)
    if (!read_entry((*list)[i], i, progress, error)) return false;
  return true;
}

}  // namespace

base::Result<Progress> parse_progress(std::string_view text, std::string_view name) {
  const base::Result<Json> tree = read_json(text, name);
  if (!tree) return tree.status();
  Progress progress;
  std::string error;
  if (!read_all(*tree, progress, error)) return bad_file(name, error);
  return progress;
}

std::string print_progress(const Progress& progress) {
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

const ChallengeProgress* find(const Progress& progress, std::string_view challenge) {
  const auto found = std::find_if(progress.challenges.begin(), progress.challenges.end(),
                                  [&](const ChallengeProgress& entry) { return entry.challenge == challenge; });
  return found == progress.challenges.end() ? nullptr : &*found;
}

bool merge(Progress& progress, const ChallengeProgress& success) {
  const auto found = std::find_if(progress.challenges.begin(), progress.challenges.end(),
                                  [&](const ChallengeProgress& entry) { return entry.challenge == success.challenge; });
  if (found == progress.challenges.end()) {
    progress.challenges.push_back(success);
    return true;
  }
  const ChallengeProgress before = *found;
  found->medal = std::max(found->medal, success.medal);
  for (const BestValue& value : success.best) {
    const auto known = std::find_if(found->best.begin(), found->best.end(),
                                    [&](const BestValue& best) { return best.query == value.query; });
    if (known == found->best.end()) found->best.push_back(value);
    else if (known->less_is_better != value.less_is_better) *known = value;  // the challenge has been rewritten
    else if (value.less_is_better ? value.value < known->value : value.value > known->value) known->value = value.value;
  }
  return !(before == *found);
}

}  // namespace coaster::exchange
