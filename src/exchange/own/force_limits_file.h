// The format of force limits, JSON (docs/ride.md): accelerations by duration. Data to edit, not a compliance check.
// Reading checks everything; an invalid file never yields an envelope.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "sim/study/force_limits.h"

namespace coaster::exchange {

inline constexpr std::string_view kEnvelopeFormat = "coaster-envelope";
inline constexpr int kEnvelopeVersion = 1;
inline constexpr std::string_view kEnvelopeNote =
    "Limits of acceleration by duration, as third parties read ASTM F2291 and EN 13814. Not a compliance check.";
inline constexpr std::size_t kMaxEnvelopePoints = 1000;  // per curve
inline constexpr double kMaxEnvelopeSeconds = 3600, kMaxEnvelopeG = 100;
inline constexpr double kMinCutoff = 0.1, kMaxCutoff = 25;  // Hz; forces are sampled 60 times a second
inline constexpr double kMaxShortest = 10;                  // s

struct LoadedForceLimits {
  sim::ForceLimitCurves envelope;
  std::string name;                   // as in the file
  std::vector<std::string> warnings;  // one line each: unknown members
};

// Parses a whole file's text. Errors are Code::bad_file with one line "NAME:LINE:COLUMN: error: ..." for broken JSON
// and "NAME: error: down[3].g: expected ..., found ..." for everything else. Rejects a wrong format or newer version,
// missing or duplicate members, numbers beyond the limits above, and durations that do not ascend. A curve without
// points sets no limit.
base::Result<LoadedForceLimits> parse_envelope(std::string_view text, std::string_view name);

// Returns the text of an envelope: one point per line, shortest exact numbers; ends with a newline. parse_envelope()
// gives the same envelope back.
std::string print_envelope(const sim::ForceLimitCurves& envelope, std::string_view name);

// Loads a file with the extension ".json".
base::Result<LoadedForceLimits> load_envelope(base::Files& files, const std::filesystem::path& path);

}  // namespace coaster::exchange
