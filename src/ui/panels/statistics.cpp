// Statistics: cost of the last frame.
#include "ui/context/rows.h"

namespace coaster::ui {

void statistics_panel(Ui& ui) {
  const query::FrameStats& stats = ui.state.stats;
  const auto time = [&](double value, int decimals) {
    return ui.state.scripted || stats.hide_times || value <= 0 ? std::string("--") : fixed(value, decimals);
  };
  read_out(ui, "Frames per second", time(stats.fps, 0), "fps", "Frames per second.");
  read_out(ui, "Frame", time(stats.cpu_ms, 2), "ms", "CPU time of the last frame, without OpenGL and waiting.");
  read_out(ui, "OpenGL", time(stats.gl_ms, 2), "ms", "Time of the last frame in OpenGL.");
  read_query(ui, "Rebuilds", "rebuilds", {}, "Segments evaluated in the last frame. 0 while nothing moves.",
             {.decimals = 0, .unit = ""});
  read_query(ui, "Uploads", "uploads", {},
             "Segments whose vertex buffers were written in the last frame. 0 while nothing moves.",
             {.decimals = 0, .unit = ""});
  read_out(ui, "Entities", std::to_string(ui.session().document.entities.size()), "",
           "Knots, segments and carts in the registry.");
  read_out(ui, "Draw calls", std::to_string(stats.draw_calls), "", "Draw calls for the scene in the last frame.");
  read_out(ui, "Triangles", std::to_string(stats.triangles), "", "Triangles drawn in the last frame.");
  read_out(ui, "Shadow maps", std::to_string(stats.shadow_maps), "",
           "Shadow maps rendered in the last frame. 0 while nothing moves.");
  read_out(ui, "Samples", std::to_string(stats.samples), "", "Samples per pixel (multisampling).");
  read_out(ui, "Renderer", ui.renderer, "", "GL_RENDERER.");
}

}  // namespace coaster::ui
