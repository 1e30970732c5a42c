// Evaluation: the methods to compare, resolution, and the read-outs to compare them by.
#include "ui/panels.h"

namespace coaster::ui {
namespace {

void methods(Ui& ui) {
  const auto rows = curve::evaluators();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto id = static_cast<curve::EvaluatorId>(i);
    const std::string tooltip = std::string(rows[i].formula) + "\nCost a point: " + std::string(rows[i].cost);
    if (radio(ui, rows[i].label, ui.session().settings.evaluator == id, tooltip)) ui.emit(edit::SetEvaluator{id});
  }
}

void resolution(Ui& ui) {
  const world::Settings& settings = ui.session().settings;
  const auto steps = slider(ui, "Steps per segment", settings.steps, curve::kMinSteps, curve::kMaxSteps, true,
                            "Straight pieces that each segment is drawn with, 1 to 4096. Ctrl+click or double-click to type.");
  if (steps) ui.emit(edit::SetResolution{*steps});
  const Number budget{.value = static_cast<double>(settings.vertex_budget), .decimals = 0, .step = 10'000, .low = 1'000, .high = 1e9, .largest = 1e15};
  if (const auto to = number(ui, "Vertex budget", budget, "How many vertices all polylines together may have; more is refused.")) {
    ui.emit(edit::SetVertexBudget{static_cast<std::int64_t>(*to)});
  }
}

void lengths(Ui& ui) {
  std::vector<Choice> choices;
  for (const auto& row : curve::arc_length_methods()) choices.push_back({std::string(row.label), std::string(row.formula)});
  const auto chosen = combo(ui, "Arc length", choices, static_cast<int>(ui.session().settings.arc_length),
                            "How the displayed length is measured. The ride always uses the adaptive Gauss-Legendre rule.");
  if (chosen) ui.emit(edit::SetArcLength{static_cast<curve::ArcLengthId>(*chosen)});
}

}  // namespace

void evaluation_panel(Ui& ui) {
  methods(ui);
  resolution(ui);
  lengths(ui);
  if (const auto on = checkbox(ui, "Show polyline", ui.session().settings.layers.has(world::Layer::polyline), "Draw the evaluated polyline over the track."))
    ui.emit(edit::SetPolyline{*on});

  const query::FrameStats& stats = ui.state.stats;
  const bool timed = !ui.state.scripted && stats.evaluated_vertices > 0;
  read_query(ui, "Vertices", "vertices", {}, "Vertices of all polylines together.", {.decimals = 0});
  read_out(ui, "Evaluation time", timed ? fixed(stats.evaluation_ms, 3) : "--", "ms",
           "Time inside the chosen method in the last frame that evaluated anything. A still frame evaluates nothing.");
  read_out(ui, "Time per point", timed ? fixed(stats.evaluation_ms * 1e6 / static_cast<double>(stats.evaluated_vertices), 1) : "--", "ns",
           "The same, per vertex.");
  read_query(ui, "Largest deviation", "deviation", {},
             "Largest distance of a vertex from the exact point at the same parameter (de Casteljau in long double): rounding error alone.",
             {.decimals = 6, .unit = "mm", .factor = 1e3});
}

}  // namespace coaster::ui
