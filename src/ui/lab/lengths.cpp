// Lengths: every arc-length method on the selected segment and on the whole track, and its error by work.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "edit/commands/set_setting.h"
#include "ui/lab/cache.h"
#include "ui/widgets/table.h"
#include "ui/widgets/theme.h"
#include "world/evaluation.h"

namespace coaster::ui {
namespace {

using curve::ArcLengthMethod;
using curve::Cubic;
using curve::LengthDemand;

LengthDemand demand_of(const ArcLengthMethod& method, int steps) { return {steps, method.usual_tolerance}; }

// Returns the seconds of one measurement: the median of three batches, each repeated to fill 50 us, at most 64 times.
double seconds_of(const ArcLengthMethod& method, const Cubic& cubic, const LengthDemand& demand,
                  const sim::Clock& clock) {
  if (!clock) return 0;
  std::array<double, 3> batches{};
  volatile double sink = 0;  // so that no measurement can be optimised away
  for (double& batch : batches) {
    const double began = clock();
    int runs = 0;
    double spent = 0;
    do {
      sink = sink + method.measure(cubic, demand).length;
      ++runs;
      spent = clock() - began;
    } while (spent < 50e-6 && runs < 64);
    batch = spent / runs;
  }
  std::sort(batches.begin(), batches.end());
  return batches[1];
}

LengthStudy study_of(const Cubic& cubic, int steps, const sim::Clock& clock) {
  const LengthDemand demand{steps, 1e-12};
  LengthStudy study;
  for (const curve::LengthComparison& one : curve::compare_lengths(cubic, demand)) {
    const ArcLengthMethod& method = base::row_of(one.method);
    study.push_back(
        {one.length, one.error, one.evaluations, seconds_of(method, cubic, demand_of(method, steps), clock) * 1e6});
  }
  for (const curve::Convergence& one : curve::convergence(cubic)) {
    LengthRow& row = study[static_cast<std::size_t>(one.method)];
    for (const curve::ConvergencePoint& point : one.points) {
      row.work.push_back(static_cast<double>(point.evaluations));
      row.relative_error.push_back(point.relative_error);
    }
  }
  return study;
}

// Adds some segments to the sums; complete when all are added.
void advance(TrackLengths& track, const sim::Derived& derived, int steps) {
  constexpr std::size_t kSegmentsAFrame = 32;
  const std::size_t end = std::min(derived.order.size(), track.next + kSegmentsAFrame);
  std::vector<Cubic> cubics;
  for (; track.next < end; ++track.next) cubics.push_back(derived.shape(derived.order[track.next]).key.cubic);
  track.lengths.resize(curve::arc_length_methods().size());
  track.errors.resize(track.lengths.size());
  for (const curve::LengthComparison& one : curve::compare_lengths(cubics, {steps, 1e-12})) {
    track.lengths[static_cast<std::size_t>(one.method)] += one.length;
    track.errors[static_cast<std::size_t>(one.method)] += one.error;
  }
}

// Returns the study of the probe's segment and of the whole track. Each call adds some segments of the track; its
// totals are known after the last one.
const LengthStudy& kept_lengths(Ui& ui, const Probe& probe) {
  const edit::Session& session = ui.session();
  const sim::Derived& derived = session.derived;
  const int steps = session.settings.evaluation->steps;
  LabCache& lab = ui.lab;
  (void)lab.lengths.get({probe.shape->shape_build, steps}, [&] {
    return study_of(probe.shape->key.cubic, steps, ui.state.scripted ? sim::Clock{} : session.measuring.clock);
  });
  (void)lab.track_lengths.get({derived.last_build, derived.order, steps}, [] { return TrackLengths{}; });
  TrackLengths& track = lab.track_lengths.value;
  if (track.next < derived.order.size()) advance(track, derived, steps);
  const bool known = track.next == derived.order.size();
  for (std::size_t i = 0; i < lab.lengths.value.size(); ++i) {
    LengthRow& row = lab.lengths.value[i];
    row.track_known = known;
    row.track_length = track.lengths[i];
    row.track_error = track.errors[i];
  }
  return lab.lengths.value;
}

constexpr TableColumn kMethod{
    "Method", "", 150,
    "Arc-length methods, in the colours of the plot. Click a row to select the method of the displayed length."};
constexpr TableColumn kOfSegment[] = {
    {"Length", "m", 76, "Length of the selected segment."},
    {"Error", "m", 76, "Difference from the reference, 40-node Gauss-Legendre in long double."},
    {"Work", "", 44, "Evaluations of |B'(t)| or chords: number of square roots."},
    {"Time", "\u00B5s", 46,
     "Time of one measurement, the median of several, taken when the segment or the steps last changed."},
};
constexpr TableColumn kOfTrack[] = {
    {"Track", "m", 78, "Sum over all segments, with the same tolerance for each."},
    {"Track error", "m", 82, "Error of the track's length."},
};

std::string signed_error(const Ui& ui, double metres) {
  const double error = metres * base::shown_in(ui.units, "m").factor;
  return (error < 0 ? "\u2212" : "") + significant(std::abs(error), 2);
}

void row_of(Ui& ui, std::size_t i, const LengthRow& row, bool segment, bool track) {
  const ArcLengthMethod& method = curve::arc_length_methods()[i];
  const world::Settings& settings = ui.session().settings;
  const bool timed = !ui.state.scripted && row.microseconds > 0;
  std::vector<Cell> cells{{std::string(method.label), kPlainColour, true, 0, row_colour(i)}};
  if (segment) {
    cells.push_back({digits(ui, row.length, 5, "m")});
    cells.push_back({signed_error(ui, row.error)});
    cells.push_back({std::to_string(row.evaluations)});
    cells.push_back({timed ? fixed(row.microseconds, 2) : "--"});
  }
  if (track) {
    cells.push_back({row.track_known ? digits(ui, row.track_length, 4, "m") : "--"});
    cells.push_back({row.track_known ? signed_error(ui, row.track_error) : "--"});
  }
  const bool chosen = static_cast<std::size_t>(settings.evaluation->arc_length) == i;
  const std::string value = measured(ui, row.length, 6, "m");
  if (table_row(ui, fmt::format("Length by {}", method.label), cells, chosen, value, method.formula) && !chosen)
    ui.emit(edit::Set<&world::Evaluation::arc_length>{static_cast<curve::ArcLengthId>(i)});
}

void lengths_table(Ui& ui, const LengthStudy& study, bool segment, bool track, float width, float height) {
  std::vector<TableColumn> columns{kMethod};
  if (segment) columns.insert(columns.end(), std::begin(kOfSegment), std::end(kOfSegment));
  if (track) columns.insert(columns.end(), std::begin(kOfTrack), std::end(kOfTrack));
  ImGui::BeginChild("##lengths", sized({width, height}), false, ImGuiWindowFlags_NoNav);
  if (begin_table(ui, "Lengths table", columns, height)) {
    for (std::size_t i = 0; i < study.size(); ++i) row_of(ui, i, study[i], segment, track);
    end_table();
  }
  ImGui::EndChild();
}

// Selects the columns of the table where there is no space for both.
void choose_columns(Ui& ui) {
  ImGui::PushFont(small_font());
  choose_side(ui, ui.lab.lengths_of_track, {"Segment", "List the segment's length by every method."},
              {"Track", "List the track's length by every method."});
  ImGui::PopFont();
}

void convergence_plot(Ui& ui, const LengthStudy& study, float width, float height) {
  std::vector<Series> series;
  for (std::size_t i = 0; i < study.size(); ++i) {
    const LengthRow& row = study[i];
    series.push_back({"", row.work, row.relative_error, row_colour(i),
                      row.work.size() > 1 ? SeriesKind::line_and_points : SeriesKind::points, 1.4f});
  }
  (void)plot(ui, "Convergence plot",
             {.x = {"evaluations", "", AxisScale::logarithmic},
              .y = {"relative error", "", AxisScale::logarithmic, 1e-17, 1},
              .series = series,
              .width = width,
              .height = height},
             "Relative error on the selected segment by work. Steeper and further to the lower left is better. Below "
             "1e-16 is rounding.");
}

}  // namespace

void lengths_page(Ui& ui) {
  const auto probe = need_probe(ui);
  if (!probe) return;
  const LengthStudy& study = kept_lengths(ui, *probe);
  const float room = ImGui::GetContentRegionAvail().x, height = ImGui::GetContentRegionAvail().y,
              gap = std::floor(14 * ui.scale);
  const bool both = room > 900 * ui.scale, beside = room > 500 * ui.scale;
  const float table = beside ? std::floor(room * (both ? 0.66f : 0.72f)) : room,
              picture = beside ? room - table - gap : room;
  const float stacked = std::floor(150 * ui.scale);
  if (!both && !beside) choose_columns(ui);
  lengths_table(ui, study, both || !ui.lab.lengths_of_track, both || ui.lab.lengths_of_track, table,
                beside ? height : stacked);
  if (beside) ImGui::SameLine(0, gap);
  ImGui::BeginGroup();
  if (!both && beside) choose_columns(ui);
  convergence_plot(ui, study, picture, beside ? ImGui::GetContentRegionAvail().y : stacked);
  ImGui::EndGroup();
}

}  // namespace coaster::ui
