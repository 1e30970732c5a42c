// Queries of the laboratory: its layers and pages, the probe's construction, rounding, and the table of measurements.
#include <array>

#include <fmt/format.h>

#include "query/rows.h"
#include "sim/study/rounding.h"
#include "world/evaluation.h"
#include "world/lab_view.h"
#include "world/laboratory.h"

namespace coaster::query {
namespace {

// Returns the value named `word`, or an error.
template <base::Named E>
base::Result<E> named(View word, std::string_view what) {
  if (const auto value = base::value_named<E>(word)) return *value;
  return base::Status{base::Code::usage,
                      fmt::format("no {} {}{}", what, base::quoted(word), base::suggestion(word, base::names_of<E>()))};
}

Answer shown(const Context& c, View word) {
  const auto layer = named<world::Layer>(word, "layer");
  if (!layer) return layer.status();
  return yes_no(c.session.settings.lab->layers.has(*layer));
}

const sim::SegmentShape* selected_shape(const Context& c) {
  return c.session.derived.segments.find(c.session.settings.selected);
}
Answer construction_point(const Context& c, View) {
  const sim::SegmentShape* const shape = selected_shape(c);
  return Value(shape ? curve::point(shape->key.cubic, c.session.settings.selected_t) : glm::dvec3(0));
}

// sim::largest or sim::seam of the selected segment's rounding.
template <auto figure>
Answer rounding(const Context& c, View) {
  const sim::SegmentShape* const shape = selected_shape(c);
  const world::Evaluation& evaluation = *c.session.settings.evaluation;
  return number(shape ? figure(sim::rounding(shape->curve, base::row_of(evaluation.evaluator), evaluation.steps))
                      : 0.0);
}

Answer measuring(const Context& c, View) { return yes_no(c.session.measuring.measurement.running); }
Answer measure_progress(const Context& c, View) { return number(sim::progress(c.session.measuring.measurement)); }
Answer measure_rows(const Context& c, View) { return number(c.session.measuring.measurement.rows.size()); }

// Parses "horner/64": an evaluator and one of the measured numbers of steps.
base::Result<sim::MeasuredCell> cell_of(const Context& c, View word) {
  const std::size_t slash = word.find('/');
  const auto row = named<curve::EvaluatorId>(word.substr(0, slash), "evaluator");
  if (!row) return row.status();
  const auto steps = slash == View::npos ? std::nullopt : base::parse_int(word.substr(slash + 1));
  const sim::MeasuredRow* const row_measured = sim::row_of(c.session.measuring.measurement, *row);
  for (std::size_t i = 0; i < sim::kMeasuredSteps.size(); ++i) {
    if (!steps || *steps != sim::kMeasuredSteps[i]) continue;
    if (row_measured == nullptr || row_measured->cells[i].rounds == 0)
      return base::Status{base::Code::refused, std::string(word) + " has not been measured"};
    return row_measured->cells[i];
  }
  return base::Status{base::Code::usage,
                      "expected EVALUATOR/STEPS with 16, 64, 256, 1024 or 4096 steps, found " + base::quoted(word)};
}
template <auto member>
Answer measured(const Context& c, View word) {
  const auto cell = cell_of(c, word);
  return cell ? Answer(value_of((*cell).*member)) : cell.status();
}

constexpr std::array kLabRows{
    Query{"shown", "polyline|frames|comb|circle|construction|rounding|flips|limits|supports|knots|conflicts", "",
          "on if a layer of the laboratory is drawn.", shown},
    Query{"construction_point", "", "m",
          "Point at the picked position of the selected segment; 0 0 0 if none is selected.", construction_point},
    Query{"rounding", "", "m", "Largest rounding error of the evaluator's vertices on the selected segment.",
          rounding<sim::largest>},
    Query{"seam", "", "m", "Rounding error of the last vertex before the selected segment's exact end.",
          rounding<sim::seam>},
    Query{"measuring", "", "", "on during the measurement of evaluators.", measuring},
    Query{"measure.progress", "", "", "Progress of the measurement, 0 to 1.", measure_progress},
    Query{"measure.rows", "", "", "Number of evaluators measured; 0 before the first measurement.", measure_rows},
    Query{"measure.error", "EVALUATOR/STEPS", "m", "Measured largest error, for example of horner/64.",
          measured<&sim::MeasuredCell::worst_error>},
    Query{"measure.time", "EVALUATOR/STEPS", "ns", "Measured time per point, for example of horner/64.",
          measured<&sim::MeasuredCell::ns_per_point>},
};

}  // namespace

std::span<const Query> lab_rows() { return kLabRows; }

}  // namespace coaster::query
