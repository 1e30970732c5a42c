// The input of a frame of the UI: the session, and the user's data that is kept besides it, read only. And its output:
// commands, the view, and requests that the program carries out.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/cancellable_job.h"
#include "edit/commands/command.h"
#include "edit/session/findings.h"
#include "edit/session/session.h"
#include "exchange/own/challenge_progress_file.h"
#include "exchange/own/settings_file.h"
#include "query/frame_stats.h"
#include "query/widget.h"
#include "view/camera.h"
#include "view/camera_rig.h"
#include "view/pick.h"
#include "world/force_program.h"

namespace coaster::ui {

// An autosave that another run left, offered for recovery.
struct RecoveryOffer {
  std::string original, name;  // the file (empty: none) and the name of the track
  std::int64_t file_time = 0,
               time = 0;  // last change of the file (0: it does not exist) and of the autosave, s since 1970
};

// The desktop's file dialog, which runs in its own process.
struct SystemDialog {
  bool available = false, running = false;
  std::optional<std::string> answer;  // set in the frame after it has ended: the file, "" if cancelled
};

// The user's data that is kept between runs, filled in by app.
struct UserState {
  exchange::UserSettings settings;
  std::vector<RecoveryOffer> recoveries;  // the first one is offered
  std::string holder;                     // the process that has the document's file open; empty: none
  SystemDialog system;
  exchange::PlayerProgress progress;  // medals and results of challenges
  std::filesystem::path challenges;   // folder of the user's own challenges; empty: none
};

// A track file on the start screen.
struct TrackPicture {
  unsigned texture = 0;  // GL name, 16:9; 0 if there is none
  std::string name;      // name of the track
  double length = 0;     // m
  std::string problem;   // why there is no picture
};

// The movie being recorded.
struct MovieState {
  int frames = 0;             // pictures taken so far
  std::int64_t ticks = 0;     // ride time so far
  double done = 0;            // 0..1: of the lap, then of the movie file
  bool encoding = false;      // all pictures are taken; the movie file is being written
  int width = 0, height = 0;  // size of the pictures, px; 0: as the window
};

// A command that runs in a thread.
struct JobState {
  const base::JobProgress* progress = nullptr;  // null: none
  std::string_view panel, title;                // "Import", "Fitting a track to the imported points"
};

struct UiState {
  edit::SessionFindings find;  // the session, and the findings that a panel requests
  const query::FrameStats& stats;
  double seconds;                        // since start, for fading notices and the cursor's blink
  bool scripted;                         // times and fps read "--"
  const view::CameraRig* rig = nullptr;  // the camera; null: derived from the session
  const UserState* kept = nullptr;       // null: no user data is kept
  JobState job = {};                     // a job that takes long enough to show
  bool waiting = false;                  // a command is carried out once a job has ended
  const query::LessonCard* lesson = nullptr;
  const std::map<std::string, TrackPicture>* pictures = nullptr;  // by path
  const MovieState* movie = nullptr;                              // null: no movie is being recorded
  float content_scale = 1;                                        // pixels per point of the screen
  const edit::Session& session = find.session();
};

enum class MovieRequest { none, start, stop };
enum class PictureRequest { none, scene, window };
enum class RecoveryAnswer { recover, discard, later };  // later: offered again at the next start
struct SystemDialogRequest {
  bool save = false;
  std::string folder, name;
};

// The section, channel and position at which copied force keys are pasted.
struct ForceKeyPlace {
  world::EntityName section;
  world::ForceChannel channel{};
  double at = 0;  // m or s, the unit of the section's program
};

struct Output {
  std::vector<edit::Command> commands;
  view::View view;      // of the scene
  view::Viewport free;  // the part of the scene that nothing covers
  view::Pick hovered;
  bool quit = false;
  bool wants_paste = false;  // paste sections or a link from the clipboard, or else the sections copied last
  // Where force keys are pasted instead, if the clipboard holds some or they were copied last.
  std::optional<ForceKeyPlace> keys_to = {};
  bool wants_link = false;  // of the clipboard, if that is one
  bool toggles_full_screen = false;
  bool takes_text = false;  // what is typed goes to a text
  PictureRequest photo = PictureRequest::none;
  bool cancel_job = false;
  MovieRequest movie = MovieRequest::none;
  std::optional<exchange::UserSettings> settings;  // new settings to keep
  std::optional<RecoveryAnswer> recovery;          // the answer to the first offer
  query::LessonAnswer lesson_answer = query::LessonAnswer::none;
  bool wants_tutorial = false;
  std::vector<std::string> wanted_pictures;          // track files, most wanted first
  int picture_width = 0;                             // px, as wide as they show
  std::optional<std::string> new_folder;             // folder to create
  std::optional<SystemDialogRequest> system_dialog;  // dialog to open
};

}  // namespace coaster::ui
