// Dear ImGui on any surface: fed from the event list, drawn by our own renderer over the GL table. Builds the panels
// and the viewport tool from const state and returns the commands they want; changes nothing itself.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "edit/commands/commands.h"
#include "exchange/own/progress_file.h"
#include "exchange/own/settings_file.h"
#include "gfx/gl.h"
#include "platform/events.h"
#include "query/lesson.h"
#include "query/query.h"
#include "view/camera_rig.h"
#include "view/overlay.h"

namespace coaster::ui {

// A widget as last drawn, for scripts: path "Panel/Label" or "Panel/Group/Label".
struct Widget {
  std::string path;
  std::string kind;  // button, radio, checkbox, slider, number, text, combo, header, menu, item, label
  float x = 0, y = 0, width = 0, height = 0;  // px
  bool visible = true;                        // inside its clip rectangle
  bool enabled = true;
  bool covered = false;  // another window lies over its middle
  std::string value;     // shown value or "on"/"off"
};

// An autosave that another run left, offered for recovery.
struct RecoveryOffer {
  std::string original, name;  // the file (empty: none) and the track's name
  std::int64_t file_time = 0,
               time = 0;  // of the file's last change (0: it is not there) and of the autosave, s since 1970
};

// The desktop's own file dialog, in a process of its own.
struct SystemDialog {
  bool available = false, running = false;
  std::optional<std::string> answer;  // in the frame after it has ended: the file, "" when it was cancelled
};

// What is kept for the user from run to run, and about files; app fills it in. Without it nothing is kept, and nothing
// offered.
struct UserState {
  exchange::UserSettings settings;
  std::vector<RecoveryOffer> recoveries;  // the first is asked about
  std::string holder;                     // who else edits the document's file; empty: nobody
  SystemDialog system;
  exchange::Progress progress;       // in challenges
  std::filesystem::path challenges;  // folder of the user's own; empty: none
};

// Of a track's file, for the start screen.
struct TrackPicture {
  unsigned texture = 0;  // GL name, 16:9; 0 when there is none
  std::string name;      // the track's
  double length = 0;     // m
  std::string problem;   // why there is none
};

// A movie that is being made.
struct MovieState {
  int frames = 0;             // pictures taken
  std::int64_t ticks = 0;     // of the ride so far
  double done = 0;            // 0..1 of the lap, then of the movie file
  bool encoding = false;      // all pictures are taken, the file is being made
  int width = 0, height = 0;  // px, of the pictures; 0: as the window
};
enum class MovieWish { none, start, stop };

// What panels read.
struct State {
  edit::Finder find;  // shows the session, and finds out what a panel wants to know
  const query::FrameStats& stats;
  double seconds;                        // since start, for fading notices and the cursor's blink
  bool scripted;                         // times and fps read "--"
  const view::CameraRig* rig = nullptr;  // what pictures are taken with; null: settled at the state
  const UserState* kept = nullptr;
  const base::Progress* importing = nullptr;  // a file that is being read
  const query::LessonCard* lesson = nullptr;
  const std::map<std::string, TrackPicture>* pictures = nullptr;  // by path
  const MovieState* movie = nullptr;                              // null: none is made
  const edit::Session& session = find.session();
};

enum class Recovery { recover, discard, later };  // later: asked again at the next start
struct SystemDialogRequest {
  bool save = false;
  std::string folder, name;
};

// What a frame of the UI decides.
struct Output {
  std::vector<edit::Command> commands;
  view::View view;  // how to take the picture
  view::Pick hovered;
  bool quit = false;
  bool wants_screenshot = false;
  bool cancel_import = false;
  MovieWish movie = MovieWish::none;
  std::optional<exchange::UserSettings> settings;  // to keep instead of the present ones
  std::optional<Recovery> recovery;                // the answer about the first offer
  query::LessonAnswer lesson_answer = query::LessonAnswer::none;
  bool wants_tutorial = false;
  std::vector<std::string> wanted_pictures;          // files of tracks, the most wanted first
  std::optional<std::string> new_folder;             // to make
  std::optional<SystemDialogRequest> system_dialog;  // to open
};

class Host {
 public:
  static base::Result<std::unique_ptr<Host>> make(const gfx::Gl& gl, float content_scale);
  ~Host();
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  // One frame: feeds the events, builds menu, panels, viewport tool and status bar. width, height >= 1.
  Output build(const platform::Events& events, const State& state, int width, int height);
  // Draws what build() laid out into the bound framebuffer of that size.
  void draw(int width, int height);

  // Keys in place of the table's; returns what could not be done, a line each.
  std::vector<std::string> set_keys(std::span<const exchange::KeyChoice> choices);
  // The start screen: over everything until something is chosen.
  void show_start();
  // Columns, headers and the laboratory's strip as at the first start.
  void reset_layout();

  const std::vector<Widget>& widgets() const;  // of the last build
  const view::View& view() const;              // of the last build
  std::string toast() const;                   // text of the newest notice still shown
  // Where a widget scrolled out of sight would need the wheel: +1 down, -1 up, 0 in sight; and opening closed headers
  // on its path. True while a text field or a popup has the keyboard.
  bool wants_keyboard() const;

 private:
  struct Parts;
  explicit Host(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace coaster::ui
