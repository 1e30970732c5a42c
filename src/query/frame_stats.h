// Figures of the last frame: app's frame fills them, panels read them, and the table makes queries of them. Those of
// its picture are the renderer's (view/draw_stats.h).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include <glm/glm.hpp>

#include "view/draw_stats.h"
#include "world/settings.h"

namespace coaster::query {

// State of the document's file, besides its path.
struct DocumentFileState {
  std::string holder;   // the other process that has the file open, "another coaster (process 12)"; empty: none
  int recoverable = 0;  // autosaves of other runs that can be recovered
  int autosaves = 0;    // number written since the start
  bool quits = false;   // the system has asked the program to end
};

struct FrameStats : view::DrawStats {
  std::uint64_t frame = 0;
  int rebuilds = 0;                        // segments evaluated in the last frame
  int supports = 0;                        // number of supports in the last frame; 0 while hidden
  int support_rebuilds = 0;                // segments whose supports were recomputed
  double colour_low = 0, colour_high = 1;  // ends of the colour legend, in the colouring's unit
  double fps = 0;                          // 0: not measured
  double cpu_ms = 0;                       // of the last frame, without GL and waiting
  double gl_ms = 0;
  double evaluation_ms = 0;  // time of evaluators in the last frame that evaluated anything
  std::int64_t evaluated_vertices = 0;
  std::array<std::string, 4> stage_refusals;  // by stage: why the driver cannot evaluate there; empty if it can
  bool hide_times = false;                    // a script runs: times read "--"
  int width = 0, height = 0;
  world::CameraMode camera_shown{};                           // orbit if there is no train to follow
  glm::dvec3 eye{0}, eye_forward{0, 0, -1}, eye_up{0, 1, 0};  // of the last frame's picture: m, unit, unit
  double field_of_view_deg = 0;
  int movie_frames = 0;  // pictures of the current movie, or of the last one
  DocumentFileState keeping;
};

struct FrameStatRow {
  std::string_view query, unit, text;
  std::variant<int FrameStats::*, std::uint64_t FrameStats::*, double FrameStats::*> member;
};
inline constexpr std::array kFrameNumbers{
    FrameStatRow{"frame", "", "Number of frames drawn since the start.", &FrameStats::frame},
    FrameStatRow{"rebuilds", "", "Segments evaluated for the last frame.", &FrameStats::rebuilds},
    FrameStatRow{"supports.count", "", "Number of supports; 0 while hidden.", &FrameStats::supports},
    FrameStatRow{"supports.rebuilds", "", "Segments whose supports were recomputed for the last frame.",
                 &FrameStats::support_rebuilds},
    FrameStatRow{"colour.low", "", "Lower end of the colours' legend, in their unit.", &FrameStats::colour_low},
    FrameStatRow{"colour.high", "", "Upper end of the colours' legend.", &FrameStats::colour_high},
    FrameStatRow{"fps", "1/s", "Frames per second; none if not measured.", &FrameStats::fps},
    FrameStatRow{"cpu_ms", "ms", "Processor time of the last frame, outside OpenGL and waiting.", &FrameStats::cpu_ms},
    FrameStatRow{"gl_ms", "ms", "Time of the last frame inside OpenGL.", &FrameStats::gl_ms},
    FrameStatRow{"evaluation_time", "ms", "Time of evaluators in the last frame that evaluated anything.",
                 &FrameStats::evaluation_ms},
    FrameStatRow{"width", "px", "Width of the picture.", &FrameStats::width},
    FrameStatRow{"height", "px", "Height of the picture.", &FrameStats::height},
    FrameStatRow{"movie.frames", "", "Pictures of the current movie, or of the last one.", &FrameStats::movie_frames},
};

}  // namespace coaster::query
