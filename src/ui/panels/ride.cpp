// Operation: equipment on the selected segment, the train, losses, the track's curve, and what ends the ride. Ride:
// controls of the ride, motion of the trains, and g. Camera: camera mode and camera feel.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "edit/commands/commands_operation.h"
#include "edit/commands/commands_ride.h"
#include "sim/shape/frame_methods.h"
#include "sim/study/riders.h"
#include "ui/context/query_widgets.h"
#include "ui/context/setting_widgets.h"
#include "ui/panels/element_equipment_fields.h"
#include "ui/tools/camera_controls.h"
#include "ui/tools/show_places.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/theme.h"
#include "view/marks.h"

namespace coaster::ui {
namespace {

using world::CameraFeel;

// Returns the selected segment, those between neighbouring selected knots, or else the one that starts at the active
// knot.
std::vector<world::Entity> chosen_segments(const edit::Session& session) {
  const world::Document& document = session.document;
  const world::Entity selected = session.settings.selected;
  if (document.entities.find<world::Segment>(selected)) return {selected};
  if (!document.entities.find<world::Knot>(selected)) return {};
  std::vector<world::Entity> between;
  if (!session.settings.also.empty()) {
    const view::SelectionLookup chosen(session.settings);
    for (const world::Entity e : document.track.segments)
      if (const world::Segment& s = world::segment(document, e); chosen(s.from) && chosen(s.to)) between.push_back(e);
  }
  if (!between.empty()) return between;
  const world::Entity after = world::neighbours(document, selected).after;
  return after.valid() ? std::vector{after} : between;
}

void equipment(Ui& ui) {
  const world::Document& document = ui.session().document;
  const std::vector<world::Entity> segments = chosen_segments(ui.session());
  heading(ui, "Equipment",
          segments.empty() ? "Select a segment to place a station, lift, launch, brake or block."
                           : "Equipment on the selected segments.");
  equipment_form(ui, segments, edit::SetEquipment::kInfo.name, [&](const std::optional<world::Equipment>& to) {
    ui.emit_each(segments, [&](world::Entity e) {
      const world::EntityName name = world::name_of(document, e);
      if (to) ui.emit(edit::SetEquipment{{name}, *to});
      else if (document.entities.find<world::Equipment>(e)) ui.emit(edit::RemoveEquipment{{name}});
    });
  });
}

void train(Ui& ui) {
  const edit::Session& session = ui.session();
  const world::Entity cart = edit::chosen_cart(session);
  const world::Train* const design = session.document.entities.find<world::Train>(cart);
  if (!design) return;
  const world::EntityName name = world::name_of(session.document, cart);
  if (const auto to =
          number(ui, "Cars", whole_number(design->cars, 1, world::kMaxCars), "Number of cars. They move as one."))
    ui.emit(edit::SetTrain{{name}, static_cast<int>(*to)});
  const auto field = [&](const char* label, const Number& value, float edit::SetTrain::*part, const char* tooltip) {
    const auto to = number(ui, label, value, tooltip);
    if (!to) return;
    edit::SetTrain set{{name}, design->cars};
    set.*part = static_cast<float>(*to);
    ui.emit(set);
  };
  field("Spacing",
        {.value = design->spacing, .unit = "m", .step = 0.02, .low = world::kMinSpacing, .high = world::kMaxSpacing},
        &edit::SetTrain::spacing, "Distance between the centres of neighbouring cars.");
  field("Car length",
        {.value = design->length, .unit = "m", .step = 0.02, .low = world::kMinCarLength, .high = world::kMaxCarLength},
        &edit::SetTrain::length, "Length of a car's body. Trains collide where bodies touch. At most the spacing.");
  field("Car mass",
        {.value = design->mass,
         .unit = "kg",
         .decimals = 0,
         .step = 0.5,
         .low = world::kMinCarMass,
         .high = world::kMaxCarMass,
         .largest = 1e6},
        &edit::SetTrain::mass, "Mass including riders. Drag is given for 500 kg; heavier cars slow down less.");
}

void loss_set(Ui& ui) {
  const LockedWidgets locked(ui, edit::SetLossSet::kInfo.name);
  ui.emit_if<edit::SetLossSet>(combo_of(ui, "Losses", world::loss_set_of(ui.session().document.resistance),
                                        {"Own", "The numbers below."}, "Sets rolling friction and drag together."));
}

void track_curve(Ui& ui) {
  const world::Document& document = ui.session().document;
  const bool rails = document.curve == world::TrackCurve::rails;
  read_out(ui, "Curve", std::string(base::row_of(document.curve).label), "",
           std::string(base::row_of(document.curve).help));
  const std::string_view other = rails ? "heartline" : "rails";
  const auto offer = [&](std::string_view label, edit::CurveSwitchKeeps keep, std::string_view effect) {
    if (wide_button(ui, label, fmt::format("Make the curve the {}. {}", other, effect)))
      ui.emit(edit::SetCurve{rails ? world::TrackCurve::heartline : world::TrackCurve::rails, keep});
  };
  offer("Switch, keep rails", edit::CurveSwitchKeeps::rails, "The rails keep their shape within 1 cm.");
  offer("Switch, keep numbers", edit::CurveSwitchKeeps::numbers, "The knots keep their numbers, and the rails move.");
}

void loss_numbers(Ui& ui) {
  const world::Losses& now = ui.session().document.resistance;
  const LockedWidgets locked(ui, edit::SetLosses::kInfo.name);
  if (const auto to = number(
          ui, "Rolling", {.value = now.rolling, .decimals = 4, .step = 0.0002, .low = 0, .high = world::kMaxRolling},
          "Rolling friction coefficient. Steel coasters: 0.02 to 0.03. 0: none."))
    ui.emit(edit::SetLosses{static_cast<float>(*to), now.drag});
  if (const auto to =
          number(ui, "Drag",
                 {.value = now.drag, .unit = "1/m", .decimals = 6, .step = 0.000002, .low = 0, .high = world::kMaxDrag},
                 "Drag coefficient: deceleration divided by v\u00B2. About 0.00002."))
    ui.emit(edit::SetLosses{now.rolling, static_cast<float>(*to)});
}

void losses(Ui& ui) {
  const world::Document& document = ui.session().document;
  loss_set(ui);
  loss_numbers(ui);
  const Number heartline{.value = document.heartline,
                         .unit = "m",
                         .step = 0.01,
                         .low = -world::kMaxHeartline,
                         .high = world::kMaxHeartline};
  ui.emit_if<edit::SetHeartline>(
      number(ui, "Heartline", heartline, "Height of the riders' hearts above the rails. Forces are computed there."));
  track_curve(ui);
  ui.emit_if<edit::SetRollbackFails>(
      checkbox(ui, "Rollback ends the ride", document.rollback_fails, "The ride fails when a train rolls back 2 m."));
}

void controls(Ui& ui) {
  const edit::Session& session = ui.session();
  const bool any = rideable(session);
  const world::RideState state = session.motion.state;
  const bool running = state == world::RideState::running;
  // Four in a row, or where the longest label finds no room there two.
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x, room = ImGui::GetContentRegionAvail().x;
  const float needed = text_size("Pause").x + 1.1f * ImGui::GetTextLineHeight();
  const int columns = (room - 3 * gap) / 4 >= needed ? 4 : 2;
  const float width = std::floor((room - static_cast<float>(columns - 1) * gap) / static_cast<float>(columns));
  int place = 0;
  const auto control = [&](const VectorIcon& icon, std::string_view label, std::string_view help,
                           std::string_view action, bool enabled) {
    if (place++ % columns != 0) ImGui::SameLine(0, gap);
    return icon_button(ui, icon, label, with_keys(ui.keys, help, action), enabled, width);
  };
  if (control(kPlayIcon, "Play", "Start or resume the ride.", "Play or pause", any && !running))
    ui.emit(edit::RideStart{});
  if (control(kPauseIcon, "Pause", "Pause the ride.", "Play or pause", any && running)) ui.emit(edit::RidePause{});
  const bool steppable = any && (state == world::RideState::paused || state == world::RideState::stopped);
  if (control(kStepIcon, "Step", "Advance a paused ride by one tick of 1/120 s.", "Single step", steppable))
    ui.emit(edit::RideStep{1});
  if (control(kResetIcon, "Reset", "Return the trains to their start.", "Reset", any)) ui.emit(edit::RideStop{});
}

void read_outs(Ui& ui) {
  read_query(ui, "State", "ride.state", "Stopped at the start, running, paused, ended at an open end, or failed.");
  if (ui.session().motion.failure.kind != world::FailureKind::none)
    read_query(ui, "Reason###Because it", "ride.fail", "Why the ride ended.");
  read_query(ui, "Speed", "ride.speed", "Speed of the first train along the track.");
  read_query(ui, "Height", "ride.height", "Height of the first train above the ground.");
  read_query(ui, "Distance", "ride.distance", "Distance of the first train from the start of the track.");
  read_query(ui, "Lap", "ride.lap", "Laps completed since the start.", {.decimals = 0});
  read_query(ui, "Energy", "ride.energy", "v\u00B2/2 + g (y - datum), per kilogram.", {.decimals = 3});
  read_query(ui, "Energy drift", "ride.energy_drift",
             "Change of energy since the start, relative to peak kinetic energy: the integrator's error.",
             {.decimals = 4, .unit = "ppm", .factor = 1e6});
  // Scripts and pictures show no times.
  const double cost = ui.session().measuring.ride_cost.ns_per_tick;
  read_out(ui, "Cost per tick", !ui.state.scripted && cost > 0 ? fixed(cost, 0) : "--", "ns",
           "Average time of a tick on this machine, for all trains, with the selected integrator.");
  read_query(ui, "Vertical g###g up", "ride.g_up",
             "Felt g towards the rider's head, not low-passed. 1 at rest on level track.", {.unit = "g"});
  read_query(ui, "Lateral g###g side", "ride.g_side", "Felt g to the side, not low-passed.", {.unit = "g"});
  read_query(ui, "Longitudinal g###g forward", "ride.g_forward", "Felt g forwards, not low-passed.", {.unit = "g"});
}

// Shows text at the right edge of the next cell.
void right_cell(std::string_view words, std::uint32_t rgb) {
  ImGui::TableNextColumn();
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(ImGui::GetContentRegionAvail().x - text_size(words).x, 0.0f));
  tinted_line(words, rgb);
}

// Shows the loads of the first car's wheels: a row for each side of a bogie.
void wheel_table(Ui& ui) {
  using sim::WheelSet;
  const edit::Session& session = ui.session();
  const world::Entity train = edit::chosen_cart(session);
  const world::TrainMotion* const motion = session.motion.carts.find(train);
  if (motion == nullptr || !session.derived.segments.contains(motion->segment)) return;
  const sim::WheelLoads loads = sim::wheel_loads(session.document, session.derived, train, *motion);
  heading(ui, "Wheel loads (kN)",
          "Loads of the first car's wheels. Up-stop wheels run under the rails and carry where riders are lifted.");
  if (!ImGui::BeginTable("##wheels", 4, ImGuiTableFlags_SizingStretchProp)) return;
  ImGui::TableNextColumn();
  for (const std::string_view kind : {"Road", "Up-stop", "Side"}) right_cell(kind, palette().dim);
  for (const WheelSet set : {WheelSet::front_left, WheelSet::front_right, WheelSet::rear_left, WheelSet::rear_right}) {
    const std::string_view label = base::row_of(set).label;
    const sim::LoadsByWheelKind wheels = loads.of(set);
    ImGui::TableNextColumn();
    tinted_line(label, palette().dim);
    const std::string words[] = {digits(ui, wheels.road, 1, "kN"), digits(ui, wheels.up_stop, 1, "kN"),
                                 digits(ui, wheels.side, 1, "kN")};
    note_item(ui, label, "label", "Load of the road wheels, up-stop wheels and side wheels.", true,
              fmt::format("{}", fmt::join(words, " ")));
    for (const std::string& load : words) right_cell(load, palette().text);
  }
  ImGui::EndTable();
}

void ride_methods(Ui& ui) {
  heading(ui, "Frame method", "Frames that orient trains and the ride camera. The knots define the bank of the track.");
  const auto rows = sim::frame_methods();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto method = static_cast<world::FrameMethod>(i);
    if (radio(ui, rows[i].label, ui.session().settings.frames == method, rows[i].formula))
      ui.emit(edit::Set<&world::Settings::frames>{method});
  }
  setting_list<&world::Settings::integrator>(ui, "Integrator",
                                             "Integration method of speed and position, per tick of 1/120 s.");
}

