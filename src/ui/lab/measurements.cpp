// Measurements: time and largest error of every evaluator at several resolutions, measured on this machine on request.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "edit/commands/commands_lab.h"
#include "ui/lab/cache.h"
#include "ui/widgets/table.h"
#include "ui/widgets/theme.h"
#include "world/evaluation.h"

namespace coaster::ui {
namespace {

double value_of_cell(const sim::MeasuredCell& cell, bool time) {
  return time ? cell.ns_per_point : cell.worst_error * 1e3;
}

// Returns a colour from dark green for the smallest to dark red for the largest, by the logarithm.
std::uint32_t heat(double value, const Extent& all) {
  if (!(value > 0) || all.empty() || all.high <= all.low) return 0;
  const double part = std::log(value / all.low) / std::log(all.high / all.low);
  const auto mix = [&](int from, int to) {
    return static_cast<std::uint32_t>(std::lround(from + (to - from) * std::clamp(part, 0.0, 1.0)));
  };
  return mix(0x1E, 0x52) << 16 | mix(0x45, 0x2C) << 8 | mix(0x38, 0x2E);
}

std::string row_tooltip(const sim::MeasuredRow& row, bool time) {
  std::string text(base::row_of(row.evaluator).formula);
  if (row.is_timed()) return text;
  return text + (time ? "\nRuns on the GPU while it draws: its time is \"GPU time\" under Evaluation."
                      : "\nRuns on the GPU: the error here is that of the same arithmetic on the processor.");
}

void measured_table(Ui& ui, const sim::Measurement& m, bool time, float width, float height) {
  std::vector<TableColumn> columns{
      {time ? "Time (ns per point) at steps" : "Worst error (mm) at steps", "", 165,
       time ? "Nanoseconds per point on the processor: the median of the rounds so far."
            : "Largest distance of a vertex from the exact point, over all segments of the track."}};
  std::vector<std::string> titles;
  for (const int steps : sim::kMeasuredSteps) titles.push_back(std::to_string(steps));
  for (const std::string& title : titles) columns.push_back({title, "", 60, "Steps per segment."});
  const base::ShownUnit millimetre = base::shown_in(ui.units, "mm");
  Extent all;
  for (const sim::MeasuredRow& row : m.rows)
    for (const sim::MeasuredCell& cell : row.cells)
      if (cell.rounds > 0) all.add(value_of_cell(cell, time), AxisScale::logarithmic);
  ImGui::BeginChild(time ? "##times" : "##errors", sized({width, height}), false, ImGuiWindowFlags_NoNav);
  if (begin_table(ui, time ? "Times" : "Errors", columns, height)) {
    for (const sim::MeasuredRow& row : m.rows) {
      const std::string name(base::row_of(row.evaluator).label);
      std::vector<Cell> cells{{name, kPlainColour, true}};
      std::string values;
      for (const sim::MeasuredCell& cell : row.cells) {
        const bool hidden_time = time && (ui.state.scripted || cell.ns_per_point <= 0);
        const std::string words = cell.rounds == 0 || hidden_time ? "--"
                                  : time                          ? fixed(cell.ns_per_point, 2)
                                         : significant(cell.worst_error * 1e3 * millimetre.factor, 2);
        cells.push_back(
            {words, kPlainColour, false, hidden_time || cell.rounds == 0 ? 0 : heat(value_of_cell(cell, time), all)});
        values += (values.empty() ? "" : " ") + words;
      }
      (void)table_row(ui, (time ? "Time of " : "Error of ") + name, cells,
                      ui.session().settings.evaluation->evaluator == row.evaluator, values, row_tooltip(row, time));
    }
    end_table();
  }
  ImGui::EndChild();
}

void progress_bar(Ui& ui, double part) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 high(low.x + ImGui::GetContentRegionAvail().x, low.y + std::floor(6 * ui.scale));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, high, packed(palette().field), 3);
  if (part > 0)
    list.AddRectFilled(low, {low.x + (high.x - low.x) * static_cast<float>(part), high.y}, packed(palette().accent), 3);
  ImGui::Dummy(sized({high.x - low.x, high.y - low.y}));
  note_item(ui, "Progress", "label", "Part of the table that is measured.", true, fixed(part * 100, 0) + " %");
}

void side(Ui& ui) {
  const edit::Session& session = ui.session();
  const sim::Measurement& m = session.measuring.measurement;
  const float width = std::floor((ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2);
  if (button(ui, "Measure",
             "Measure time and error of every evaluator on this machine, on the curves of this track. Takes some "
             "seconds, on a very long track minutes.",
             !m.running && !session.derived.order.empty(), width))
    ui.emit(edit::Measure{});
  ImGui::SameLine();
  if (button(ui, "Stop", "Stop measuring. Results so far are kept.", m.running, width)) ui.emit(edit::StopMeasuring{});
  progress_bar(ui, sim::progress(m));
  if (const auto to =
          text(ui, "CSV file", ui.lab.csv, "File for the table, as comma-separated values.", TextShows::end))
    ui.lab.csv = *to;
  if (button(ui, "Export CSV", "Write the table to the file.", !m.rows.empty() && !ui.lab.csv.empty()))
    ui.emit(edit::SaveMeasurements{ui.lab.csv});
}

}  // namespace

void measurements_page(Ui& ui) {
  const sim::Measurement& m = ui.session().measuring.measurement;
  Page page(ui, 190);
  side(ui);
  const bool beside = page.pictures_width() > 950 * ui.scale;
  if (!beside && !m.rows.empty())
    choose_side(ui, ui.lab.show_errors, {"Time", "Show nanoseconds per point."},
                {"Worst error", "Show the largest error."});
  const float height = page.pictures(), room = ImGui::GetContentRegionAvail().x, gap = std::floor(14 * ui.scale);
  if (m.rows.empty())
    return small_note(
        "No measurements yet. Press Measure: every evaluator computes the curves of this track at 16 to 4096 steps per "
        "segment. The table shows nanoseconds per point and the largest error over all segments, on this machine.");
  if (beside) {
    measured_table(ui, m, true, std::floor((room - gap) / 2), height);
    ImGui::SameLine(0, gap);
    measured_table(ui, m, false, std::floor((room - gap) / 2), height);
  } else {
    measured_table(ui, m, !ui.lab.show_errors, room, height);
  }
}

}  // namespace coaster::ui
