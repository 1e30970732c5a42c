#include "app/idle.h"

#include <algorithm>
#include <variant>

#include "app/long_job.h"
#include "app/program.h"
#include "world/lab_view.h"

namespace coaster::app {
namespace {

// True while every frame shows something new.
bool is_busy(Program& program) {
  edit::Session& session = program.session;
  return session.motion.state == world::RideState::running || session.measuring.measurement.running ||
         program.picture.rig.ticks_left > 0 || program.stats.deviation_pending > 0 || program.pictures.busy() ||
         (session.settings.lab->layers.has(world::Layer::conflicts) && !edit::Finder(session).all_conflicts()) ||
         program.job || program.filming || program.tutorial.wanted || program.tutorial.card ||
         program.ui->input_waits() || (program.keeper && program.keeper->dialog.running());
}

}  // namespace

bool has_input(const platform::Events& events) {
  return std::ranges::any_of(events, [](const auto& event) { return !std::holds_alternative<platform::Tick>(event); });
}

bool is_idle(const Program& program) {
  if (!program.surface->is_window() || program.options.frames || program.options.hash_log) return false;
  const FrameClock& time = program.time;
  return time.seconds >= time.idle_from && time.seconds < time.idle_until;
}

void plan_idle(Program& program, const platform::Events& events, bool commanded) {
  FrameClock& time = program.time;
  if (commanded || has_input(events) || is_busy(program)) time.idle_from = time.seconds + kIdleAfter;
  time.idle_until = time.seconds + program.ui->still_for(time.seconds);
}

}  // namespace coaster::app
