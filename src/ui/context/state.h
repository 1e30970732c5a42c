// The input of a frame of the UI: the session, and the user's data that is kept besides it. Read only.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/cancellable_job.h"
#include "edit/session/findings.h"
#include "edit/session/session.h"
#include "exchange/own/challenge_progress_file.h"
#include "exchange/own/settings_file.h"
#include "query/frame_stats.h"
#include "query/lesson.h"
#include "view/camera_rig.h"

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

}  // namespace coaster::ui
