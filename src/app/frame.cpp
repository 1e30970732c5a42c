// The frame, from top to bottom: events, panels, commands, ticks, picture, panels' picture, screen, numbers.
#include "app/frame.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "app/pictures.h"
#include "sim/ride/ride.h"

namespace coaster::app {

std::vector<sim::Pose> cart_poses(const edit::Session& session) {
  std::vector<sim::Pose> poses;
  if (session.derived.order.empty()) return poses;
  const auto& carts = session.motion.carts;
  for (std::size_t i = 0; i < carts.size(); ++i)
    for (const sim::Pose& car : sim::car_poses(session.document, session.derived, carts.entities()[i], carts.items()[i],
                                               session.settings.frames))
      poses.push_back(car);
  return poses;
}

namespace {

// Time. A request to close is for the panels, which ask back while there are unsaved changes; a window without size
// cannot ask.
void take_events(Program& program, const platform::Events& events, platform::Size size) {
  for (const platform::Event& event : events) {
    if (const auto* const tick = std::get_if<platform::Tick>(&event)) program.seconds += tick->dt;
    if (std::holds_alternative<platform::CloseRequest>(event) && size.width < 1 && !edit::dirty(program.session))
      program.quit = true;
  }
}

// One script at a time: a window's player is taught by one.
void ask_for_tutorial(Program& program) {
  if (program.options.script.empty() && program.surface->is_window() && !program.lesson) program.wants_tutorial = true;
  else
    edit::notify(program.session, edit::NoticeKind::warning,
                 "the tutorial needs a window, and a player whom no script holds by the hand");
}

// Panels and viewport tool see the state before this frame's commands, which are applied here.
ui::Output build_panels(Program& program, const platform::Events& events, platform::Size size) {
  ui::State state{program.session,          program.stats, program.seconds,
                  program.stats.hide_times, &program.rig,  program.keeper ? &program.keeper->state : nullptr};
  state.importing = shown_import(program);
  state.lesson = program.lesson ? &*program.lesson : nullptr;
  state.pictures = &program.pictures.made();
  state.movie = program.filming && program.filming->by_hand ? &program.filming->shown : nullptr;
  ui::Output output = program.ui->build(events, state, size.width, size.height);
  if (output.cancel_import && program.import) program.import->progress.cancelled = true;
  if (output.lesson_answer != query::LessonAnswer::none) program.lesson_answer = output.lesson_answer;
  if (output.wants_tutorial) ask_for_tutorial(program);
  program.pictures.update(program.gl, *program.renderer, output.wanted_pictures, program.session.settings.style);
  program.toast = program.ui->toast();
  program.by_hand = true;
  for (const edit::Command& command : output.commands) {
    // While a file is read its track is as good as open: nothing else begins that would be lost.
    if (program.import && edit::info(command).effect != edit::Effect::settings) continue;
    if (!begin_import(program, command)) (void)apply(program, command);  // what is refused shows as a notice
  }
  program.by_hand = false;
  program.hovered = output.hovered;
  program.quit = program.quit || output.quit;
  keep(program, &output);
  keep_filming(program, &output);
  return output;
}

struct Look {
  const world::Settings& settings;  // those of the session, or a copy without what is selected
  const view::View& view;
  view::Pick hovered;
  bool alone = false;
  bool unseen = false;
};

gfx::DrawStats draw_scene(Program& program, const Look& look, platform::Size size) {
  const edit::Session& session = program.session;
  const world::Layers& layers = look.settings.layers;
  const bool limits = layers.has(world::Layer::limits),
             by_ride = world::colourings()[static_cast<std::size_t>(session.settings.colouring)].of_ride;
  const sim::Ghost* const ghost = limits || by_ride ? edit::chosen_ride(session) : nullptr;
  const bool with_train = program.rig.mode == world::CameraMode::ride || program.rig.mode == world::CameraMode::chase;
  view::Findings findings{.failure = session.motion.failure,
                          .riding = look.alone || (with_train && session.motion.state == world::RideState::running)};
  if (layers.has(world::Layer::flips)) findings.breaks = program.breaks.update(session.derived);
  if (layers.has(world::Layer::conflicts) && !findings.riding) findings.conflicts = edit::conflicts(session);
  if (limits && ghost) findings.spans = program.red.update(*ghost, session.envelope);
  if (look.settings.show_element) {
    findings.element = &session.elements.plan(look.settings.element, session.document);
    findings.narrow = edit::narrow_parts(session, look.settings.element);
  }
  const sim::TrackValues& values = program.values.update(session.derived, session.settings, ghost);
  program.stats.colour_low = values.low, program.stats.colour_high = values.high;
  const view::Overlay overlay =
      view::build_overlay(session.document, session.derived, look.settings, look.view, look.hovered, findings);
  const std::vector<sim::Pose> carts = cart_poses(session);
  gfx::Scene scene{session.derived,       look.view, overlay, carts, layers.has(world::Layer::polyline), &values,
                   session.settings.theme};
  scene.style = session.settings.style;
  scene.shadows = session.settings.shadows;
  scene.unseen = look.unseen;
  scene.clock = [&] { return program.surface->clock(); };
  const bool held = layers.has(world::Layer::supports);
  const double before = program.surface->clock();
  if (held) program.supports.update(session.derived), scene.supports = &program.supports;
  const double finding = program.surface->clock() - before;
  program.stats.supports = held ? program.supports.count() : 0;
  program.stats.support_rebuilds = held ? program.supports.rebuilds() : 0;
  gfx::DrawStats drawn = program.renderer->draw(scene, size.width, size.height);
  drawn.cpu_ms += 1e3 * finding;
  return drawn;
}

// Numbers of the frame that was just drawn, for the panels of the next one and for scripts.
void fill_stats(Program& program, const gfx::DrawStats& drawn, platform::Size size, double began, double built,
                double drew) {
  query::FrameStats& stats = program.stats;
  const sim::Derived& derived = program.session.derived;
  ++stats.frame;
  stats.uploads = drawn.uploads;
  stats.recolours = drawn.recolours;
  stats.support_uploads = drawn.support_uploads;
  stats.upload_bytes = drawn.upload_bytes;
  stats.polyline_upload_bytes = drawn.polyline_upload_bytes;
  stats.polyline_bytes = drawn.polyline_bytes;
  stats.drawn_by = drawn.drawn_by;
  if (drawn.drawn_by != derived.evaluated_by)
    stats.stage_refusals[static_cast<std::size_t>(derived.evaluated_by)] =
        program.renderer->refusal(derived.evaluated_by);
  stats.gpu_deviation = drawn.deviation;
  stats.deviation_pending = drawn.deviation_pending;
  stats.gpu_ms = drawn.gpu_ms;
  stats.rebuilds = program.rebuilds;
  if (derived.evaluated_by != curve::EvaluatedBy::processor) {
    stats.evaluation_ms = 0;
    stats.evaluated_vertices = 0;
  } else if (program.rebuilds > 0) {
    stats.evaluation_ms = derived.evaluation_seconds * 1e3;
    stats.evaluated_vertices = derived.evaluated_vertices;
  }
  program.rebuilds = 0;
  stats.draw_calls = drawn.draw_calls;
  stats.triangles = drawn.triangles;
  stats.shadow_maps = drawn.shadow_maps;
  stats.samples = drawn.samples;
  stats.width = size.width, stats.height = size.height;
  const view::Eye& eye = program.rig.eye;
  stats.camera_shown = program.rig.mode;
  stats.eye = eye.position, stats.eye_forward = eye.forward,
  stats.eye_up = glm::normalize(eye.up - glm::dot(eye.up, eye.forward) * eye.forward);
  stats.field_of_view_deg = eye.field_of_view_deg;
  stats.cpu_ms = (built - began) * 1e3 + drawn.cpu_ms;
  stats.gl_ms = (drew - built) * 1e3 - drawn.cpu_ms;
}

void set_title(Program& program) {
  std::string title = title_of(program.session);
  if (title == program.title) return;
  program.surface->set_title(title);
  program.title = std::move(title);
}

}  // namespace

int take_ticks(Program& program, const platform::Events& events) {
  constexpr double kLongestPause = 0.25;
  for (const platform::Event& event : events)
    if (const auto* const tick = std::get_if<platform::Tick>(&event))
      program.tick_debt += std::clamp(tick->dt, 0.0, kLongestPause);
  const int ticks = static_cast<int>(program.tick_debt / world::kTick + 1e-9);
  program.tick_debt = std::max(0.0, program.tick_debt - ticks * world::kTick);
  return ticks;
}

void run_frame(Program& program, const platform::Events& events, int ticks) {
  const double began = program.surface->clock();
  const platform::Size size = program.surface->size();
  take_events(program, events, size);
  finish_import(program);
  if (size.width < 1 || size.height < 1) {
    advance(program, ticks);
    keep(program, nullptr);
    keep_filming(program, nullptr);
    return;
  }
  ui::Output output = build_panels(program, events, size);
  advance(program, ticks);
  // From where the carts are now: an eye of the frame's start would lag behind them by as many ticks as this frame
  // happens to have.
  output.view = program.view = view::view_of(program.rig.eye, output.view.viewport);
  edit::advance_measurement(program.session);
  const double built = program.surface->clock();
  program.unseen = !program.surface->is_window() && !output.wants_screenshot;
  const gfx::DrawStats drawn =
      draw_scene(program, {program.session.settings, output.view, output.hovered, false, program.unseen}, size);
  if (!program.unseen) program.ui->draw(size.width, size.height);
  const double drew = program.surface->clock();
  program.surface->present(program.renderer->framebuffer());
  fill_stats(program, drawn, size, began, built, drew);
  set_title(program);
  program.drawn_tick = program.session.tick, program.drawn_commands = program.commands;
  if (output.wants_screenshot) take_photo(program);
}

void draw_pixels(Program& program) {
  const platform::Size size{program.stats.width, program.stats.height};
  if (!std::exchange(program.unseen, false) || size.width < 1 || size.height < 1) return;
  (void)draw_scene(program, {program.session.settings, program.view, program.hovered}, size);
  program.ui->draw(size.width, size.height);
}

void play_frame(Program& program) {
  constexpr double kWeight = 0.05;  // of the newest frame in the shown rate
  platform::Events events;
  program.surface->poll(events);
  // While a movie is recorded, time goes by its pictures, however long each of them takes.
  const bool filmed = program.filming && program.filming->movie;
  film(program, filmed ? program.filming->movie->ticks_a_frame() : take_ticks(program, events), [&](int some) {
    run_frame(program, events, some);
    events.clear();
  });
  keep_sounding(program);
  const double now = program.surface->clock(), taken = now - program.frame_clock;
  program.frame_clock = now;
  program.smoothed_frame =
      program.smoothed_frame == 0 ? taken : program.smoothed_frame + (taken - program.smoothed_frame) * kWeight;
  program.stats.fps = program.smoothed_frame > 0 ? 1 / program.smoothed_frame : 0;
}

bool is_drawn(const Program& program) {
  return program.stats.frame > 0 && program.drawn_tick == program.session.tick &&
         program.drawn_commands == program.commands;
}

void draw_scene_alone(Program& program, const view::View& view, platform::Size size) {
  world::Settings settings = program.session.settings;
  settings.selected = world::kNone;
  settings.also.clear();
  settings.show_gizmo = settings.show_element = false;
  settings.layers.set(world::Layer::polyline, false);
  (void)draw_scene(program, {settings, view, {}, true}, size);
}

}  // namespace coaster::app
