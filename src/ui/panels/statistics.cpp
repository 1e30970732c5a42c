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
  read_query(ui, "Rebuilds", "rebuilds", "Segments evaluated in the last frame. 0 while nothing moves.",
             {.decimals = 0, .unit = ""});
  read_query(ui, "Uploads", "uploads",
             "Segments whose vertex buffers were written in the last frame. 0 while nothing moves.",
             {.decimals = 0, .unit = ""});
  const auto count = [&](std::string_view label, auto value, std::string_view tooltip) {
    read_out(ui, label, std::to_string(value), "", tooltip);
  };
  count("Entities", ui.session().document.entities.size(), "Knots, segments and trains in the registry.");
  count("Draw calls", stats.draw_calls, "Draw calls for the scene in the last frame.");
  count("Triangles", stats.triangles, "Triangles drawn in the last frame.");
  count("Shadow maps", stats.shadow_maps, "Shadow maps rendered in the last frame. 0 while nothing moves.");
  count("Samples", stats.samples, "Samples per pixel (multisampling).");
  read_out(ui, "Renderer", ui.renderer, "", "GL_RENDERER.");
}

}  // namespace coaster::ui
