// The output of a frame of the UI: commands, the view, and requests that the program carries out.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "edit/commands/command.h"
#include "exchange/own/settings_file.h"
#include "query/lesson.h"
#include "view/camera.h"
#include "view/pick.h"
#include "world/force_program.h"

namespace coaster::ui {

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
