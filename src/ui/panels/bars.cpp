// The bars at the foot of the window. The status bar: unsaved changes, evaluator and steps, length, speed, g,
// selection, fps, and the last message. The bar of Ride: playback, values, scrubbing, seat, camera and recording.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "edit/commands/commands_ride.h"
#include "ui/context/query_widgets.h"
#include "ui/context/setting_widgets.h"
#include "ui/panels/panels.h"
#include "ui/tools/camera_controls.h"
#include "ui/tools/show_places.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/theme.h"
#include "world/laboratory_settings.h"
#include "world/sections.h"

namespace coaster::ui {
namespace {

struct StatusPart {
  std::string label, value;
  std::string_view tooltip;
  float cell;  // design px reserved for the value, so that neighbours do not move
};

std::string real(const Ui& ui, std::string_view name, int decimals, const char* unit) {
  const auto number = number_of(ui, name);
  return number ? measured(ui, *number, decimals, unit) : "--";
}

// Returns "Climb" for a section, "3 sections" or "4 knots" for several, else the name.
std::string selection_text(const edit::Session& session) {
  const world::Entity selected = session.settings.selected;
  const auto* const section = session.document.entities.find<world::Section>(selected);
  if (!session.settings.also.empty())
    return fmt::format("{} {}", session.settings.also.size() + 1, section ? "sections" : "knots");
  return section ? world::title_of(*section) : world::label_of(session.document, selected);
}

std::vector<StatusPart> parts(const Ui& ui) {
  const edit::Session& session = ui.session();
  const double fps = ui.state.stats.fps;
  const bool timed = !ui.state.scripted && fps > 0;
  return {{"Length", real(ui, "length", 1, "m"), "Length of the track, by the method selected in Evaluation.", 76},
          {"Speed", real(ui, "ride.speed", 1, "m/s"), "Speed of the first train.", 68},
          {"g", real(ui, "ride.g_up", 1, "g"), "Felt g towards the rider's head, not low-passed.", 40},
          {"Selection", selection_text(session), "The selection.", 36},
          {"fps", timed ? fixed(fps, 0) : "--", "Frames per second.", 28}};
}

// Position of the next part of the bar.
struct StatusBarRow {
  Ui& ui;
  ImDrawList& list;
  float top, bottom, text_top;  // px
  float x, right;
  float between;

