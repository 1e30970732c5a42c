// What a user has reached in challenges, JSON (docs/challenges.md): the best medal of each, and the best values it was
// reached with.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"

namespace coaster::exchange {

inline constexpr std::string_view kProgressFormat = "coaster-progress";
inline constexpr int kProgressVersion = 1;
inline constexpr int kMostMedals = 3;  // 1 bronze, 2 silver, 3 gold
inline constexpr std::size_t kMaxProgressEntries = 10'000, kMaxProgressValues = 64;

// A value that a challenge asks about, the best one that it was ever passed with.
struct BestValue {
  std::string query;  // as in the challenge, with its argument
  double value = 0;
  bool less_is_better = false;
  friend bool operator==(const BestValue&, const BestValue&) = default;
};

struct ChallengeProgress {
  std::string challenge;  // the file's name without folder and ending
  int medal = 0;          // 0..kMostMedals
  std::vector<BestValue> best;
  friend bool operator==(const ChallengeProgress&, const ChallengeProgress&) = default;
};

struct Progress {
  std::vector<ChallengeProgress> challenges;  // no name twice, in the order of first success
  friend bool operator==(const Progress&, const Progress&) = default;
};

// Parses a whole file's text. Code::bad_file with one line as for tracks for what is no such file in every part: half a
// memory is no memory, and the caller sets it aside.
base::Result<Progress> parse_progress(std::string_view text, std::string_view name);
// Ends with a newline; parse_progress() gives the same back.
std::string print_progress(const Progress& progress);

// What is known of a challenge; null when it was never passed.
const ChallengeProgress* find(const Progress& progress, std::string_view challenge);
// Takes another success in: the better medal and the better of each value stay. True when that changed anything.
bool merge(Progress& progress, const ChallengeProgress& success);

}  // namespace coaster::exchange
