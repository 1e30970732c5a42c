// Queries of the laboratory: its layers and pages, the probe's construction, rounding, and the table of measurements.
#include <algorithm>
#include <array>

#include "query/rows.h"
#include "sim/study/rounding.h"
#include "world/evaluation.h"
#include "world/lab_view.h"
#include "world/laboratory.h"

namespace coaster::query {
namespace {

Answer shown(const Context& c, View word) {
  return yes_no(c.session.settings.lab->layers.has(*base::value_named<world::Layer>(word)));
}

const sim::SegmentShape* selected_shape(const Context& c) {
  return c.session.derived.segments.find(c.session.settings.selected);
}
constexpr View kNoSegmentSelected = "no segment is selected";
Answer construction_point(const Context& c, View) {
  const sim::SegmentShape* const shape = selected_shape(c);
  if (!shape) return none(kNoSegmentSelected);
  return Value(curve::point(shape->key.cubic, c.session.settings.selected_t));
}

// sim::largest or sim::seam of the selected segment's rounding.
template <auto figure>
Answer rounding(const Context& c, View) {
  const sim::SegmentShape* const shape = selected_shape(c);
  const world::Evaluation& evaluation = *c.session.settings.evaluation;
  if (!shape) return none(kNoSegmentSelected);
  return number(figure(sim::rounding(shape->curve, base::row_of(evaluation.evaluator), evaluation.steps)));
}

Answer measuring(const Context& c, View) { return yes_no(c.session.measuring.measurement.running); }
Answer measure_progress(const Context& c, View) { return number(sim::progress(c.session.measuring.measurement)); }
Answer measure_rows(const Context& c, View) { return number(c.session.measuring.measurement.rows.size()); }

std::vector<std::string> measured_steps() {
  std::vector<std::string> words;
  for (const int steps : sim::kMeasuredSteps) words.push_back(std::to_string(steps));
  return words;
}
constexpr ArgumentPart kMeasured[]{{.usage = "EVALUATOR", .words = base::names_of<curve::EvaluatorId>},
                                   {.usage = "STEPS", .words = measured_steps, .before = '/'}};
// Returns a figure of the measurement of "horner/64".
template <auto member>
Answer measured(const Context& c, View word) {
  const std::size_t slash = word.find('/');
  const auto evaluator = *base::value_named<curve::EvaluatorId>(word.substr(0, slash));
  const std::vector<std::string> steps = measured_steps();
  const auto index = std::find(steps.begin(), steps.end(), word.substr(slash + 1)) - steps.begin();
  const sim::MeasuredRow* const row = sim::row_of(c.session.measuring.measurement, evaluator);
  if (row == nullptr || row->cells[static_cast<std::size_t>(index)].rounds == 0)
    return none("it has not been measured");
  if (member == &sim::MeasuredCell::ns_per_point && !row->is_timed())
    return none("it runs on the GPU and has no time of the processor");
  return value_of(row->cells[static_cast<std::size_t>(index)].*member);
}

constexpr std::array kLabRows{
    Query{"shown", kWordOf<world::Layer>, "", "on if a layer of the laboratory is drawn.", shown, kSwitch},
    Query{"construction_point", kNoArgument, "m",
          "Point at the selected position of the selected segment; none if none is selected.", construction_point,
          or_none(kVector)},
    Query{"rounding", kNoArgument, "m", "Largest rounding error of the evaluator's vertices on the selected segment.",
          rounding<sim::largest>, or_none()},
    Query{"seam", kNoArgument, "m", "Rounding error of the last vertex before the selected segment's exact end.",
          rounding<sim::seam>, or_none()},
    Query{"measuring", kNoArgument, "", "on during the measurement of evaluators.", measuring, kSwitch},
    Query{"measure.progress", kNoArgument, "", "Progress of the measurement, 0 to 1.", measure_progress},
    Query{"measure.rows", kNoArgument, "", "Number of evaluators measured; 0 before the first measurement.",
          measure_rows},
    Query{"measure.error", kMeasured, "m", "Measured largest error over all segments, for example of horner/64.",
          measured<&sim::MeasuredCell::worst_error>, or_none()},
    Query{"measure.time", kMeasured, "ns", "Measured time per point on the processor, for example of horner/64.",
          measured<&sim::MeasuredCell::ns_per_point>, or_none()},
};

}  // namespace

std::span<const Query> lab_rows() { return kLabRows; }

}  // namespace coaster::query
