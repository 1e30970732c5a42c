// The project's own track format, JSON (docs/track-format.md). Reading checks everything; an invalid file never yields
// a document.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "base/status.h"
#include "world/camera.h"
#include "world/document.h"
#include "world/evaluation_settings.h"
#include "world/force_program.h"

namespace coaster::exchange {

inline constexpr std::string_view kTrackFormat = "coaster-track";
// The newest version. 1: without spins, which become automatic. 1 and 2: without sections, so that all is one free
// section. 4: with a coaster's kind or paint, a park, or a section's earthwork.
inline constexpr int kTrackVersion = 4;
// Returns the oldest version that holds the document, in which it is written: 3 or 4.
int version_of(const world::Document& document);

// The errors of a track that was fitted to a file's rows (sim/fit/fit_track.h), measured at every row on the document
// itself.
struct ImportReport {
  double max_error = 0;    // m, the largest distance of a row from the curve
  double frame_error = 0;  // degrees between a row's frame and the track's, except within 0.5 m of jumps of the rows
  int knots = 0;
  double jump_error = 0;  // degrees, as frame_error, for the rows excluded there
  double rms_error = 0;  // m and degrees: root mean squares of the distances and angles that the maxima above belong to
  double rms_frame_error = 0;
  friend bool operator==(const ImportReport&, const ImportReport&) = default;
};

// The view of a shared track (exchange/own/share_link.h).
struct SharedView {
  world::CameraMode mode = world::CameraMode::orbit;
  world::Camera camera;
  world::FlyCamera fly;
  curve::EvaluatorId evaluator = curve::kDefaultEvaluator;
  int steps = 64;  // per segment
  friend bool operator==(const SharedView&, const SharedView&) = default;
};

struct LoadedTrack {
  world::Document document;
  std::vector<std::string> warnings;   // one line each: unknown members, which are kept; rows that were left out
  std::string note;                    // a line for the user: the start speed of an import
  bool knows_speed = false;            // the file gives the start speed
  bool reshaped = false;               // earlier versions gave another curve; load_track() notes it
  std::optional<ImportReport> import;  // for formats that a track is fitted to
  std::uint64_t content = 0;           // hash of the file's bytes; set by load_track()
  int version = kTrackVersion;         // of the project's own format
  std::optional<SharedView> view;      // for links
};

// Parses a whole file's text. Errors are Code::bad_file with one line "NAME:LINE:COLUMN: error: ..." for broken JSON
// and "NAME: error: knots[3].tangent: expected ..., found ..." for everything else. Rejects a wrong format or newer
// version, duplicate members, nesting over 32, NaN, infinities and numbers outside the limits of world/components.h,
// zero tangents, unknown ids.
base::Result<LoadedTrack> parse_track(std::string_view text, std::string_view name);

// Returns the text of a document: two-space indentation, one knot per line, every float in its shortest exact form;
// ends with a newline. parse_track(print_track(d)) equals d by hash, and printing that again gives the same bytes.
std::string print_track(const world::Document& document);

// Returns the name of a track from a file without one: the file's name without folder and extension, made valid.
std::string name_of_file(std::string_view path);

// Keys of one channel on the clipboard: `{"force-keys": "time", "keys": [[0, 1], [20, 3.5, 0.1, 5, 8]]}`, those of
// curvature with `"of": "curvature"`.
struct CopiedForceKeys {
  world::ForceDomain over{};
  std::vector<world::ForceKey> keys;  // ascending, at least one
  world::ForceQuantity of{};
};
std::string print_keys(const CopiedForceKeys& copied);
// Returns the keys, or the error in the text.
base::Result<CopiedForceKeys> parse_keys(std::string_view text);

}  // namespace coaster::exchange
