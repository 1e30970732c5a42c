// The named values that panels, scripts and challenges read, each with a unit and a line of text. A row of the table
// adds one.
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

// What is known about the document's file beyond its path.
struct Keeping {
  std::string holder;   // who else edits it, "another coaster (process 12)"; empty: nobody
  int recoverable = 0;  // autosaves of other runs that wait for an answer
  int autosaves = 0;    // written since the start
  bool quits = false;   // the program was told to end
};

// Measured by the frame loop; shown here.
struct FrameStats {
  std::uint64_t frame = 0;
  int uploads = 0;                // segments whose vertex buffers were uploaded in the last frame
  int rebuilds = 0;               // segments evaluated in the last frame
  std::int64_t upload_bytes = 0;  // B written to the track's buffers in the last frame
  std::int64_t polyline_upload_bytes =
      0;                            // B of these, to polylines: vertices, or control points for the GPU's evaluators
  std::int64_t polyline_bytes = 0;  // B held for all polylines
  curve::Stage drawn_by{};          // what evaluated the polylines of the last frame
  double gpu_deviation = 0;         // m, of vertices that the GPU computed
  int deviation_pending = 0;        // segments whose deviation on the GPU is still to be measured
  std::array<std::string, 4>
      stage_refusals;        // by curve::Stage: why the driver cannot evaluate there; empty where it can
  int recolours = 0;         // segments whose values, which the track is coloured by, were uploaded (counted apart)
  int supports = 0;          // that hold the track in the last frame; 0 while hidden
  int support_rebuilds = 0;  // segments whose supports were looked for
  int support_uploads = 0;   // segments whose supports were uploaded (counted apart)
  double colour_low = 0, colour_high = 1;  // ends of the colour legend, in the colouring's unit
  double fps = 0;                          // 0: not measured
  double cpu_ms = 0;                       // of the last frame, outside GL and waiting
  double gl_ms = 0;
  double gpu_ms = 0;         // of the GPU, on the polylines, in the newest frame that is known; 0: not measured
  double evaluation_ms = 0;  // in evaluators during the last frame that evaluated anything
  std::int64_t evaluated_vertices = 0;
  int draw_calls = 0;
  std::int64_t triangles = 0;  // sent by these calls
  int shadow_maps = 0;         // drawn anew in the last frame
  bool hide_times = false;     // scripted: times read "--"
  int samples = 0;             // of multisampling in use
  int width = 0, height = 0;
  world::CameraMode camera_shown{};                           // orbit where there is no train to go with
  glm::dvec3 eye{0}, eye_forward{0, 0, -1}, eye_up{0, 1, 0};  // of the last frame's picture: m, unit, unit
  double field_of_view_deg = 0;
  int movie_frames = 0;  // pictures of the movie that is being recorded, or of the last one
  Keeping keeping;
};

struct Context {
  const edit::Session& session;
  const FrameStats& stats;
  std::string_view toast;  // text of the newest notice, "" when none shows
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
  std::string_view unit;      // "m/s", "" where there is none
  std::string_view text;
  base::Result<Value> (*evaluate)(const Context& context, std::string_view argument);
};

std::span<const Query> queries();
const Query* find_query(std::string_view name);

// The rank that a word stands for when it is compared with the Ranked value of a query, in upper or lower case: none,
// G0, G1, G2
// (-1..2) for geometric and geometric_min, none, C0, C1, C2 for parametric and parametric_min; for every other query
// on, true, yes, 1 (1) and off, false, no, 0 (0). Nothing for other words. Whether the query's values are ranked at all
// is not looked at.
std::optional<int> rank_of(std::string_view query_name, std::string_view word);

}  // namespace coaster::query
