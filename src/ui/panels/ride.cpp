// Ride: running the carts, how they move, and what the riders feel.
#include <imgui.h>

#include "sim/shape/frame_methods.h"
#include "ui/actions/key_map.h"
#include "ui/panels/panels.h"
#include "ui/widgets/icons.h"

namespace coaster::ui {
namespace {

void controls(Ui& ui) {
  const edit::Session& session = ui.session();
  const bool any = session.document.entities.pool<world::Cart>().size() > 0 && !session.document.track.segments.empty();
  const world::RideState state = session.motion.state;
  const bool running = state == world::RideState::running;
  const float width = (ImGui::GetContentRegionAvail().x - 3 * ImGui::GetStyle().ItemInnerSpacing.x) / 4;
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  if (icon_button(ui, Icon::play, "Play", with_keys(ui.keys, "Let the carts run from where they are.", "Play or pause"),
                  any && !running, width))
    ui.emit(edit::RideStart{});
  ImGui::SameLine(0, gap);
  if (icon_button(ui, Icon::pause, "Pause", with_keys(ui.keys, "Hold the carts where they are.", "Play or pause"),
                  any && running, width))
    ui.emit(edit::RidePause{});
  ImGui::SameLine(0, gap);
  const bool steppable = any && (state == world::RideState::paused || state == world::RideState::stopped);
  if (icon_button(ui, Icon::step, "Step",
                  with_keys(ui.keys, "Advance a held ride by one tick of 1/120 s.", "Single step"), steppable, width))
    ui.emit(edit::RideStep{1});
  ImGui::SameLine(0, gap);
  if (icon_button(ui, Icon::reset, "Reset", with_keys(ui.keys, "Put the carts back to their start.", "Reset"), any,
                  width))
    ui.emit(edit::RideStop{});
}

void read_outs(Ui& ui) {
  read_query(ui, "State", "ride.state", {}, "stopped at the start, running, paused, ended at an open end, or failed.");
  if (ui.session().motion.failure.kind != world::FailureKind::none)
    read_query(ui, "Because it", "ride.fail", {}, "Why the ride stopped by itself.");
  read_query(ui, "Speed", "ride.speed", {}, "Speed of the first cart along the track.", {.decimals = 2});
  read_query(ui, "Height", "ride.height", {}, "Height of the first cart over the ground.", {.decimals = 2});
  read_query(ui, "Distance", "ride.distance", {}, "Place of the first cart, along the track from its start.",
             {.decimals = 2});
  read_query(ui, "Lap", "ride.lap", {}, "Whole rounds since the start.", {.decimals = 0});
  read_query(ui, "Energy", "ride.energy", {}, "v\u00B2/2 + g (y - datum), per kilogram.", {.decimals = 3});
  read_query(
      ui, "Energy drift", "ride.energy_drift", {},
      "How far the energy is from where it started, relative to the peak kinetic energy: the integrator's error.",
      {.decimals = 4, .unit = "ppm", .factor = 1e6});
  // Scripts and pictures show no times.
  const double cost = ui.session().measuring.ride_cost.ns_per_tick;
  read_out(ui, "Cost per tick", !ui.state.scripted && cost > 0 ? fixed(cost, 0) : "--", "ns",
           "What the last ticks took on this machine, all carts together, by the chosen integrator.");
  read_query(ui, "g up", "ride.g_up", {}, "Felt acceleration towards the rider's head; at rest on the flat 1.",
             {.decimals = 2, .unit = "g"});
  read_query(ui, "g side", "ride.g_side", {}, "Felt acceleration to the side.", {.decimals = 2, .unit = "g"});
  read_query(ui, "g forward", "ride.g_forward", {}, "Felt acceleration forwards.", {.decimals = 2, .unit = "g"});
}

void ride_methods(Ui& ui) {
  const world::Settings& settings = ui.session().settings;
  heading(ui, "Frame method", "What carts and the ride camera are turned by. The track stays banked by its knots.");
  const auto rows = sim::frame_methods();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto method = static_cast<world::FrameMethod>(i);
    if (radio(ui, std::string(rows[i].label), settings.frames == method, std::string(rows[i].formula)))
      ui.emit(edit::Set<&world::Settings::frames>{method});
  }
  const auto chosen =
      combo_of(ui, "Integrator", settings.integrator, "How speed and place advance from tick to tick (1/120 s).");
  if (chosen) ui.emit(edit::Set<&world::Settings::integrator>{*chosen});
}

}  // namespace

void ride_panel(Ui& ui) {
  controls(ui);
  read_outs(ui);
  ride_methods(ui);
}

}  // namespace coaster::ui
