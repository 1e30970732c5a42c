// Figures of the last picture. gfx::Renderer::draw fills them, panels read them, and the table makes queries of them.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <variant>

#include "curve/evaluators.h"

namespace coaster::view {

struct DrawStats {
  int uploads = 0;                     // segments written to the track's buffers
  int recolours = 0;                   // segments whose values were written (not in uploads)
  int support_uploads = 0;             // segments whose supports were written (not in uploads)
  int park_uploads = 0;                // patches of a park's land that were written (not in uploads)
  std::int64_t park_upload_bytes = 0;  // written for the park, not in upload_bytes
  int draw_calls = 0;
  std::int64_t triangles = 0;  // of these draw calls, including shadow maps
  int shadow_maps = 0;  // drawn shadow maps: 0 unless track, trains, light or the visible part of a large track changed
  int samples = 0;      // multisampling in use
  double prepare_ms = 0;  // time of the cache to prepare uploads, outside GL
  double gpu_ms = 0;      // GPU time of the polyline in the newest finished frame (a few frames ago); 0: not measured
  std::int64_t upload_bytes = 0;           // written to the track's buffers
  std::int64_t polyline_upload_bytes = 0;  // of these, polylines: vertices, or control points for GPU evaluators
  std::int64_t polyline_bytes = 0;         // size of all polylines
  curve::EvaluatedBy drawn_by{};           // derived.evaluated_by, or the vertex shader as its substitute
  double deviation = 0;       // m, of vertices computed by the GPU, see CurveDeviation; 0 for processor evaluators
  int deviation_pending = 0;  // segments whose deviation will be measured in the next frames
};

struct DrawStatRow {
  std::string_view query, unit, text;
  std::variant<int DrawStats::*, std::int64_t DrawStats::*, double DrawStats::*> member;
};
inline constexpr std::array kDrawNumbers{
    DrawStatRow{"deviation_pending", "", "Segments whose deviation on the GPU is not yet measured.",
                &DrawStats::deviation_pending},
    DrawStatRow{"upload_bytes", "B", "Bytes written to the track's vertex buffers in the last frame.",
                &DrawStats::upload_bytes},
    DrawStatRow{"polyline_upload_bytes", "B",
                "The same for polylines only: vertices, or control points for GPU evaluators.",
                &DrawStats::polyline_upload_bytes},
    DrawStatRow{"polyline_bytes", "B", "GPU memory of all polylines.", &DrawStats::polyline_bytes},
    DrawStatRow{"gpu_ms", "ms", "GPU time of the polylines, a few frames ago; none if not measured.",
                &DrawStats::gpu_ms},
    DrawStatRow{"uploads", "", "Segments whose vertex buffers were uploaded in the last frame.", &DrawStats::uploads},
    DrawStatRow{"recolours", "", "Segments whose colour values were uploaded in the last frame; not part of uploads.",
                &DrawStats::recolours},
    DrawStatRow{"supports.uploads", "", "Segments whose supports were uploaded in the last frame; not part of uploads.",
                &DrawStats::support_uploads},
    DrawStatRow{"park.uploads", "", "Patches of the land that were uploaded in the last frame; not part of uploads.",
                &DrawStats::park_uploads},
    DrawStatRow{"park.upload_bytes", "B", "Bytes written for land, plants and tunnels in the last frame.",
                &DrawStats::park_upload_bytes},
    DrawStatRow{"draw_calls", "", "Draw calls of the scene in the last frame.", &DrawStats::draw_calls},
    DrawStatRow{"triangles", "", "Triangles of these draw calls.", &DrawStats::triangles},
    DrawStatRow{"shadow_maps", "", "Shadow maps drawn in the last frame; 0 if neither track, trains nor light changed.",
                &DrawStats::shadow_maps},
    DrawStatRow{"samples", "", "Samples per pixel (multisampling).", &DrawStats::samples},
};

}  // namespace coaster::view
