// Lengths: every arc-length method on the selected segment and on the whole track, and its error by work.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "edit/commands/commands_settings.h"
#include "ui/lab/cache.h"
#include "ui/lab/table.h"
#include "ui/widgets/theme.h"
#include "world/evaluation.h"

namespace coaster::ui {
namespace {

using curve::ArcLengthMethod;
using curve::LengthControl;

constexpr TableColumn kMethod{
    "Method", "", 3.3f,
    "Arc-length methods, in the colours of the plot. Click a row to select the method of the displayed length."};
constexpr TableColumn kOfSegment[] = {
    {"Length", "m", 1.3f, "Length of the selected segment."},
    {"Error", "m", 1.2f, "Difference from the reference, 40-node Gauss-Legendre in long double."},
    {"Work", "", 0.8f, "Evaluations of |B'(t)| or chords: number of square roots."},
    {"Time", "\u00B5s", 0.9f,
     "Time of one measurement, the median of several, taken when the segment or the steps last changed."},
};
constexpr TableColumn kOfTrack[] = {
    {"Track", "m", 1.4f, "Sum over all segments, with the same tolerance for each."},
    {"Track error", "m", 1.3f, "Error of the track's length."},
};

std::string signed_error(double error) { return (error < 0 ? "\u2212" : "") + significant(std::abs(error), 2); }

void row_of(Ui& ui, std::size_t i, const LengthRow& row, bool segment, bool track) {
  const ArcLengthMethod& method = curve::arc_length_methods()[i];
  const world::Settings& settings = ui.session().settings;
  const bool timed = !ui.state.scripted && row.microseconds > 0;
  std::vector<Cell> cells{{std::string(method.label), kPlainColour, true, 0, row_colour(i)}};
  if (segment) {
    cells.push_back({fixed(row.length, 5)});
    cells.push_back({signed_error(row.error)});
    cells.push_back({std::to_string(row.evaluations)});
    cells.push_back({timed ? fixed(row.microseconds, 2) : "--"});
  }
  if (track) {
    cells.push_back({row.track_known ? fixed(row.track_length, 4) : "--"});
    cells.push_back({row.track_known ? signed_error(row.track_error) : "--"});
  }
  const bool chosen = static_cast<std::size_t>(settings.evaluation->arc_length) == i;
  const std::string value = fixed(row.length, 6) + " m";
  if (table_row(ui, "Length by " + std::string(method.label), cells, chosen, value, method.formula) && !chosen)
    ui.emit(edit::Set<&world::Evaluation::arc_length>{static_cast<curve::ArcLengthId>(i)});
}

void lengths_table(Ui& ui, const LengthStudy& study, bool segment, bool track, float width, float height) {
  std::vector<TableColumn> columns{kMethod};
  if (segment) columns.insert(columns.end(), std::begin(kOfSegment), std::end(kOfSegment));
  if (track) columns.insert(columns.end(), std::begin(kOfTrack), std::end(kOfTrack));
  ImGui::BeginChild("##lengths", {width, height}, false, ImGuiWindowFlags_NoNav);
  if (begin_table(ui, "Lengths table", columns, height)) {
    for (std::size_t i = 0; i < study.rows.size(); ++i) row_of(ui, i, study.rows[i], segment, track);
    end_table();
  }
  ImGui::EndChild();
}

// What the table speaks of, where it has not room for both.
void choose_columns(Ui& ui) {
  ImGui::PushFont(small_font());
  if (radio(ui, "Segment", !ui.lab.lengths_of_track, "List the segment's length by every method."))
    ui.lab.lengths_of_track = false;
  ImGui::SameLine();
  if (radio(ui, "Track", ui.lab.lengths_of_track, "List the track's length by every method."))
    ui.lab.lengths_of_track = true;
  ImGui::PopFont();
}

void convergence_plot(Ui& ui, const LengthStudy& study, float width, float height) {
  std::vector<Series> series;
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const LengthRow& row = study.rows[i];
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
  const float table = beside ? std::floor(room * 0.66f) : room, picture = beside ? room - table - gap : room;
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
