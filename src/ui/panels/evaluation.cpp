// Evaluation: methods, resolution, and the read-outs to compare them. Statistics: cost of the last frame.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "edit/commands/commands_settings.h"
#include "sim/shape/shape_distance.h"
#include "ui/context/query_widgets.h"
#include "ui/context/setting_widgets.h"
#include "ui/panels/panels.h"
#include "ui/widgets/theme.h"

namespace coaster::ui {
namespace {

using curve::EvaluatedBy;

enum class EvaluatorGroup { paper, fast, gpu };
// Returns the group of a row: the table begins with the methods of the paper; rows that are computed on the GPU say so.
EvaluatorGroup group_of(std::size_t row) {
  constexpr std::size_t kOfThePaper = 4;
  if (curve::evaluators()[row].evaluated_by != EvaluatedBy::processor) return EvaluatorGroup::gpu;
  return row < kOfThePaper ? EvaluatorGroup::paper : EvaluatorGroup::fast;
}

void method(Ui& ui, std::size_t row) {
  const curve::Evaluator& one = curve::evaluators()[row];
  const auto id = static_cast<curve::EvaluatorId>(row);
  const std::string& refusal = ui.state.stats.stage_refusals[static_cast<std::size_t>(one.evaluated_by)];
  const std::string tooltip = fmt::format("{}\nCost per point: {}{}{}", one.formula, one.cost,
                                          refusal.empty() ? "" : "\nNot available: ", refusal);
  if (radio(ui, one.label, ui.session().settings.evaluation->evaluator == id, tooltip, refusal.empty()))
    ui.emit(edit::Set<&world::Evaluation::evaluator>{id});
}

// Shows the rows of a group in the small font, two in a line if they fit.
void methods_of(Ui& ui, EvaluatorGroup group, std::string_view title, std::string_view tooltip) {
  ImGui::PushFont(small_font());
  heading(ui, title, tooltip);
  bool alone = false;  // the last one is alone in its line
  for (std::size_t i = 0; i < curve::evaluators().size(); ++i) {
    if (group_of(i) != group) continue;
    alone = !(alone && beside_last(ui, curve::evaluators()[i].label));
    method(ui, i);
  }
  ImGui::PopFont();
}

void resolution(Ui& ui) {
  const world::Settings& settings = ui.session().settings;
  steps_slider(ui);
  const Number budget = whole_number(static_cast<double>(settings.evaluation->vertex_budget), 1'000, 1e9, 1e15, 10'000);
  if (const auto to = number(ui, "Vertex budget", budget,
                             "Largest number of vertices of all polylines. Commands that need more are rejected."))
    ui.emit(edit::Set<&world::Evaluation::vertex_budget>{static_cast<std::int64_t>(*to)});
}

// Shows the chord error, because the rounding error says nothing about how well the polyline follows the curve. Next to
// the last item if there is space.
void chord_error(Ui& ui) {
  constexpr std::size_t kMost = 10'000;  // segments: some 2 ms after each change
  const std::size_t segments = ui.session().derived.order.size();
  const std::string value = segments == 0 || segments > kMost ? "--" : digits(ui, 1e3 * ui.find.chord_error(), 2, "mm");
  if (beside_last(ui, fmt::format("Chord error {}", value))) {
    // The label and its value need more than half of the row.
    const float free = ImGui::GetCursorScreenPos().x - ImGui::GetItemRectMax().x;
    const float earlier = std::floor(std::clamp(free - 5 * ui.scale, 0.0f, 9 * ui.scale));
    ImGui::SetCursorPos({ImGui::GetCursorPosX() - earlier, ImGui::GetCursorPosY() + ImGui::GetStyle().FramePadding.y});
  }
  read_out(
      ui, "Chord error", value, base::shown_in(ui.units, "mm").name,
      "Largest distance of a piece of the curve from its chord. More steps make it smaller. Up to 10,000 segments.");
}

}  // namespace

void evaluator_choice(Ui& ui) {
  methods_of(ui, EvaluatorGroup::paper, "The paper's four", "Barrett 2012, section 3, in textbook form.");
  methods_of(ui, EvaluatorGroup::fast, "Fast", "The same polynomial, arranged for modern processors.");
  methods_of(ui, EvaluatorGroup::gpu, "On the GPU",
             "Computed from the control points: each segment uploads 48 bytes instead of its polyline.");
}

void steps_slider(Ui& ui) {
  ui.emit_if<edit::Set<&world::Evaluation::steps>>(
      slider(ui, "Steps per segment", ui.session().settings.evaluation->steps, curve::kMinSteps, curve::kMaxSteps, true,
             "Straight pieces per segment, 1 to 4096. Ctrl+click or double-click to type."));
}

void evaluation_panel(Ui& ui) {
  evaluator_choice(ui);
  resolution(ui);
  setting_list<&world::Evaluation::arc_length>(
      ui, "Arc length", "Method of the displayed length. The ride always uses adaptive Gauss-Legendre.");
  ui.emit_if<edit::SetPolyline>(checkbox(ui, "Show polyline",
                                         ui.session().settings.lab->layers.has(world::Layer::polyline),
                                         "Draw the evaluated polyline over the track."));
  chord_error(ui);

  const query::FrameStats& stats = ui.state.stats;
  const bool timed = !ui.state.scripted && stats.evaluated_vertices > 0;
  read_query(ui, "Vertices", "vertices", "Vertices of all polylines together.", {.decimals = 0});
  read_out(ui, "Evaluation time", timed ? fixed(stats.evaluation_ms, 3) : "--", "ms",
           "Time of the selected method in the last frame that evaluated. A still frame evaluates nothing.");
  read_out(ui, "Time per point",
           timed ? fixed(stats.evaluation_ms * 1e6 / static_cast<double>(stats.evaluated_vertices), 1) : "--", "ns",
           "Evaluation time per vertex.");
  read_out(ui, "GPU time###Time on the GPU", !ui.state.scripted && stats.gpu_ms > 0 ? fixed(stats.gpu_ms, 3) : "--",
           "ms", "GPU time for the polylines, a few frames ago. Includes evaluation where the method runs on the GPU.");
  read_query(ui, "GPU memory###Held on the GPU", "polyline_bytes",
             "GPU memory of all polylines: 24 bytes per vertex, or 48 per segment when evaluated on the GPU.",
             {.decimals = 0});
  const std::size_t segments = ui.session().derived.order.size();
  read_out(ui, "Per segment###A segment",
           segments == 0 ? "--" : fixed(static_cast<double>(stats.polyline_bytes) / static_cast<double>(segments), 0),
           "B",
           "Bytes uploaded when a segment moves: its vertices, or its four control points when evaluated on the GPU.");
  read_query(ui, "Rounding error###Largest deviation", "deviation",
             "Largest distance of a vertex from the exact point at the same t (de Casteljau in long double).",
             {.decimals = 6, .unit = "mm", .factor = 1e3});
}

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
