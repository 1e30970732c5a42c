// Pages about accuracy and cost: Error, Measurements, Lengths and Errata.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "edit/commands/commands_settings.h"
#include "edit/commands/set_setting.h"
#include "sim/study/track_errata.h"
#include "ui/context/query_widgets.h"
#include "ui/lab/page_widgets.h"
#include "ui/widgets/table.h"
#include "ui/widgets/theme.h"
#include "world/evaluation_settings.h"
#include "world/laboratory_settings.h"

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
  const LevelLine bound{"bound", one.bound, row_colour(3)};
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
  ui.emit_if<edit::Set<&world::Evaluation::steps>>(
      slider(ui, "Steps", settings.evaluation->steps, curve::kMinSteps, curve::kMaxSteps, true,
             "Steps per segment, 1 to 4096. With forward differences, more steps mean more rounding error."));
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
  ui.emit_if<edit::Set<&world::LabView::magnification>>(
      number(ui, "Magnification###Magnified", magnification,
             "Magnification of the error in the rounding layer, 1 to 10,000,000."));
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
    ui.emit(edit::StartMeasuring{});
  ImGui::SameLine();
  if (button(ui, "Stop", "Stop measuring. Results so far are kept.", m.running, width)) ui.emit(edit::StopMeasuring{});
  progress_bar(ui, sim::progress(m));
  if (const auto to =
          text(ui, "CSV file", ui.lab.csv, "File for the table, as comma-separated values.", ShownTextEnd::end))
    ui.lab.csv = *to;
  if (button(ui, "Export CSV", "Write the table to the file.", !m.rows.empty() && !ui.lab.csv.empty()))
    ui.emit(edit::SaveMeasurements{ui.lab.csv});
}

using curve::ArcLengthMethod;
using curve::Cubic;
using curve::LengthAccuracy;

LengthAccuracy demand_of(const ArcLengthMethod& method, int steps) { return {steps, method.usual_tolerance}; }

// Returns the seconds of one measurement: the median of three batches, each repeated to fill 50 us, at most 64 times.
double seconds_of(const ArcLengthMethod& method, const Cubic& cubic, const LengthAccuracy& demand,
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
  const LengthAccuracy demand{steps, 1e-12};
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
void advance(TrackLengths& track, const sim::DerivedTrack& derived, int steps) {
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
  const sim::DerivedTrack& derived = session.derived;
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

// One claim: the paper's words and number, then the correct number and why.
void claim_row(Ui& ui, const sim::Erratum& e) {
  const auto number = [&](double value, std::string_view unit) {
    const base::ShownUnit users = base::shown_in(ui.units, unit);
    return fmt::format("{}{}{}", significant(value * users.factor, 4), unit.empty() ? "" : " ", users.name);
  };
  const std::string wrong = number(e.wrong, e.wrong_unit), right = number(e.right, e.unit);
  ImGui::TableNextRow();
  ImGui::TableSetColumnIndex(0);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const std::string explanation = in_units(ui, e.explanation);
  tinted(in_units(ui, e.claim), palette().text);
  ImGui::TableSetColumnIndex(1);
  tinted_line(wrong, palette().error);
  ImGui::TableSetColumnIndex(2);
  tinted_line(right, palette().good);
  ImGui::TableSetColumnIndex(3);
  tinted(explanation, palette().dim);
  ImGui::TableSetColumnIndex(0);
  note(ui, fmt::format("Erratum {}", e.name), "label", e.explanation, true, fmt::format("{} | {}", wrong, right), low,
       {low.x + width, low.y + ImGui::GetTextLineHeight()});
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
  PageLayout page(ui, 230);
  side(ui, one);
  error_plot(ui, *probe, one, other, page.pictures());
}

void measurements_page(Ui& ui) {
  const sim::Measurement& m = ui.session().measuring.measurement;
  PageLayout page(ui, 190);
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

void errata_page(Ui& ui) {
  const auto probe = need_probe(ui);
  if (!probe) return;
  const world::Settings& settings = ui.session().settings;
  const double speed = std::abs(number_of(ui, "ride.speed").value_or(NAN));
  const auto& rows = ui.lab.errata.get(
      {probe->shape->shape_build, ui.session().derived.last_build, settings.evaluation->steps, speed},
      [&] { return sim::errata(ui.session().derived, probe->segment, speed, settings.evaluation->steps); });
  push_table_style(ui, 2);
  if (ImGui::BeginTable("##errata", 4, kTableFlags)) {
    const std::pair<std::string, float> columns[] = {{"The paper says", 2.1f},
                                                     {"Its value", 0.95f},
                                                     {"Truth on " + world::to_text(probe->name), 1.15f},
                                                     {"Why", 3.0f}};
    for (const auto& [title, weight] : columns)
      ImGui::TableSetupColumn(title.c_str(), ImGuiTableColumnFlags_WidthStretch, weight);
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    for (int i = 0; i < 4; ++i) {
      ImGui::TableSetColumnIndex(i);
      draw_text(*ImGui::GetWindowDrawList(), ImGui::GetCursorScreenPos(), palette().dim,
                shortened(columns[i].first, ImGui::GetContentRegionAvail().x));
      ImGui::Dummy(sized({1, ImGui::GetTextLineHeight()}));
    }
    for (const sim::Erratum& e : rows) claim_row(ui, e);
    ImGui::EndTable();
  }
  pop_table_style();
}

}  // namespace coaster::ui
