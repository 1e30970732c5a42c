// What a frame of the UI decides: commands, the view, and wishes that the program fulfils.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "edit/commands/command.h"
#include "exchange/own/settings_file.h"
#include "query/lesson.h"
#include "view/camera.h"
#include "view/pick.h"
#include "world/force.h"

namespace coaster::ui {

enum class MovieWish { none, start, stop };
enum class PhotoWish { none, scene, window };
enum class Recovery { recover, discard, later };  // later: offered again at the next start
struct SystemDialogRequest {
  bool save = false;
  std::string folder, name;
};

// A place for copied keys of forces.
struct KeysPlace {
  world::Name section;
  world::ForceChannel channel{};
  double at = 0;  // m or s, as the section's program
};

struct Output {
  std::vector<edit::Command> commands;
  view::View view;  // of the scene
  view::Pick hovered;
  bool quit = false;
  bool wants_paste = false;  // of sections: of the clipboard, or those that were copied here; or of a link
  // Where keys of forces go instead, if the clipboard has some, or they were copied here last.
  std::optional<KeysPlace> keys_to = {};
  bool wants_link = false;  // of the clipboard, if that is one
  bool toggles_full_screen = false;
  bool takes_text = false;  // what is typed goes to a text
  PhotoWish photo = PhotoWish::none;
  bool cancel_job = false;
  MovieWish movie = MovieWish::none;
  std::optional<exchange::UserSettings> settings;  // to keep instead of the present ones
  std::optional<Recovery> recovery;                // the answer to the first offer
  query::LessonAnswer lesson_answer = query::LessonAnswer::none;
  bool wants_tutorial = false;
  std::vector<std::string> wanted_pictures;          // files of tracks, the most wanted first
  std::optional<std::string> new_folder;             // to make
  std::optional<SystemDialogRequest> system_dialog;  // to open
};

}  // namespace coaster::ui
