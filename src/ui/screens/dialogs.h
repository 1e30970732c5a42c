// Modal dialogs, one at a time: unsaved changes, choosing a file, overwriting, a file changed by another program, a new
// folder, recovering an autosave, settings, challenges, how points become a track. An open dialog takes all keys and
// the mouse. The document changes only by the commands that answers emit.
#pragma once

#include <string>
#include <utility>

#include "exchange/formats.h"
#include "ui/screens/file_browser.h"
#include "ui/screens/start_screen.h"

namespace coaster::ui {

class Dialogs {
 public:
  bool open() const { return dialog_ != Dialog::none; }

  // Carries out a request, or first asks about unsaved changes. ScreenRequest::Kind::save writes to the document's own
  // file; it asks for a file if there is none, or if another program has it open.
  void take(Ui& ui, ScreenRequest want);

  // `text_had_keyboard`: a text field had it at the start of the frame. width, height: size of the window, px.
  void build(Ui& ui, const platform::Events& events, bool text_had_keyboard, float width, float height);

 private:
  enum class Dialog { none, unsaved, browse, overwrite, changed, new_folder, recovery, settings, challenges, import };

  void request(Ui& ui, ScreenRequest want);
  void save(Ui& ui);
  void proceed(Ui& ui);
  void perform(Ui& ui, const ScreenRequest& want);
  void replace(Ui& ui, const ScreenRequest& want);
  void abandon();
  void follow_save(Ui& ui);
  void write(Ui& ui, const std::filesystem::path& path, bool overwrite);
  void browse(Ui& ui, FileBrowser::Mode mode, bool sections = false);
  void take_file(Ui& ui, std::filesystem::path path, bool asked);
  std::filesystem::path lost_file() const;  // what saving to chosen_ may overwrite
  void take_system(Ui& ui);
  void build_shown(Ui& ui, const platform::Events& events, bool text_had_keyboard);
  void build_unsaved(Ui& ui, const platform::Events& events);
  void build_browser(Ui& ui, const platform::Events& events, bool text_had_keyboard);
  void build_overwrite(Ui& ui, const platform::Events& events);
  void build_changed(Ui& ui, const platform::Events& events);
  void build_new_folder(Ui& ui, const platform::Events& events, bool text_had_keyboard);
  void build_recovery(Ui& ui);
  void build_challenges(Ui& ui);
  void build_import(Ui& ui, const platform::Events& events, bool text_had_keyboard);
  std::pair<float, float> wanted_size()
      const;  // design px; a height below 0: as high as the content, at least that much

  Dialog dialog_ = Dialog::none, shown_ = Dialog::none;
  ScreenRequest want_;
  bool saving_ = false;       // a save is in progress; `want_` follows
  bool asked_later_ = false;  // the user postponed the question about recovery
  bool system_ = false;       // the system's dialog is open
  FileBrowser browser_;
  bool sections_ = false;                                  // the browser shows files of sections, not of tracks
  bool park_ = false;                                      // exports hold the park, too
  std::optional<std::vector<ChallengeEntry>> challenges_;  // read when the dialog is first built
  int challenge_ = 0;                                      // the highlighted row
  exchange::ImportQuestion question_;
  std::filesystem::path chosen_;
  std::string folder_name_;
};

// True if one of the keys was pressed; repeats do not count. Keypad Enter counts as Enter.
bool pressed(const platform::Events& events, platform::Key a, platform::Key b = platform::Key::unknown);
// True if Ctrl+V was pressed; it opens a copied link even while a dialog has the keyboard.
bool pasted(const platform::Events& events);

// Returns the default file name of a track with this name.
std::string file_name_for(const std::string& track);

// Builds the content of the settings window (settings_window.cpp). Returns true when it is to be closed.
bool build_settings(Ui& ui, const platform::Events& events);

}  // namespace coaster::ui
