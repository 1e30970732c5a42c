// Queries of the session: settings, selection, history, the camera, the last frame and the laboratory.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "query/rows.h"
#include "sim/ride/ride.h"
#include "sim/shape/frame_methods.h"
#include "sim/shape/shape_distance.h"
#include "sim/study/evaluator_benchmark.h"
#include "world/evaluation_settings.h"
#include "world/laboratory.h"
#include "world/laboratory_settings.h"
#include "world/selection.h"
#include "world/settings_groups.h"

namespace coaster::query {
namespace {

Answer selected(const QueryContext& c, View) {
  const world::Entity e = c.session.settings.selected;
  const bool any = c.session.document.entities.find<world::EntityName>(e) != nullptr;
  return any ? text(world::label_of(c.session.document, e)) : none(kNothingSelected);
}
Answer selected_kind(const QueryContext& c, View) {
  const auto* const name = c.session.document.entities.find<world::EntityName>(c.session.settings.selected);
  return name ? value_of(name->kind) : none(kNothingSelected);
}
Answer selected_t(const QueryContext& c, View) {
  const bool segment = c.session.derived.segments.contains(c.session.settings.selected);
  return segment ? number(c.session.settings.selected_t) : none("no segment is selected");
}
Answer selected_count(const QueryContext& c, View) {
  const std::size_t several = world::selected_knots(c.session.document, c.session.settings).size() +
                              world::selected_sections(c.session.document, c.session.settings).size();
  return number(several > 0 ? several : c.session.settings.selected.valid() ? 1 : 0);
}
Answer undo_label(const QueryContext& c, View) {
  return text(c.session.history.undo.empty() ? "" : c.session.history.undo.back().text.command);
}
Answer dirty(const QueryContext& c, View) { return yes_no(edit::dirty(c.find)); }
Answer toast(const QueryContext& c, View) { return text(c.toast); }
base::Result<Widget> widget(const QueryContext& c, View path) {
  return c.widget ? c.widget(path) : base::Status{base::Code::refused, "there are no panels"};
}
Answer widget_text(const QueryContext& c, View path) {
  const auto found = widget(c, path);
  return found ? Answer(text(found->text())) : found.status();
}
Answer enabled(const QueryContext& c, View path) {
  const auto found = widget(c, path);
  return found ? Answer(yes_no(found->enabled)) : found.status();
}
// Off has the reason as its text.
Answer visible(const QueryContext& c, View path) {
  const auto found = widget(c, path);
  if (!found && (!c.widget || found.status().code != base::Code::refused)) return found.status();
  const std::string why = !found           ? found.status().message
                          : found->covered ? "covered by another window"
                                           : "out of sight";
  return found && found->visible && !found->covered ? yes_no(true) : Ranked{0, why};
}
constexpr ArgumentPart kWidget[]{{.usage = "\"PATH\""}};
Answer title(const QueryContext& c, View) { return text(c.title); }
Answer polyline(const QueryContext& c, View) {
  return yes_no(c.session.settings.lab->layers.has(world::Layer::polyline));
}
Answer link_bytes(const QueryContext& c, View) { return number(c.session.shared.size()); }
Answer file(const QueryContext& c, View) { return text(c.session.file.path.filename().string()); }

Answer camera_height(const QueryContext& c, View) { return c.stats.frame > 0 ? number(c.stats.eye.y) : none(kNoFrame); }
Answer camera_tilt(const QueryContext& c, View) {
  if (c.stats.frame == 0) return none(kNoFrame);
  // Roll of the picture's horizontal against the ground, clockwise as the rider tilts to the right.
  const double right = glm::cross(c.stats.eye_forward, c.stats.eye_up).y;
  return number(glm::degrees(std::atan2(-right, c.stats.eye_up.y)));
}
template <auto member>
constexpr auto of_camera = of_session<&edit::Session::settings, &world::Settings::camera, member>;
Answer entities(const QueryContext& c, View) {
  const world::Entities& all = c.session.document.entities;
  return number(all.size() - all.pool<world::Section>().size());
}

constexpr Query kSessionRows[]{
    {"selected", "", "The selection, such as k4; none if nothing is selected.", selected, or_none(kText)},
    {"selected_t", "", "Selected position on the selected segment, a parameter from 0 to 1.", selected_t, or_none()},
    {"selected_kind", "", "knot, segment, cart or section: what is selected; none if nothing is.", selected_kind,
     or_none(kOneOf<world::EntityKind>)},
    {"selected_count", "", "Number of selected knots or sections; 1 for a segment or a train.", selected_count},
    {"snapping", "", "Dragged knots snap to: off, grid, knots or ground.",
     of_session<&edit::Session::settings, &world::Settings::snapping, &world::Snapping::to>, kOneOf<world::SnapTo>},
    {"undo_label", "", "Name of the next undo step; empty if there is none.", undo_label, kText},
    {"undo_depth", "", "Number of undo steps.", of_session<&edit::Session::history, &edit::History::undo>},
    {"redo_depth", "", "Number of redo steps.", of_session<&edit::Session::history, &edit::History::redo>},
    {"dirty", "", "on if the track has unsaved changes.", dirty, kSwitch},
    {"toast", "", "Text of the newest notice, below the warnings of its command; empty if none is shown.", toast,
     kText},
    {"title", "", "The window's title.", title, kText},
    {"text", kWidget, "", "What a widget shows: its value; of a button or a text without a value, its label.",
     widget_text, kText},
    {"visible", kWidget, "", "on if a widget is in sight and not covered; off if there is none.", visible, kSwitch},
    {"enabled", kWidget, "", "on if a widget can be operated, off if it is greyed out.", enabled, kSwitch},
    {"polyline", "", "on if the evaluated polyline is shown.", polyline, kSwitch},
    {"track_file", "", "Name of the track's file without its folder, empty if it has none.", file, kText},
    {"link_bytes", "", "Characters of the link that was shared last, from its # on; 0: none.", link_bytes},
    {"locked_by", "", "Other process that has the track's file open, empty if none.",
     of_stats<&FrameStats::keeping, &DocumentFileState::holder>, kText},
    {"recoverable", "", "Number of autosaves of other runs that can be recovered.",
     of_stats<&FrameStats::keeping, &DocumentFileState::recoverable>},
    {"autosaves", "", "Number of autosaves written since the start.",
     of_stats<&FrameStats::keeping, &DocumentFileState::autosaves>},
    {"quits", "", "on if the program was asked to quit: a window closes then, a script continues.",
     of_stats<&FrameStats::keeping, &DocumentFileState::quits>, kSwitch},
    {"camera_shown", "", "The camera of the last frame: orbit if there is no train to follow.",
     of_frame<&FrameStats::camera_shown>, or_none(kOneOf<world::CameraMode>)},
    {"camera_eye", "m", "Position of the last frame's camera.", of_frame<&FrameStats::eye>, or_none(kVector)},
    {"camera_height", "m", "Height (y) of the last frame's camera.", camera_height, or_none()},
    {"camera_forward", "", "Direction of the last frame's view.", of_frame<&FrameStats::eye_forward>, or_none(kVector)},
    {"camera_up", "", "Up vector of the last frame's camera.", of_frame<&FrameStats::eye_up>, or_none(kVector)},
    {"camera_tilt", "deg", "Roll of the last frame's view, positive to the right.", camera_tilt, or_none()},
    {"camera_field_of_view", "deg", "Vertical field of view of the last frame.",
     of_frame<&FrameStats::field_of_view_deg>, or_none()},
    {"camera_target", "m", "Target of the camera.", of_camera<&world::Camera::target>, kVector},
    {"camera_distance", "m", "Distance of the camera from its target.", of_camera<&world::Camera::distance>},
    {"camera_yaw", "deg", "Yaw of the camera; 0 looks along -Z.", of_camera<&world::Camera::yaw_deg>},
    {"camera_pitch", "deg", "Pitch of the camera above the horizon.", of_camera<&world::Camera::pitch_deg>},
    {"tick", "", "Number of ticks of 1/120 s since the start.", of_session<&edit::Session::tick>},
    {"entities", "", "Number of knots, segments and trains.", entities},
};

template <auto Member>
Answer setting(const QueryContext& c, View) {
  return value_of(world::value_in<Member>(c.session.settings));
}

// Times and rates are 0 until they are measured.
template <const auto& table, std::size_t row>
Answer number_of_frame(const QueryContext& c, View) {
  const auto& [query, unit, text, member] = table[row];
  const double value = std::visit([&](auto of) { return static_cast<double>(c.stats.*of); }, member);
  if (c.stats.frame == 0 && query != "frame") return none(kNoFrame);
  return value == 0 && (unit == "ms" || unit == "1/s") ? none("it was not measured") : number(value);
}

template <const auto& table, std::size_t... row>
constexpr auto rows_of(std::index_sequence<row...>) {
  return std::array{Query(table[row].query, table[row].unit, table[row].text, number_of_frame<table, row>,
                          table[row].query == "frame" ? ValueDomain{} : or_none())...};
}

// The deviation of the processor, or the one captured from the GPU.
Answer deviation(const QueryContext& c, View) {
  const sim::DerivedTrack& derived = c.session.derived;
  if (derived.order.empty()) return none(kNoSegment);
  if (derived.evaluated_by == curve::EvaluatedBy::processor) return number(derived.deviation);
  return c.stats.frame > 0 && c.stats.deviation_pending == 0 ? number(c.stats.deviation)
                                                             : none("it is not measured yet");
}
Answer chord_error(const QueryContext& c, View) {
  return c.session.derived.order.empty() ? none(kNoSegment) : number(c.find.chord_error());
}
Answer ns_per_point(const QueryContext& c, View) {
  if (c.stats.evaluated_vertices == 0) return none("nothing has been evaluated");
  return number(c.stats.evaluation_ms * 1e6 / static_cast<double>(c.stats.evaluated_vertices));
}

constexpr auto kDrawRows = rows_of<view::kDrawNumbers>(std::make_index_sequence<view::kDrawNumbers.size()>());
constexpr auto kFrameRows = rows_of<kFrameNumbers>(std::make_index_sequence<kFrameNumbers.size()>());
constexpr Query kMoreRows[]{
    {"deviation", "m", "Largest distance of a vertex from the exact point at the same parameter.", deviation,
     or_none()},
    {"chord_error", "m", "Largest distance of a piece of the curve from its chord.", chord_error, or_none()},
    {"drawn_by", "",
     "Where the polylines were evaluated: processor, vertex_shader, geometry_shader or tessellation_shader.",
     of_frame<&FrameStats::drawn_by>, or_none(kOneOf<curve::EvaluatedBy>)},
    {"ns_per_point", "ns", "Time of evaluators per vertex in the last frame that evaluated anything.", ns_per_point,
     or_none()},
};

Answer shown(const QueryContext& c, View word) {
  return yes_no(c.session.settings.lab->layers.has(*base::value_named<world::Layer>(word)));
}

const sim::SegmentShape* selected_shape(const QueryContext& c) {
  return c.session.derived.segments.find(c.session.settings.selected);
}
constexpr View kNoSegmentSelected = "no segment is selected";
Answer construction_point(const QueryContext& c, View) {
  const sim::SegmentShape* const shape = selected_shape(c);
  if (!shape) return none(kNoSegmentSelected);
  return Value(curve::point(shape->key.cubic, c.session.settings.selected_t));
}

// sim::largest or sim::seam of the selected segment's rounding.
template <auto figure>
Answer rounding(const QueryContext& c, View) {
  const sim::SegmentShape* const shape = selected_shape(c);
  const world::Evaluation& evaluation = *c.session.settings.evaluation;
  if (!shape) return none(kNoSegmentSelected);
  return number(figure(sim::rounding(shape->curve, base::row_of(evaluation.evaluator), evaluation.steps)));
}

template <auto step>
constexpr auto of_measurement = of_session<&edit::Session::measuring, &edit::MeasurementState::measurement, step>;

std::vector<std::string> measured_steps() {
  std::vector<std::string> words;
  for (const int steps : sim::kMeasuredSteps) words.push_back(std::to_string(steps));
  return words;
}
constexpr ArgumentPart kMeasured[]{{.usage = "EVALUATOR", .words = base::names_of<curve::EvaluatorId>},
                                   {.usage = "STEPS", .words = measured_steps, .before = '/'}};
// Returns a figure of the measurement of "horner/64".
template <auto member>
Answer measured(const QueryContext& c, View word) {
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

constexpr Query kLabRows[]{
    {"shown", kWordOf<world::Layer>, "", "on if a layer of the laboratory is drawn.", shown, kSwitch},
    {"construction_point", "m", "Point at the selected position of the selected segment; none if none is selected.",
     construction_point, or_none(kVector)},
    {"rounding", "m", "Largest rounding error of the evaluator's vertices on the selected segment.",
     rounding<sim::largest>, or_none()},
    {"seam", "m", "Rounding error of the last vertex before the selected segment's exact end.", rounding<sim::seam>,
     or_none()},
    {"measuring", "", "on during the measurement of evaluators.", of_measurement<&sim::Measurement::running>, kSwitch},
    {"measure.progress", "", "Progress of the measurement, 0 to 1.", of_measurement<sim::progress>},
    {"measure.rows", "", "Number of evaluators measured; 0 before the first measurement.",
     of_measurement<&sim::Measurement::rows>},
    {"measure.error", kMeasured, "m", "Measured largest error over all segments, for example of horner/64.",
     measured<&sim::MeasuredCell::worst_error>, or_none()},
    {"measure.time", kMeasured, "ns", "Measured time per point on the processor, for example of horner/64.",
     measured<&sim::MeasuredCell::ns_per_point>, or_none()},
};

}  // namespace

std::span<const Query> session_rows() { return kSessionRows; }

std::span<const Query> setting_rows() {
  static const std::vector<Query> rows = [] {
    std::vector<Query> made;
    world::for_each_setting([&]<auto Member>() {
      static constexpr world::SettingRow kRow = world::setting_row<Member>();
      made.push_back({kRow.query_name(), kRow.unit, kRow.help, setting<Member>, values_of<world::ValueOf<Member>>()});
    });
    return made;
  }();
  return rows;
}

std::span<const Query> draw_rows() { return kDrawRows; }
std::span<const Query> frame_rows() { return kFrameRows; }
std::span<const Query> evaluation_rows() { return kMoreRows; }
std::span<const Query> lab_rows() { return kLabRows; }

}  // namespace coaster::query
