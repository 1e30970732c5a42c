// Questions over everything else, one at a time: what to do with unsaved changes, which file, whether to overwrite it,
// whether to recover an autosave; and the settings. While one is open, keys and mouse are its own. The document changes
// by the commands alone that answers lead to.
#pragma once

#include <string>
#include <utility>

#include "ui/screens/challenge_list.h"
#include "ui/screens/file_browser.h"

namespace coaster::ui {

// What is to follow once nothing unsaved can be lost.
struct Want {
  enum class Kind { nothing, fresh, browse, load, challenge, tutorial, quit } kind = Kind::nothing;
  std::string path;  // of load and challenge
};

class Dialogs {
 public:
  bool open() const { return stage_ != Stage::none; }

  // Does it, or asks first when there are unsaved changes.
  void request(Ui& ui, Want want);
  // To the document's own file; asks for one where it has none, or where somebody else edits it.
  void save(Ui& ui);
  void save_as(Ui& ui);
  void show_settings() { stage_ = Stage::settings; }
  // The list of challenges to choose from.
  void show_challenges() { stage_ = Stage::challenges, shelf_is_read_ = false; }

  // `text_had_keyboard`: a field did at the start of the frame. width, height: of the window, px.
  void build(Ui& ui, const platform::Events& events, bool text_had_keyboard, float width, float height);

 private:
  enum class Stage { none, unsaved, browse, overwrite, new_folder, recovery, settings, challenges };

  void proceed(Ui& ui);
  void abandon();
  void follow_save(Ui& ui);
  void browse(Ui& ui, FileBrowser::Mode mode);
  void take_file(Ui& ui, std::filesystem::path path, bool asked);
  void take_system(Ui& ui);
  void build_stage(Ui& ui, const platform::Events& events, bool text_had_keyboard);
  void build_unsaved(Ui& ui, const platform::Events& events);
  void build_browser(Ui& ui, const platform::Events& events, bool text_had_keyboard);
  void build_overwrite(Ui& ui, const platform::Events& events);
  void build_new_folder(Ui& ui, const platform::Events& events, bool text_had_keyboard);
  void build_recovery(Ui& ui);
  void build_challenges(Ui& ui);  // dialogs_challenges.cpp
  std::pair<float, float> wanted_size()
      const;  // design px; a height below 0: at least so much, and as high as what is in it

  Stage stage_ = Stage::none, shown_ = Stage::none;
  Want want_;
  bool saving_ = false;       // a save was asked for so that `want_` can follow
  bool asked_later_ = false;  // about recovery
  bool system_ = false;       // the system's dialog is awaited
  FileBrowser browser_;
  ChallengeShelf shelf_;
  bool shelf_is_read_ = false;
  int challenge_ = 0;  // the row that the keys are at
  std::filesystem::path chosen_;
  std::string folder_name_;
};

// The content of the settings window; true when it is to be closed. panel_settings.cpp.
bool build_settings(Ui& ui);

}  // namespace coaster::ui
