// Error: rounding error of the selected evaluator along the segment, with its bound and a second evaluator.
#include <algorithm>
#include <string>

#include "edit/commands/set_setting.h"
#include "ui/lab/cache.h"
#include "world/evaluation.h"
#include "world/lab_view.h"

namespace coaster::ui {
namespace {

using curve::EvaluatorId;

constexpr double kMillimetres = 1e3;

// Returns the bound of the evaluator's row for this segment, mm.
double bound_of(const curve::Cubic& c, const curve::Evaluator& evaluator, int steps) {
  const double extent = std::max({glm::length(glm::dvec3(c.p0)), glm::length(glm::dvec3(c.p1)),
                                  glm::length(glm::dvec3(c.p2)), glm::length(glm::dvec3(c.p3))});
  const auto leg = [](glm::vec3 a, glm::vec3 b) { return glm::length(glm::dvec3(b) - glm::dvec3(a)); };
  return evaluator.error_bound(extent, leg(c.p0, c.p1) + leg(c.p1, c.p2) + leg(c.p2, c.p3), steps) * kMillimetres;
}

ErrorStudy error_study(const sim::SegmentShape& shape, EvaluatorId id, int steps) {
  const curve::Evaluator& evaluator = base::row_of(id);
  ErrorStudy study;
  for (const sim::ErrorSample& sample : sim::error_profile(shape.curve, evaluator, steps)) {
    study.t.push_back(sample.t);
    study.mm.push_back(sample.mm);
  }
  study.bound = bound_of(shape.key.cubic, evaluator, steps);
  study.largest = *std::max_element(study.mm.begin(), study.mm.end());
  study.seam = study.mm.size() > 2 ? study.mm[study.mm.size() - 2] : 0;
  return study;
}

void error_plot(Ui& ui, const Probe& probe, const ErrorStudy& one, const ErrorStudy* other, float height) {
  const world::Settings& settings = ui.session().settings;
  std::vector<Series> series;
  if (other != nullptr)
    series.push_back({std::string(base::row_of(EvaluatorId{ui.lab.compared}).label), other->t, other->mm, row_colour(1),
                      SeriesKind::line, 1.4f});
  series.push_back({std::string(base::row_of(settings.evaluation->evaluator).label), one.t, one.mm, row_colour(0),
                    SeriesKind::line, 1.6f});
  const Level bound{"bound", one.bound, row_colour(3)};
  plot_over_t(
      ui, probe, "Error plot",
      {.x = {},
       .y = {"error", "mm", AxisScale::logarithmic},
       .series = series,
       .levels = {&bound, 1},
       .height = height},
      "Distance of each vertex from the exact point at the same t (de Casteljau in long double): float rounding "
      "only. An error of 0 lies on the lower edge. The dashed line is the method's error bound. Drag the cursor "
      "to move the probe.");
}

void side(Ui& ui, const ErrorStudy& one) {
  const world::Settings& settings = ui.session().settings;
  const auto steps =
      slider(ui, "Steps", settings.evaluation->steps, curve::kMinSteps, curve::kMaxSteps, true,
             "Steps per segment, 1 to 4096. With forward differences, more steps mean more rounding error.");
  if (steps) ui.emit(edit::Set<&world::Evaluation::steps>{*steps});
  std::vector<Choice> choices = choices_of<EvaluatorId>();
  choices.insert(choices.begin(), {"nothing", "No comparison."});
  if (const auto to = combo(ui, "Compare with###Beside", choices, ui.lab.compared + 1,
                            "A second evaluator for comparison.", ComboPlace::beside))
    ui.lab.compared = *to - 1;
  layer_box(ui, world::Layer::rounding);
  const Number magnification{.value = settings.lab->magnification,
                             .unit = "\u00D7",
                             .decimals = 0,
                             .step = 200,
                             .low = 1,
                             .high = 1e7,
                             .largest = 1e15};
  if (const auto to = number(ui, "Magnification###Magnified", magnification,
                             "Magnification of the error in the rounding layer, 1 to 10,000,000."))
    ui.emit(edit::Set<&world::LabView::magnification>{*to});
  const base::ShownUnit unit = base::shown_in(ui.units, "mm");
  const auto row = [&](std::string_view label, double millimetres, std::string_view tooltip) {
    read_out(ui, label, significant(millimetres * unit.factor, 3), unit.name, tooltip);
  };
  row("Largest error", one.largest, "Largest error of the selected evaluator on the segment.");
  row("Seam", one.seam,
      "Length of the jump at the last step. The last vertex is pinned to p\u2083, so the accumulated error appears "
      "there.");
  row("Bound", one.bound, "Error bound of the method for this segment.");
}

}  // namespace

void error_page(Ui& ui) {
  const auto probe = need_probe(ui);
  if (!probe) return;
  const world::Settings& settings = ui.session().settings;
  const auto study = [&](auto& kept, EvaluatorId id) -> const ErrorStudy& {
    return kept.get({probe->shape->shape_build, static_cast<int>(id), settings.evaluation->steps},
                    [&] { return error_study(*probe->shape, id, settings.evaluation->steps); });
  };
  const ErrorStudy& one = study(ui.lab.error, settings.evaluation->evaluator);
  const bool beside = ui.lab.compared >= 0 && EvaluatorId{ui.lab.compared} != settings.evaluation->evaluator;
  const ErrorStudy* other = beside ? &study(ui.lab.other_error, EvaluatorId{ui.lab.compared}) : nullptr;
  Page page(ui, 230);
  side(ui, one);
  error_plot(ui, *probe, one, other, page.pictures());
}

}  // namespace coaster::ui