  void draw(std::string_view words, std::uint32_t tint, float at) const {
    draw_text(list, {at, text_top}, tint, words);
  }
  void place(std::string_view label, std::string_view tooltip, std::string value, float from, float to) const {
    note(ui, label, "label", tooltip, true, std::move(value), {from, top}, {to, bottom});
  }
};

void unsaved_mark(StatusBarRow& bar) {
  const bool unsaved = edit::dirty(bar.ui.find);
  const bool none = bar.ui.session().file.path.empty();  // it has no file
  const std::string_view word = unsaved ? (none ? "not saved yet" : "unsaved") : none ? "no file" : "saved";
  const std::string mark = unsaved ? fmt::format("\u25CF {}", word) : std::string(word);
  bar.draw(mark, unsaved ? palette().warning : palette().dim, bar.x);
  const float end = bar.x + std::max(text_size(mark).x, text_size("\u25CF unsaved").x);
  bar.place("Unsaved", "Whether the track's file has all of it.", std::string(word), bar.x, end);
  bar.x = end + bar.between;
}

// Shows the evaluator and its steps. A click opens the list of all evaluators.
void evaluator(StatusBarRow& bar) {
  Ui& ui = bar.ui;
  constexpr const char* kList = "##evaluators";
  const world::Evaluation& now = *ui.session().settings.evaluation;
  const std::string_view label = curve::evaluators()[static_cast<std::size_t>(now.evaluator)].label;
  const std::string words = fmt::format("{}, {} steps", label, now.steps);
  const float arrow = std::floor(16 * ui.scale);
  const ImVec2 low(bar.x, bar.top), high(bar.x + text_size(words).x + arrow, bar.bottom);
  if (high.x > bar.right) return;
  ImGui::SetCursorScreenPos(low);
  if (ImGui::InvisibleButton("##evaluator", sized({high.x - low.x, high.y - low.y}))) ImGui::OpenPopup(kList);
  const bool open = ImGui::IsPopupOpen(kList);
  const float pad = std::floor(4 * ui.scale);
  if (open || ImGui::IsItemHovered())
    bar.list.AddRectFilled({low.x - pad, low.y}, {high.x + pad, high.y}, packed(palette().field));
  bar.draw(words, palette().text, low.x);
  draw_fold_mark(bar.list, {high.x - arrow * 0.5f, (low.y + high.y) * 0.5f}, ui.scale, open);
  const std::string help = with_keys(ui.keys, "Evaluator and steps per segment. Click to choose.", "Next evaluator");
  note(ui, "Evaluator", "combo", open ? "" : help, true, words, low, high);
  bar.x = high.x + bar.between;
  if (!open) return;
  const ImVec2 padding(std::floor(10 * ui.scale), std::floor(8 * ui.scale));
  ImGui::SetNextWindowPos({low.x - pad, low.y}, ImGuiCond_Always, {0, 1});
  ImGui::SetNextWindowSize({sized(std::floor(320 * ui.scale)), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  if (ImGui::BeginPopup(kList)) {
    ui.panel = "Status/Evaluator";
    evaluator_choice(ui);
    steps_slider(ui);
    ui.panel = "Status";
    ImGui::EndPopup();
  }
  ImGui::PopStyleVar();
}

void values(StatusBarRow& bar) {
  const float gap = std::floor(6 * bar.ui.scale);
  for (const StatusPart& part : parts(bar.ui)) {
    const float value_width = std::max(text_size(part.value).x, std::floor(part.cell * bar.ui.scale));
    const float end = bar.x + text_size(part.label).x + gap + value_width;
    if (end > bar.right) return;
    labelled_value(bar.ui, part.label, part.value, part.tooltip, {bar.x, bar.top}, {end, bar.bottom});
    bar.x = end + bar.between;
  }
}

// Shows the last message after its toast is gone, shortened to fit.
void message(const StatusBarRow& bar) {
  const auto& notices = bar.ui.session().notices.list;
  if (notices.empty() || bar.right - bar.x <= 60 * bar.ui.scale) return;
  const edit::Notice& last = notices.back();
  const std::uint32_t tint = last.kind == edit::NoticeKind::error     ? palette().error
                             : last.kind == edit::NoticeKind::warning ? palette().warning
                                                                      : palette().dim;
  const std::string text = in_units(bar.ui, last.text), words = shortened(text, bar.right - bar.x);
  const float left = bar.right - text_size(words).x;
  bar.draw(words, tint, left);
  bar.place("Message", text, text, left, bar.right);
}

// Lays out the parts of the bar from left to right, all as high as a frame.
struct RideRow {
  Ui& ui;
  float x, y, right, gap;  // px

  // Places the next part, `width` px wide, and returns its width.
  float place(float width) {
    ImGui::SetCursorScreenPos({x, y});
    x += width + gap;
    return width;
  }
  float scaled(float design) const { return std::floor(design * ui.scale); }
};

void buttons(RideRow& row) {
  Ui& ui = row.ui;
  const bool any = rideable(ui.session()), running = ui.session().motion.state == world::RideState::running;
  const auto control = [&](const VectorIcon& icon, std::string_view label, std::string_view help,
                           std::string_view action) {
    const float width = row.place(row.scaled(78));
    return icon_button(ui, icon, label, with_keys(ui.keys, help, action), any, width);
  };
  if (running) {
    if (control(kPauseIcon, "Pause", "Pause the ride.", "Play or pause")) ui.emit(edit::RidePause{});
  } else if (control(kPlayIcon, "Play", "Start or resume the ride.", "Play or pause")) {
    ui.emit(edit::RideStart{});
  }
  if (control(kResetIcon, "Reset", "Return the trains to their start.", "Reset")) ui.emit(edit::RideStop{});
}

constexpr std::string_view kVertical = "Vertical g###g up";

// Shows a value that does not move when its digits change.
void value(RideRow& row, std::string_view label, std::string_view number, float cell, std::string_view tooltip) {
  const float left = row.x, width = text_size(shown(label)).x + row.scaled(6) + row.scaled(cell);
  row.place(width);
  labelled_value(row.ui, label, number, tooltip, {left, row.y}, {left + width, row.y + ImGui::GetFrameHeight()});
}

// Returns the seconds from the start of the simulated ride to the train's position in it, and of the whole ride.
std::string ride_time(const Ui& ui) {
  const edit::Session& session = ui.session();
  const world::TrainMotion* const train = session.motion.carts.find(edit::chosen_cart(session));
  const sim::SimulatedRide* const ride = ui.find.ride();
  if (train == nullptr || ride == nullptr) return "--";
  const double way = sim::within_lap(train->track_distance - ride->start.front, ride->track_length, ride->closed);
  const auto at = std::find_if(ride->samples.begin(), ride->samples.end(),
                               [&](const sim::RideSample& sample) { return sample.travelled >= way; });
  const double seconds = static_cast<double>(at - ride->samples.begin()) * world::kTick;
  return fmt::format("{} / {} s", fixed(std::min(seconds, ride->seconds()), 1), fixed(ride->seconds(), 1));
}

// Returns the room for a speed in the user's unit, design px: km/h have more digits.
float speed_cell(const Ui& ui) { return std::max(64.0f, text_size(measured(ui, 99, 1, "m/s")).x / ui.scale); }

void values(RideRow& row) {
  Ui& ui = row.ui;
  value(row, "Speed", real(ui, "ride.speed", 1, "m/s"), speed_cell(ui), "Speed of the first train along the track.");
  value(row, kVertical, real(ui, "ride.g_up", 2, "g"), 48, "Felt g towards the rider's head, not low-passed.");
  value(row, "Height", real(ui, "ride.height", 1, "m"), 56, "Height of the first train above the ground.");
  value(row, "Time", ride_time(ui), 96, "Time since the start of the ride, and of the whole ride.");
}

// The scrub slider, from start to end of the track.
void scrub(RideRow& row, float width) {
  Ui& ui = row.ui;
  const edit::Session& session = ui.session();
  const world::TrainMotion* const train = session.motion.carts.find(edit::chosen_cart(session));
  float at = train != nullptr ? static_cast<float>(train->track_distance) : 0;
  const bool any = train != nullptr && rideable(session);
  const float length = std::max(0.1f, static_cast<float>(session.derived.length));
  ImGui::SetNextItemWidth(sized(row.place(width)));
  ImGui::BeginDisabled(!any);
  const std::string shown = measured(ui, at, 1, "m");
  const bool moved = ImGui::SliderFloat("##scrub", &at, 0, length, shown.c_str(),
                                        ImGuiSliderFlags_NoInput | ImGuiSliderFlags_AlwaysClamp);
  ImGui::EndDisabled();
  note_item(ui, "Place", "slider", "Place of the train along the track. Drag to move it there.", any, shown);
  if (moved && any) ui.emit(edit::RideSeek{at});
}

// A list in a separate part of the bar: its row begins there.
template <class Build>
void list_in(RideRow& row, const char* id, float width, Build build) {
  row.place(width);
  if (ImGui::BeginChild(id, sized({width, ImGui::GetFrameHeight()}), false, ImGuiWindowFlags_NoScrollbar)) build();
  ImGui::EndChild();
}

void camera_list(Ui& ui) {
  if (const auto to = combo_of(ui, "Camera", ui.session().settings.camera_mode,
                               with_keys(ui.keys, "The camera.", "Next camera"), ComboPlace::in_bar))
    choose_camera(ui, *to);
}

constexpr float kSeatWidth = 164, kCameraWidth = 148;  // design px, with their labels

// Shows the lists, at most as wide as both fit in the row.
void lists(RideRow& row) {
  Ui& ui = row.ui;
  constexpr float kSeatShare = 0.51f;  // both lists show their words whole
  const float room = row.right - row.x - row.gap,
              seat = std::min(row.scaled(kSeatWidth), std::floor(kSeatShare * room));
  const float camera = std::min(row.scaled(kCameraWidth), std::floor(room - seat));
  list_in(row, "##seat", seat, [&] {
    setting_list<&world::LabView::seat>(ui, "Seat", "Seat whose ride the force graph and the laboratory show.",
                                        ComboPlace::in_bar);
  });
  list_in(row, "##camera", camera, [&] { camera_list(ui); });
}

void record(RideRow& row) {
  Ui& ui = row.ui;
  const bool filming = ui.state.movie != nullptr;
  const std::string help =
      with_keys(ui.keys, filming ? "Stop recording." : "Record one lap as a movie.", "Record movie");
  const float width = row.place(row.scaled(86));
  if (icon_button(ui, filming ? kStopIcon : kRecordIcon, filming ? "Stop" : "Record", help,
                  filming || rideable(ui.session()), width))
    ui.out.movie = filming ? MovieRequest::stop : MovieRequest::start;
}

// Returns the total width of the parts next to the scrub slider.
float fixed_width(const RideRow& row, bool two_rows) {
  const float first = 2 * (row.scaled(78) + row.gap) + row.scaled(86) + row.gap;
  if (two_rows) return first;
  float labels = 0;
  for (const std::string_view label :
       std::initializer_list<std::string_view>{"Speed", shown(kVertical), "Height", "Time"})
    labels += text_size(label).x + row.scaled(6) + row.gap;
  return first + labels + row.scaled(speed_cell(row.ui) + 48 + 56 + 96) + row.scaled(kSeatWidth) +
         row.scaled(kCameraWidth) + 2 * row.gap;
}

}  // namespace

void build_status_bar(Ui& ui, const view::Viewport& area) {
  build_area(ui, area, {.id = "##status", .panel = "Status", .raised = true}, [&] {
    const float pad = std::floor(10 * ui.scale);
    StatusBarRow bar{ui,
                     *ImGui::GetWindowDrawList(),
                     area.y,
                     area.y + area.height,
                     std::floor(area.y + (area.height - ImGui::GetTextLineHeight()) * 0.5f),
                     area.x + pad,
                     area.x + area.width - pad,
                     std::floor(18 * ui.scale)};
    unsaved_mark(bar);
    evaluator(bar);
    values(bar);
    message(bar);
  });
}

void build_ride_bar(Ui& ui, const view::Viewport& area) {
  build_area(ui, area, {.id = "##ride", .panel = "Ride", .raised = true}, [&] {
    const float pad = std::floor(10 * ui.scale), bar = ImGui::GetFrameHeight();
    const bool two_rows = area.height > 2 * bar;
    const float above = std::floor((area.height - (two_rows ? 2 : 1) * bar) / (two_rows ? 3 : 2));
    RideRow row{ui, area.x + pad, area.y + above, area.x + area.width - pad, std::floor(12 * ui.scale)};
    const float room = row.right - row.x - fixed_width(row, two_rows);
    buttons(row);
    if (!two_rows) values(row);
    scrub(row, std::max(room, row.scaled(40)));
    if (two_rows) {
      record(row);
      row.x = area.x + pad, row.y += bar + above;
      values(row);
      lists(row);
    } else {
      lists(row);
      record(row);
    }
  });
}

}  // namespace coaster::ui
