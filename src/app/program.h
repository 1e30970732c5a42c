// The state of a running program, and the only functions that change it.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/movie.h"
#include "app/options.h"
#include "app/pictures.h"
#include "app/user_data_keeper.h"
#include "base/crash_guard.h"
#include "base/files.h"
#include "edit/session/session.h"
#include "gfx/renderer.h"
#include "platform/sound.h"
#include "platform/surface.h"
#include "query/context.h"
#include "query/query.h"
#include "script/recorder.h"
#include "ui/host/host.h"
#include "view/camera_rig.h"
#include "view/ride_sound.h"

namespace coaster::edit {
struct ClosingSearch;
}

namespace coaster::app {

struct Program;

// The ride's sound in a window: opens the device when sound is on, and feeds it.
struct Sounds {
  std::unique_ptr<platform::SoundDevice> device;  // null: sound is off, or there is no device
  bool refused = false;                           // no device; tried again when sound is turned off and on
  int refusals = 0;                               // the first refusal, at the start, is not reported: sound is optional
  view::RideVoice voice;
};

// Updates the sound; call it once per frame of a window. Silent while a movie is recorded, because its time is not real
// time.
void keep_sounding(Program& program);

// Clocks of the frames, s.
struct FrameClock {
  double seconds = 0;                    // since the start, by the events
  double tick_debt = 0;                  // elapsed time that is less than a tick
  double last_frame = 0;                 // of a window, by the surface's clock
  double smoothed_frame = 0;             // smoothed duration of a window's frames
  double idle_from = 1, idle_until = 0;  // a window is idle between them (frame.cpp)
};

// The last picture that was drawn.
struct Picture {
  view::CameraRig rig;                   // camera of the picture; updated after every command and tick
  view::View view;                       // view of the picture
  view::Viewport free;                   // the part of the scene that no card covers
  view::Pick hovered;                    // under the cursor
  std::uint64_t tick = 0, commands = 0;  // of the session and of Program::commands, at the picture
  bool unseen = false;                   // true while its pixels are not drawn: they are drawn on demand (scene.h)
  std::string title;                     // of the window
  std::string toast;                     // notice shown by the panels
};

struct LongJob;  // app/long_job.h

// The script that teaches the player (script_host.cpp).
struct TutorialRun;

struct Tutorial {
  bool wanted = false;
  std::shared_ptr<TutorialRun> run;  // null: not running
  std::optional<query::LessonCard> card;
  // The state at the start of the lesson, which "Show me" restores.
  struct Start {
    world::Document document;
    world::Settings settings;
    std::uint64_t edits = 0;  // Session::edits
  } start;
  query::LessonAnswer answer = query::LessonAnswer::none;
};

struct Program {
  Program();
  ~Program();

  Options options;
  base::Files files;  // a script's files: only below its folder
  edit::Session session;
  std::uint64_t commands = 0;  // applied since the start
  bool by_hand = false;        // commands come from the user: camera changes are eased; those of a script are cuts
  bool quit = false;
  FrameClock time;

  std::unique_ptr<platform::Surface> surface;
  gfx::Gl gl;  // declared before its users, so that it is destroyed last
  std::unique_ptr<gfx::Renderer> renderer;
  std::unique_ptr<ui::Host> ui;
  Picture picture;
  query::FrameStats stats;

  std::unique_ptr<script::Recorder> recorder;       // null: not recording
  base::Status recorded;                            // why a recording ended early
  std::unique_ptr<UserDataKeeper> keeper;           // null: keeps no user data
  std::unique_ptr<MovieInProgress> filming;         // a movie in progress; null: none
  Sounds sounds;                                    // only in a window
  TrackPictures pictures;                           // for the start screen
  std::unique_ptr<LongJob> job;                     // an import, a search or a closing section in progress; null: none
  std::optional<base::PlannedCrash> planned_crash;  // by a script
  int job_delay = 0;                                // frames by which a script delays the next one
  platform::Events held_input;                      // held back while a job plans a closing section (long_job.h)
  Tutorial tutorial;
  // Disables saving at the end of memory once the program is destroyed.
  struct MemoryWatch {
    ~MemoryWatch() { base::on_memory_end({}); }
  } memory_watch{};
};

// Creates a window, or an off-screen surface if `headless`, with renderer and panels. Code::graphics if that is
// impossible. Until the first picture is drawn, a crash is taken for the driver's: it ends the program with one line
// and the exit code of Code::graphics.
base::Result<std::unique_ptr<Program>> make_program(const Options& options, platform::Size size, int samples);

// Ends the program at once if nothing can be drawn any more: autosaves, prints `why`, and exits with the code of
// Code::graphics. No destructor runs, since it may not use the surface.
[[noreturn]] void leave_without_graphics(Program& program, const std::string& why);

// Applies a command and records it. Errors also show as a notice. After opening or creating a track, the camera frames
// all of it, with the viewport of the last frame, so a frame must have been drawn.
base::Status apply(Program& program, const edit::Command& command, edit::ClosingSearch* search = nullptr);

// Ends the recording, if there is one. Returns the error because of which it is not complete.
base::Status finish_recording(Program& program);

// Advances the ride by whole ticks; prints the hashes of each if requested.
void advance(Program& program, int ticks);

// Returns the state that the camera shows.
view::CameraSubject watched(Program& program);

query::QueryContext context_of(Program& program);

// Returns "Red Comet* - coaster": the track's name, with a star if it is unsaved.
std::string title_of(const edit::SessionFindings& find);

// Returns the default track: tracks/loop.json of base::data_folder(); empty if it does not exist.
std::filesystem::path default_track();

}  // namespace coaster::app
