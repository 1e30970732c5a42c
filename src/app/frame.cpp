// The frame, from top to bottom: input, panels, their output, ticks, findings, picture, kept data.
#include "app/frame.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include "app/long_job.h"
#include "app/pictures.h"
#include "app/scene.h"
#include "base/cancellable_job.h"
#include "base/crash_guard.h"
#include "edit/commands/commands_force_sections.h"
#include "edit/commands/commands_sections.h"
#include "exchange/formats.h"
#include "exchange/own/share_link.h"
#include "exchange/own/track_file.h"
#include "world/appearance_settings.h"
#include "world/laboratory_settings.h"

namespace coaster::app {
namespace {

// True while every frame shows something new.
bool is_busy(Program& program) {
  edit::Session& session = program.session;
  return session.motion.state == world::RideState::running || session.measuring.measurement.running ||
         program.picture.rig.ticks_left > 0 || program.stats.deviation_pending > 0 || program.pictures.busy() ||
         (session.settings.lab->layers.has(world::Layer::conflicts) &&
          !edit::SessionFindings(session).all_conflicts()) ||
         program.job || program.filming || program.tutorial.wanted || program.tutorial.card ||
         program.ui->input_waits() || (program.keeper && program.keeper->dialog.running());
}

// Returns whether the events contain anything but elapsed time.
bool has_input(const platform::Events& events) {
  return std::ranges::any_of(events, [](const auto& event) { return !std::holds_alternative<platform::Tick>(event); });
}

// Returns whether the next frame would equal the last one, unless an event arrives. Always false without a window, and
// with a number of frames or a log of hashes.
bool is_idle(const Program& program) {
  if (!program.surface->is_window() || program.options.frames || program.options.hash_log) return false;
  const FrameClock& time = program.time;
  return time.seconds >= time.idle_from && time.seconds < time.idle_until;
}

// Decides, after a frame with these events, from when the window is idle, and when it must draw without an event.
void plan_idle(Program& program, const platform::Events& events, bool commanded) {
  FrameClock& time = program.time;
  constexpr double kAfter = 1;  // s without an event or a movement; tooltips need less
  if (commanded || has_input(events) || is_busy(program)) time.idle_from = time.seconds + kAfter;
  time.idle_until = time.seconds + program.ui->still_for(time.seconds);
}

// Reads time and a request to close. The panels get the request, because they ask about unsaved changes; a window of
// zero size cannot ask.
void read_input(Program& program, const platform::Events& events, platform::Size size) {
  for (const platform::Event& event : events) {
    if (const auto* const tick = std::get_if<platform::Tick>(&event)) program.time.seconds += tick->dt;
    if (std::holds_alternative<platform::CloseRequest>(event) && size.width < 1 && !edit::dirty(program.session))
      program.quit = true;
  }
}

// Builds panels and viewport tool from the state before this frame's commands. Changes nothing but the requested
// findings.
ui::Output build_panels(Program& program, const platform::Events& events, platform::Size size) {
  ui::UiState state{program.session,          program.stats,        program.time.seconds,
                    program.stats.hide_times, &program.picture.rig, program.keeper ? &program.keeper->state : nullptr};
  state.waiting = program.job != nullptr;
  if (const LongJob* const job = shown_job(program)) state.job = {&job->work->progress, job->panel, job->title};
  state.lesson = program.tutorial.card ? &*program.tutorial.card : nullptr;
  state.pictures = &program.pictures.made();
  state.movie = program.filming && program.filming->by_hand ? &program.filming->shown : nullptr;
  state.content_scale = program.surface->content_scale();
  return program.ui->build(events, state, size.width, size.height);
}

// Starts the tutorial unless a script is running: it is a script, too.
void ask_for_tutorial(Program& program) {
  if (program.options.script.empty() && program.surface->is_window() && !program.tutorial.card)
    program.tutorial.wanted = true;
  else
    edit::notify(program.session, edit::NoticeKind::warning,
                 "The tutorial needs a window and cannot run during a script.");
}

// Pastes the clipboard. A link or a list of points is opened. The clipboard of another window has priority over what
// was copied here.
void paste(Program& program, bool link_alone, const std::optional<ui::ForceKeyPlace>& keys_to) {
  std::string text = program.surface->clipboard();
  if (exchange::is_link(text) || exchange::is_pasted(text)) return program.ui->open(std::move(text));
  if (link_alone) return;
  if (keys_to && exchange::parse_keys(text.empty() ? program.session.copied : text)) {
    edit::PasteForceKeys keys{{keys_to->section}, keys_to->channel, keys_to->at, {}};
    if (text != program.session.copied) keys.text = std::move(text);
    return apply_by_hand(program, {std::move(keys)});
  }
  if (text == program.session.copied || !exchange::parse_track(text, "clipboard")) text.clear();
  apply_by_hand(program, {edit::PasteSections{std::move(text)}});
}

// Carries out everything that the panels requested.
void apply_output(Program& program, const ui::Output& output) {
  if (output.cancel_job && program.job) program.job->work->progress.cancelled = true;
  if (output.lesson_answer != query::LessonAnswer::none) program.tutorial.answer = output.lesson_answer;
  if (output.wants_tutorial) ask_for_tutorial(program);
  program.pictures.update(program.gl, *program.renderer, output.wanted_pictures, output.picture_width,
                          program.session.settings.look->style, program.session.settings.look->scenery);
  program.picture.toast = program.ui->toast();
  apply_by_hand(program, output.commands);
  if (output.wants_paste || output.wants_link) paste(program, !output.wants_paste, output.keys_to);
  program.picture.hovered = output.hovered;
  program.quit = program.quit || output.quit;
  if (output.toggles_full_screen) program.surface->toggle_full_screen();
  program.surface->take_text(output.takes_text);
  answer_keeping(program, output);
}

// End times of the parts of a frame, s by the surface's clock.
struct FrameTimes {
  double began = 0, found = 0, drew = 0;
};

// Statistics of this frame, for the panels of the next one and for scripts.
void fill_stats(Program& program, const gfx::DrawStats& drawn, platform::Size size, const FrameTimes& times) {
  query::FrameStats& stats = program.stats;
  const sim::DerivedTrack& derived = program.session.derived;
  static_cast<view::DrawStats&>(stats) = drawn;
  ++stats.frame;
  if (drawn.drawn_by != derived.evaluated_by)
    stats.stage_refusals[static_cast<std::size_t>(derived.evaluated_by)] =
        program.renderer->refusal(derived.evaluated_by);
  const edit::EvaluationWork evaluated = std::exchange(program.session.evaluated, {});
  stats.rebuilds = evaluated.rebuilds;
  if (derived.evaluated_by != curve::EvaluatedBy::processor) {
    stats.evaluation_ms = 0;
    stats.evaluated_vertices = 0;
  } else if (stats.rebuilds > 0) {
    stats.evaluation_ms = evaluated.seconds * 1e3;
    stats.evaluated_vertices = evaluated.vertices;
  }
  stats.width = size.width, stats.height = size.height;
  const view::Eye& eye = program.picture.rig.eye;
  stats.camera_shown = program.picture.rig.mode;
  stats.eye = eye.position, stats.eye_forward = eye.forward,
  stats.eye_up = glm::normalize(eye.up - glm::dot(eye.up, eye.forward) * eye.forward);
  stats.field_of_view_deg = eye.field_of_view_deg;
  stats.cpu_ms = (times.found - times.began) * 1e3 + drawn.prepare_ms;
  stats.gl_ms = (times.drew - times.found) * 1e3 - drawn.prepare_ms;
}

void set_title(Program& program) {
  std::string title = title_of(program.session);
  if (title == program.picture.title) return;
  program.surface->set_title(title);
  program.picture.title = std::move(title);
}

// Draws and shows the present state, and stores the figures of the picture.
void draw(Program& program, const ui::Output& output, const PictureSettings& look, const PictureContents& seen,
          platform::Size size, FrameTimes times) {
  const gfx::DrawStats drawn = draw_scene(program, look, seen, size);
  if (!look.unseen) program.ui->draw(size.width, size.height);
  times.drew = program.surface->clock();
  if (!look.unseen) program.surface->present(program.renderer->framebuffer());
  if (!look.unseen || !program.surface->is_window()) base::explain_crashes("", 0);  // the driver works
  fill_stats(program, drawn, size, times);
  set_title(program);
  program.picture.unseen = look.unseen;
  program.picture.tick = program.session.tick, program.picture.commands = program.commands;
  if (output.photo != ui::PictureRequest::none) take_photo(program, output.photo == ui::PictureRequest::window);
}

// Runs a frame of an idle window: everything that needs no picture.
void pass_time(Program& program, const platform::Events& events) {
  read_input(program, events, program.surface->size());
  keep_sounding(program);
  keep(program);
  program.time.last_frame = program.surface->clock();
}

}  // namespace

int take_ticks(FrameClock& time, const platform::Events& events) {
  constexpr double kLongestPause = 0.25;
  for (const platform::Event& event : events)
    if (const auto* const tick = std::get_if<platform::Tick>(&event))
      time.tick_debt += std::clamp(tick->dt, 0.0, kLongestPause);
  const int ticks = static_cast<int>(time.tick_debt / world::kTick + 1e-9);
  time.tick_debt = std::max(0.0, time.tick_debt - ticks * world::kTick);
  return ticks;
}

void run_frame(Program& program, const platform::Events& events, int ticks) {
  if (base::interrupted()) return;
  FrameTimes times{program.surface->clock()};
  const platform::Size size = program.surface->size();
  const auto reach = [&](base::CrashPlace place) { crash_if_planned(program.planned_crash, place); };
  reach(base::CrashPlace::input);
  read_input(program, events, size);
  finish_job(program);
  reach(base::CrashPlace::panels);
  std::optional<ui::Output> output;
  if (size.width > 0 && size.height > 0) output = build_panels(program, take_input(program, events), size);
  if (output) apply_output(program, *output);
  if (base::interrupted()) return;  // what is derived may be incomplete
  follow_movie(program, output ? output->movie : ui::MovieRequest::none);
  reach(base::CrashPlace::ticks);
  advance(program, ticks);
  reach(base::CrashPlace::findings);
  if (output) {
    edit::advance_measurement(program.session);
    // Uses the trains' present positions: an eye from the frame's start would lag by this frame's ticks.
    program.picture.view = view::view_of(program.picture.rig.eye, output->view.viewport, output->view.density);
    program.picture.free = output->free;
    const bool opening = program.stats.frame == 0;  // a window's first frame is before its track is open
    const bool unseen = (opening || !program.surface->is_window()) && output->photo == ui::PictureRequest::none;
    const PictureSettings look{program.session.settings, program.picture.view, output->hovered, false, unseen};
    const PictureContents seen = find_seen(program, look);
    times.found = program.surface->clock();
    reach(base::CrashPlace::drawing);
    draw(program, *output, look, seen, size, times);
  }
  reach(base::CrashPlace::keeping);
  keep(program);
}

void play_frame(Program& program) {
  constexpr double kWeight = 0.05;  // weight of the newest frame in the displayed rate
  FrameClock& time = program.time;
  platform::Events events;
  const bool idle = is_idle(program);
  program.surface->poll(events, idle ? kIdleWait : 0);
  if (idle && !has_input(events)) return pass_time(program, events);
  if (idle) time.last_frame = program.surface->clock();  // the wait is no part of a frame
  const std::uint64_t commands = program.commands;
  const platform::Events seen = events;
  // While a movie is recorded, time advances with its pictures, however long each takes.
  const int ticks = recording(program) ? ticks_to_film(program) : take_ticks(time, events);
  film(program, ticks, [&](int some) {
    run_frame(program, events, some);
    events.clear();
  });
  plan_idle(program, seen, program.commands != commands);
  keep_sounding(program);
  const double now = program.surface->clock(), taken = now - time.last_frame;
  time.last_frame = now;
  time.smoothed_frame =
      time.smoothed_frame == 0 ? taken : time.smoothed_frame + (taken - time.smoothed_frame) * kWeight;
  program.stats.fps = time.smoothed_frame > 0 ? 1 / time.smoothed_frame : 0;
}

bool is_drawn(const Program& program) {
  return program.stats.frame > 0 && program.picture.tick == program.session.tick &&
         program.picture.commands == program.commands;
}

}  // namespace coaster::app