// Mode and tooltip; "MODE camera" is the action that selects it.
constexpr std::array<std::pair<const char*, const char*>, 4> kModes{{
    {"Orbit", "Orbits a point. Drag empty space to orbit, middle button to pan, wheel to zoom."},
    {"Ride", "The view from a seat of the first train, 1.1 m above the rails."},
    {"Chase", "Follows the first train from behind and above. The wheel sets the distance."},
    {"Fly", "W A S D to fly, Q down, E up, Shift faster. Drag to look around."},
}};

}  // namespace

void operation_panel(Ui& ui) {
  equipment(ui);
  train(ui);
  losses(ui);
}

void ride_panel(Ui& ui) {
  controls(ui);
  read_outs(ui);
  wheel_table(ui);
  ride_methods(ui);
}

void camera_panel(Ui& ui) {
  const world::Settings& settings = ui.session().settings;
  for (std::size_t i = 0; i < kModes.size(); ++i) {
    const auto mode = static_cast<world::CameraMode>(i);
    const auto& [label, tooltip] = kModes[i];
    if (i > 0) (void)beside_last(ui, label);
    if (radio(ui, label, settings.camera_mode == mode, with_keys(ui.keys, tooltip, std::string(label) + " camera")))
      choose_camera(ui, mode);
  }
  const bool rides = settings.camera_mode == world::CameraMode::ride;
  if (rides)
    setting_slider<&CameraFeel::ride_view_deg>(ui, "Field of view", 0,
                                               "Vertical field of view of the rider, in degrees.");
  else
    setting_slider<&world::Camera::field_of_view_deg>(
        ui, "Field of view", 0, "Vertical field of view of the orbit, chase and fly cameras, in degrees.");
  setting_slider<&CameraFeel::roll_damping>(ui, "Roll damping", 2, "Lag of the rider's roll, 0 to 2 s. 0: no lag.");
  setting_slider<&CameraFeel::widening_deg>(ui, "Widening", 0,
                                            "Widening of the rider's field of view at 30 m/s, 0 to 20 degrees.");
  setting_slider<&CameraFeel::chase_distance>(
      ui, "Chase distance", 0, "Distance of the chase camera from a single car, 5 to 60 m. Longer trains add to it.");
  setting_box<&CameraFeel::head_bob>(ui, "Head-bob", "The rider's head moves with g and vibrates slightly.");
  setting_box<&CameraFeel::follow>(ui, "Follow the open end",
                                   "Move the orbit camera where the open end or the preview leaves the view.");
  setting_box<&CameraFeel::reduced_motion>(ui, "Reduced motion",
                                           "Level horizon, cuts between cameras, no head-bob, no widening.");
}

}  // namespace coaster::ui
