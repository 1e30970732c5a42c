// Creates a program and changes its state.
#include "app/program.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "app/long_job.h"
#include "base/cancellable_job.h"
#include "base/console.h"
#include "base/folders.h"
#include "base/hash.h"
#include "base/text.h"
#include "edit/commands/commands_force_sections.h"
#include "edit/commands/commands_operation.h"
#include "edit/commands/commands_sections.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "edit/commands/set_setting.h"
#include "edit/perform/apply.h"
#include "exchange/formats.h"
#include "platform/signals.h"
#include "query/challenge_rules.h"
#include "script/paths.h"
#include "ui/tools/camera_controls.h"
#include "view/camera.h"
#include "world/appearance_settings.h"
#include "world/evaluation_settings.h"

namespace coaster::app {
namespace {

#if defined(__clang__)
constexpr const char* kCompiler = "clang " __clang_version__;
#else
constexpr const char* kCompiler = "gcc " __VERSION__;
#endif

// Returns "Some processor, compiler 12.2.0", which is printed with all times.
std::string machine_line() {
  std::string model = "unknown processor";
  std::ifstream info("/proc/cpuinfo");  // not a regular file with a size
  for (std::string line; std::getline(info, line);) {
    const std::size_t colon = line.find(": ");
    if (!line.starts_with("model name") || colon == std::string::npos) continue;
    model = line.substr(colon + 2);
    break;
  }
  return fmt::format("{}; compiled by {}", model, kCompiler);
}

// Ends a recording that could not be written.
void keep_recording(Program& program, const base::Status& wrote) {
  if (wrote) return;
  edit::notify(program.session, edit::NoticeKind::error, wrote.message);
  program.recorded = wrote;
  program.recorder.reset();
}

// Applies and records one command.
base::Status apply_one(Program& program, const edit::Command& command, edit::ClosingSearch* search) {
  if (const std::string* const path = edit::output_path(command); path && !program.files.root().contains(*path)) {
    const base::Status refused{base::Code::refused,
                               fmt::format("{}: {}", edit::info(command).name, script::not_below_out(*path))};
    edit::notify(program.session, refused);
    return refused;
  }
  if (const base::Status allowed = before_command(program, command); !allowed) {
    edit::notify(program.session, edit::NoticeKind::error, allowed.message);
    return allowed;
  }
  crash_if_planned(program.planned_crash, base::CrashPlace::command);
  const base::Status applied = apply_watched(program, command, search);
  after_command(program, command, applied);
  if (applied && command.is<edit::Set<&world::Evaluation::evaluator>>())
    if (const std::string reason = program.renderer->refusal(program.session.derived.evaluated_by); !reason.empty())
      edit::notify(program.session, edit::NoticeKind::warning, "The vertex shader draws instead: " + reason);
  view::follow(program.picture.rig, watched(program), 0);
  ++program.commands;
  if (!applied || !program.recorder) return applied;
  keep_recording(program, program.recorder->command(command, program.session));
  return {};
}

// Creates the surface and the renderer.
base::Status start_graphics(Program& program, const platform::SurfaceOptions& surface, int samples) {
  auto made = program.options.headless ? platform::make_offscreen(surface) : platform::make_window(surface);
  if (!made) return made.status();
  program.surface = std::move(*made);
  platform::Surface* const screen = program.surface.get();
  auto gl = gfx::load_gl([screen](const char* name) { return screen->gl_proc(name); });
  if (!gl) return gl.status();
  program.gl = std::move(*gl);
  program.renderer = std::make_unique<gfx::Renderer>(program.gl, samples);
  return {};
}

// Returns the line of a crash while the driver starts. Variables of Mesa are the usual reason: it checks few values.
std::string crash_line() {
  constexpr std::array<std::string_view, 8> kPrefixes{"DRAW_",  "EGL_", "GALLIUM_", "GALLIVM_",
                                                      "LIBGL_", "LP_",  "MESA_",    "ST_"};
  std::string found;
  for (char** variable = environ; variable != nullptr && *variable != nullptr; ++variable) {
    const std::string_view text = *variable;
    if (std::any_of(kPrefixes.begin(), kPrefixes.end(), [&](std::string_view p) { return text.starts_with(p); }))
      found += fmt::format(" {}", text);
  }
  return "The OpenGL driver crashed at its start." +
         (found.empty() ? "" : base::visible_text(" Unset the variables that change it:" + found));
}

// Autosaves before the program ends at once; returns the text to print. An incomplete change is not saved.
std::string save_at_once(Program& program) {
  if (!program.keeper || !edit::dirty(program.session)) return {};
  if (world::broken_invariant(program.session.document)) return "Changes since the last autosave are lost.";
  const base::Status kept = autosave_now(program);
  return kept ? "Unsaved changes are kept for the next start." : kept.message;
}

}  // namespace

// --- The ride's sound in a window: opens the device when sound is on, and feeds it

void keep_sounding(Program& program) {
  Sounds& sounds = program.sounds;
  const edit::Session& session = program.session;
  const double volume = session.settings.look->sound;
  const bool wanted = volume > 0;
  if (!wanted) {
    sounds.refused = false;
    if (sounds.device && sounds.voice.heard.volume < 1e-3) {  // otherwise it fades out first
      program.surface->end_sound();
      sounds.device.reset();
    }
  }
  if (wanted && !sounds.device && !sounds.refused) {
    auto device = platform::SoundDevice::open();
    if (device) {
      sounds.device = std::move(*device);
    } else {
      sounds.refused = true;
      if (sounds.refusals++ > 0)
        edit::notify(program.session, edit::NoticeKind::info,
                     base::sentence("sound is off: " + device.status().message));
    }
  }
  if (!sounds.device) return;
  const view::RideNoise noise = recording(program)
                                    ? view::RideNoise{}
                                    : view::ride_noise(session.document, session.derived, session.motion, volume,
                                                       &edit::SessionFindings(program.session).ground());
  sounds.device->feed(
      [&](std::span<float> block) { view::synthesise(sounds.voice, noise, platform::kSoundRate, block); });
}

Program::Program() = default;
Program::~Program() = default;

void leave_without_graphics(Program& program, const std::string& why) {
  const std::string said = save_at_once(program);
  if (program.keeper) program.keeper->lock.release();
  base::print_error(said.empty() ? why : why + " " + said);
  (void)base::finish_printing();
  std::_Exit(base::exit_code(base::Code::graphics));
}

view::CameraSubject watched(Program& program) {
  edit::Session& session = program.session;
  return {session.document, session.derived, session.motion,
          session.settings, program.by_hand, &edit::SessionFindings(session).ground()};
}

base::Result<std::unique_ptr<Program>> make_program(const Options& options, platform::Size size, int samples) {
  base::explain_crashes(crash_line(), base::exit_code(base::Code::graphics));
  auto program = std::make_unique<Program>();
  base::watch_interruption([] { return platform::pending_signal() != 0; });
  program->options = options;
  base::on_memory_end([p = program.get()] { return save_at_once(*p); });
  const auto lost = [p = program.get()] { leave_without_graphics(*p, "The display is gone."); };
  if (const base::Status started = start_graphics(*program, {size, "coaster", true, true, lost}, samples); !started) {
    base::end_if_out_of_memory();  // a driver reports that as another error
    return started;
  }
  platform::Surface* const screen = program->surface.get();
  if (options.headless)
    base::print_error(fmt::format("Drawing with {}: {}, {}{}", screen->library(), program->gl.renderer,
                                  program->gl.es ? "" : "OpenGL ", program->gl.version));
  for (const curve::EvaluatedBy stage : {curve::EvaluatedBy::vertex_shader, curve::EvaluatedBy::geometry_shader,
                                         curve::EvaluatedBy::tessellation_shader})
    program->stats.stage_refusals[static_cast<std::size_t>(stage)] = program->renderer->refusal(stage);
  auto panels = ui::Host::make(program->gl);
  if (!panels) return panels.status();
  program->ui = std::move(*panels);
  program->session = edit::make_session([screen] { return screen->clock(); });
  program->session.measuring.machine = machine_line();
  program->session.game.referee = query::referee();
  view::follow(program->picture.rig, watched(*program), 0);
  return program;
}

base::Status apply(Program& program, const edit::Command& command, edit::ClosingSearch* search) {
  const std::uint64_t notices = program.session.notices.serial;
  const base::Status applied = apply_one(program, command, search);
  if (program.session.notices.serial != notices)
    program.picture.toast = program.session.notices.list.back().text;  // the panels show it in the next frame
  if (applied && (command.is<edit::CopySection>() || command.is<edit::CopyForceKeys>()))
    program.surface->set_clipboard(program.session.copied);
  if (const std::string* const path = edit::output_path(command); applied && path && program.by_hand)
    for (const std::filesystem::path& file : {std::filesystem::path(*path), exchange::materials_of(*path)})
      if (!file.empty()) program.surface->offer(file.string());
  if (applied && command.is<edit::CopyLink>())
    program.surface->set_clipboard(program.options.address + program.session.shared);
  if (!applied || !edit::info(command).traits.replaces || edit::opens_link(command)) return applied;
  const edit::Session& session = program.session;
  const world::Camera camera = ui::framed_all(session, program.picture.view.viewport, program.picture.free);
  (void)apply_one(program, edit::set_camera(camera), nullptr);
  return applied;
}

base::Status finish_recording(Program& program) {
  if (program.recorder) keep_recording(program, program.recorder->finish());
  program.recorder.reset();
  return program.recorded;
}

void advance(Program& program, int ticks) {
  if (program.recorder) keep_recording(program, program.recorder->ticks(ticks));
  const auto advance_by = [&](int some) {
    edit::advance(program.session, some);
    view::follow(program.picture.rig, watched(program), some);
  };
  if (!program.options.hash_log && !view::steps(program.picture.rig)) return advance_by(ticks);
  const std::string document = program.options.hash_log ? base::hex16(world::hash(program.session.document)) : "";
  for (int i = 0; i < ticks; ++i) {
    advance_by(1);
    if (!program.options.hash_log) continue;
    const std::string motion = base::hex16(world::hash(program.session.document, program.session.motion));
    base::print(fmt::format("tick {} document {} motion {}\n", program.session.tick, document, motion));
  }
  if (program.options.hash_log) (void)base::finish_printing();  // so that a reader of the log sees every frame at once
}

query::QueryContext context_of(Program& program) {
  return {program.session, program.stats, program.picture.toast, program.picture.title};
}

std::string title_of(const edit::SessionFindings& find) {
  return fmt::format("{}{} - coaster", find.session().document.name, edit::dirty(find) ? "*" : "");
}

std::filesystem::path default_track() {
  const std::filesystem::path data = base::data_folder(), track = data / "tracks" / "loop.json";
  std::error_code ignored;
  return !data.empty() && std::filesystem::exists(track, ignored) ? track : std::filesystem::path();
}

}  // namespace coaster::app
