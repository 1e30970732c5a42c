// Queries of the session: settings, selection, history, the camera, the cost of the last frame.
#include <array>
#include <cmath>

#include "query/rows.h"
#include "sim/shape/frame_methods.h"
#include "world/lab_view.h"
#include "world/selection.h"

namespace coaster::query {
namespace {

Answer selected(const Context& c, View) {
  const world::Entity e = c.session.settings.selected;
  const bool any = c.session.document.entities.find<world::Name>(e) != nullptr;
  return any ? text(world::label_of(c.session.document, e)) : none(kNothingSelected);
}
Answer selected_kind(const Context& c, View) {
  const auto* const name = c.session.document.entities.find<world::Name>(c.session.settings.selected);
  return name ? value_of(name->kind) : none(kNothingSelected);
}
Answer selected_t(const Context& c, View) {
  const bool segment = c.session.derived.segments.contains(c.session.settings.selected);
  return segment ? number(c.session.settings.selected_t) : none("no segment is selected");
}
Answer selected_count(const Context& c, View) {
  const std::size_t several = world::selected_knots(c.session.document, c.session.settings).size() +
                              world::selected_sections(c.session.document, c.session.settings).size();
  return number(several > 0 ? several : c.session.settings.selected.valid() ? 1 : 0);
}
Answer undo_label(const Context& c, View) {
  return text(c.session.history.undo.empty() ? "" : c.session.history.undo.back().text.command);
}
Answer snapping(const Context& c, View) { return text(base::name_of(c.session.settings.snapping.to)); }
Answer undo_depth(const Context& c, View) { return number(c.session.history.undo.size()); }
Answer redo_depth(const Context& c, View) { return number(c.session.history.redo.size()); }
Answer dirty(const Context& c, View) { return yes_no(edit::dirty(c.find)); }
Answer toast(const Context& c, View) { return text(c.toast); }
base::Result<Widget> widget(const Context& c, View path) {
  return c.widget ? c.widget(path) : base::Status{base::Code::refused, "there are no panels"};
}
Answer widget_text(const Context& c, View path) {
  const auto found = widget(c, path);
  return found ? Answer(text(found->text())) : found.status();
}
Answer enabled(const Context& c, View path) {
  const auto found = widget(c, path);
  return found ? Answer(yes_no(found->enabled)) : found.status();
}
// Off has the reason as its text.
Answer visible(const Context& c, View path) {
  const auto found = widget(c, path);
  if (!found && (!c.widget || found.status().code != base::Code::refused)) return found.status();
  const std::string why = !found           ? found.status().message
                          : found->covered ? "covered by another window"
                                           : "out of sight";
  return found && found->visible && !found->covered ? yes_no(true) : Ranked{0, why};
}
constexpr ArgumentPart kWidget[]{{.usage = "\"PATH\""}};
Answer title(const Context& c, View) { return text(c.title); }
Answer polyline(const Context& c, View) { return yes_no(c.session.settings.lab->layers.has(world::Layer::polyline)); }
Answer link_bytes(const Context& c, View) { return number(c.session.shared.size()); }
Answer file(const Context& c, View) { return text(c.session.file.path.filename().string()); }

Answer camera_height(const Context& c, View) { return c.stats.frame > 0 ? number(c.stats.eye.y) : none(kNoFrame); }
Answer camera_tilt(const Context& c, View) {
  if (c.stats.frame == 0) return none(kNoFrame);
  // Roll of the picture's horizontal against the ground, clockwise as the rider tilts to the right.
  const double right = glm::cross(c.stats.eye_forward, c.stats.eye_up).y;
  return number(glm::degrees(std::atan2(-right, c.stats.eye_up.y)));
}
Answer camera_target(const Context& c, View) { return Value(glm::dvec3(c.session.settings.camera.target)); }
Answer camera_distance(const Context& c, View) { return number(c.session.settings.camera.distance); }
Answer camera_yaw(const Context& c, View) { return number(c.session.settings.camera.yaw_deg); }
Answer camera_pitch(const Context& c, View) { return number(c.session.settings.camera.pitch_deg); }

Answer tick(const Context& c, View) { return number(c.session.tick); }
Answer entities(const Context& c, View) {
  const world::Entities& all = c.session.document.entities;
  return number(all.size() - all.pool<world::Section>().size());
}

constexpr std::array kSessionRows{
    Query{"selected", kNoArgument, "", "The selection, such as k4; none if nothing is selected.", selected,
          or_none(kText)},
    Query{"selected_t", kNoArgument, "", "Selected position on the selected segment, a parameter from 0 to 1.",
          selected_t, or_none()},
    Query{"selected_kind", kNoArgument, "", "knot, segment, cart or section: what is selected; none if nothing is.",
          selected_kind, or_none(kOneOf<world::Kind>)},
    Query{"selected_count", kNoArgument, "", "Number of selected knots or sections; 1 for a segment or a train.",
          selected_count},
    Query{"snapping", kNoArgument, "", "Dragged knots snap to: off, grid, knots or ground.", snapping,
          kOneOf<world::SnapTo>},
    Query{"undo_label", kNoArgument, "", "Name of the next undo step; empty if there is none.", undo_label, kText},
    Query{"undo_depth", kNoArgument, "", "Number of undo steps.", undo_depth},
    Query{"redo_depth", kNoArgument, "", "Number of redo steps.", redo_depth},
    Query{"dirty", kNoArgument, "", "on if the track has unsaved changes.", dirty, kSwitch},
    Query{"toast", kNoArgument, "",
          "Text of the newest notice, below the warnings of its command; empty if none is shown.", toast, kText},
    Query{"title", kNoArgument, "", "The window's title.", title, kText},
    Query{"text", kWidget, "", "What a widget shows: its value; of a button or a text without a value, its label.",
          widget_text, kText},
    Query{"visible", kWidget, "", "on if a widget is in sight and not covered; off if there is none.", visible,
          kSwitch},
    Query{"enabled", kWidget, "", "on if a widget can be operated, off if it is greyed out.", enabled, kSwitch},
    Query{"polyline", kNoArgument, "", "on if the evaluated polyline is shown.", polyline, kSwitch},
    Query{"track_file", kNoArgument, "", "Name of the track's file without its folder, empty if it has none.", file,
          kText},
    Query{"link_bytes", kNoArgument, "", "Characters of the link that was shared last, from its # on; 0: none.",
          link_bytes},
    Query{"locked_by", kNoArgument, "", "Other process that has the track's file open, empty if none.",
          of_stats<&FrameStats::keeping, &Keeping::holder>, kText},
    Query{"recoverable", kNoArgument, "", "Number of autosaves of other runs that can be recovered.",
          of_stats<&FrameStats::keeping, &Keeping::recoverable>},
    Query{"autosaves", kNoArgument, "", "Number of autosaves written since the start.",
          of_stats<&FrameStats::keeping, &Keeping::autosaves>},
    Query{"quits", kNoArgument, "", "on if the program was asked to quit: a window closes then, a script continues.",
          of_stats<&FrameStats::keeping, &Keeping::quits>, kSwitch},
    Query{"camera_shown", kNoArgument, "", "The camera of the last frame: orbit if there is no train to follow.",
          of_frame<&FrameStats::camera_shown>, or_none(kOneOf<world::CameraMode>)},
    Query{"camera_eye", kNoArgument, "m", "Position of the last frame's camera.", of_frame<&FrameStats::eye>,
          or_none(kVector)},
    Query{"camera_height", kNoArgument, "m", "Height of the last frame's camera above the ground.", camera_height,
          or_none()},
    Query{"camera_forward", kNoArgument, "", "Direction of the last frame's view.", of_frame<&FrameStats::eye_forward>,
          or_none(kVector)},
    Query{"camera_up", kNoArgument, "", "Up vector of the last frame's camera.", of_frame<&FrameStats::eye_up>,
          or_none(kVector)},
    Query{"camera_tilt", kNoArgument, "deg", "Roll of the last frame's view, positive to the right.", camera_tilt,
          or_none()},
    Query{"camera_field_of_view", kNoArgument, "deg", "Vertical field of view of the last frame.",
          of_frame<&FrameStats::field_of_view_deg>, or_none()},
    Query{"camera_target", kNoArgument, "m", "Target of the camera.", camera_target, kVector},
    Query{"camera_distance", kNoArgument, "m", "Distance of the camera from its target.", camera_distance},
    Query{"camera_yaw", kNoArgument, "deg", "Yaw of the camera; 0 looks along -Z.", camera_yaw},
    Query{"camera_pitch", kNoArgument, "deg", "Pitch of the camera above the horizon.", camera_pitch},
    Query{"tick", kNoArgument, "", "Number of ticks of 1/120 s since the start.", tick},
    Query{"entities", kNoArgument, "", "Number of knots, segments and trains.", entities},
};

}  // namespace

std::span<const Query> session_rows() { return kSessionRows; }

}  // namespace coaster::query
