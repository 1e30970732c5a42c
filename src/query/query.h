// Named values that panels, scripts and challenges read, each with a unit and a line of text. To add one, add a row to
// a table.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "base/text.h"
#include "edit/session/session.h"

namespace coaster::query {

// State of the document's file besides its path.
struct Keeping {
  std::string holder;   // the other process that has the file open, "another coaster (process 12)"; empty: none
  int recoverable = 0;  // autosaves of other runs that can be recovered
  int autosaves = 0;    // number written since the start
  bool quits = false;   // the system has asked the program to end
};

// Measured by the frame loop.
struct FrameStats {
  std::uint64_t frame = 0;
  int uploads = 0;                         // segments whose vertex buffers were uploaded in the last frame
  int rebuilds = 0;                        // segments evaluated in the last frame
  std::int64_t upload_bytes = 0;           // B written to the track's buffers in the last frame
  std::int64_t polyline_upload_bytes = 0;  // B of these, to polylines: vertices, or control points for GPU evaluators
  std::int64_t polyline_bytes = 0;         // B of all polylines
  curve::EvaluatedBy drawn_by{};           // evaluator of the last frame's polylines
  double gpu_deviation = 0;                // m, of vertices computed by the GPU
  int deviation_pending = 0;               // segments whose deviation on the GPU is not yet measured
  std::array<std::string, 4> stage_refusals;  // by stage: why the driver cannot evaluate there; empty if it can
  int recolours = 0;                          // segments whose colour values were uploaded (not in uploads)
  int supports = 0;                           // number of supports in the last frame; 0 while hidden
  int support_rebuilds = 0;                   // segments whose supports were recomputed
  int support_uploads = 0;                    // segments whose supports were uploaded (not in uploads)
  double colour_low = 0, colour_high = 1;     // ends of the colour legend, in the colouring's unit
  double fps = 0;                             // 0: not measured
  double cpu_ms = 0;                          // of the last frame, without GL and waiting
  double gl_ms = 0;
  double gpu_ms = 0;         // GPU time of the polylines in the newest finished frame; 0: not measured
  double evaluation_ms = 0;  // time of evaluators in the last frame that evaluated anything
  std::int64_t evaluated_vertices = 0;
  int draw_calls = 0;
  std::int64_t triangles = 0;  // of these draw calls
  int shadow_maps = 0;         // shadow maps drawn in the last frame
  bool hide_times = false;     // a script runs: times read "--"
  int samples = 0;             // multisampling in use
  int width = 0, height = 0;
  world::CameraMode camera_shown{};                           // orbit if there is no train to follow
  glm::dvec3 eye{0}, eye_forward{0, 0, -1}, eye_up{0, 1, 0};  // of the last frame's picture: m, unit, unit
  double field_of_view_deg = 0;
  int movie_frames = 0;  // pictures of the current movie, or of the last one
  Keeping keeping;
};

struct Context {
  const edit::Session& session;
  const FrameStats& stats;
  std::string_view toast;  // text of the newest notice, "" if none is shown
  std::string_view title;
};

// Ordered values such as continuity compare by rank: none < G0 < G1 < G2, off < on.
struct Ranked {
  int rank;
  std::string text;
};
using Value = std::variant<double, std::string, Ranked, glm::dvec3>;

std::string to_text(const Value& value);

struct Query {
  std::string_view name;      // "ride.speed"; with an argument: "position"
  std::string_view argument;  // "" or what must follow: "@knot", "document|motion"
  std::string_view unit;      // "m/s", "" if none
  std::string_view text;
  base::Result<Value> (*evaluate)(const Context& context, std::string_view argument);
};

std::span<const Query> queries();
const Query* find_query(std::string_view name);

// Returns the rank of a word for comparison with the Ranked value of a query, ignoring case: none, G0, G1, G2 (-1..2)
// for geometric and geometric_min; none, C0, C1, C2 for parametric and parametric_min; for every other query on, true,
// yes, 1 (1) and off, false, no, 0 (0). Nothing for other words. Does not check whether the query's values are ranked.
std::optional<int> rank_of(std::string_view query_name, std::string_view word);

}  // namespace coaster::query
