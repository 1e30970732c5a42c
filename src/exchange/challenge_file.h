// The format of challenges, JSON (docs/challenges.md): a start track, goals and medals as expressions over queries, and
// hints. Reading checks everything except the expressions, which query/challenge_rules.h parses.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "world/document.h"

namespace coaster::exchange {

inline constexpr std::string_view kChallengeFormat = "coaster-challenge";
inline constexpr int kChallengeVersion = 1;
inline constexpr std::size_t kMaxChallengeRules = 32;  // per list
inline constexpr std::size_t kMaxChallengeHints = 16, kMaxChallengeLocks = 16;
inline constexpr std::size_t kMaxChallengeText = 2000;  // bytes of any text
inline constexpr double kMaxChallengeSeconds = 900;     // time limit of the simulated ride

// lap: when the train completes the lap or reaches the end of an open track. time: after some seconds of riding. build:
// as soon as the track meets the goals; values of the ride are the simulated ride's.
enum class JudgedWhen : std::uint8_t { lap, time, build };
inline constexpr base::NameRow kJudged[] = {{"lap"}, {"time"}, {"build"}};
constexpr std::span<const base::NameRow> rows_of(JudgedWhen) { return kJudged; }

// One rule.
struct ChallengeRule {
  std::string expect;  // "ride.g_side_max <= 1.2", as after `expect` in a script
  std::string text;    // explanation for the player
  friend bool operator==(const ChallengeRule&, const ChallengeRule&) = default;
};

enum class RuleList : std::uint8_t { goals, limits, bronze, silver, gold };
inline constexpr base::NameRow kRuleLists[] = {{"goals"}, {"limits"}, {"bronze"}, {"silver"}, {"gold"}};
constexpr std::span<const base::NameRow> rows_of(RuleList) { return kRuleLists; }

struct ChallengeFile {
  std::string name, teaches;
  JudgedWhen judged = JudgedWhen::lap;
  double seconds = 0;                               // for JudgedWhen::time
  std::array<std::vector<ChallengeRule>, 5> rules;  // by RuleList; goals is not empty
  std::vector<std::string> hints;
  std::vector<std::string> locks;  // words of commands that are refused: "auto_bank"
  std::string track;               // the start track's file as written; empty if the challenge contains the track
  world::Document start;

  const std::vector<ChallengeRule>& list(RuleList which) const { return rules[static_cast<std::size_t>(which)]; }
};

struct LoadedChallenge {
  ChallengeFile challenge;
  std::vector<std::string> warnings;  // one line each: unknown members, and the warnings of the start track
};

// Parses a whole file's text. Reads a start track that is named as a file from `folder`. Errors are Code::bad_file with
// one line as for tracks: "NAME:LINE:COLUMN: error: ..." for broken JSON, "NAME: error: goals[1].expect: expected ...,
// found ..." for everything else.
base::Result<LoadedChallenge> parse_challenge(std::string_view text, std::string_view name,
                                              const std::filesystem::path& folder, base::Files& files);

// Loads a file with the extension ".json".
base::Result<LoadedChallenge> load_challenge(base::Files& files, const std::filesystem::path& path);

// True if a text declares itself a challenge, for files of unknown kind.
bool looks_like_challenge(std::string_view text);

}  // namespace coaster::exchange
