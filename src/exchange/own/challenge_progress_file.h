// A user's progress in challenges, JSON (docs/challenges.md): the best medal of each, and the best passing values.
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

// A value that a challenge compares, and the best one that passed it.
struct BestValue {
  std::string query;  // as in the challenge, with its argument
  double value = 0;
  bool less_is_better = false;
  friend bool operator==(const BestValue&, const BestValue&) = default;
};

struct ChallengeProgress {
  std::string challenge;  // the file's name without folder and extension
  int medal = 0;          // 0..kMostMedals
  std::vector<BestValue> best;
  friend bool operator==(const ChallengeProgress&, const ChallengeProgress&) = default;
};

struct PlayerProgress {
  std::vector<ChallengeProgress> challenges;  // unique names, in the order of first success
  friend bool operator==(const PlayerProgress&, const PlayerProgress&) = default;
};

// Parses a whole file's text. Code::bad_file with one line as for tracks if any part is invalid: the caller then
// renames the file.
base::Result<PlayerProgress> parse_progress(std::string_view text, std::string_view name);
// Returns the text; ends with a newline. parse_progress() gives the same progress back.
std::string print_progress(const PlayerProgress& progress);

// Returns the progress in a challenge; null if it was never passed.
const ChallengeProgress* find(const PlayerProgress& progress, std::string_view challenge);
// Merges another success: keeps the better medal and the better of each value. Returns true if anything changed.
bool merge(PlayerProgress& progress, const ChallengeProgress& success);

}  // namespace coaster::exchange
