// The file browser: the folder's path as buttons, its folders, and its files of known formats with size and time. Works
// by mouse or by arrows, Enter, Backspace and typing. Reads folders, writes nothing.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/folders.h"
#include "ui/context/ui.h"

namespace coaster::ui {

class FileBrowser {
 public:
  enum class Mode { open, save };
  enum class Answer { none, cancel, chosen, make_folder, system };

  // `folder` need not exist: the nearest one above it that does is shown. `name` is what saving begins with.
  void start(Mode mode, std::filesystem::path folder, std::string name);

  // The whole content of the current window, as wide and high as it is. `system`: whether the system's own dialog can
  // be asked for.
  Answer build(Ui& ui, const platform::Events& events, bool text_had_keyboard, bool system);

  Mode mode() const { return mode_; }
  const std::filesystem::path& folder() const { return folder_; }
  std::filesystem::path chosen() const { return chosen_; }
  // Shows a folder, or reads the same one again.
  void go(std::filesystem::path folder);

 private:
  using Entries = std::vector<const base::FolderEntry*>;
  void refresh(double seconds);
  Entries shown_entries() const;
  bool knows(const base::FolderEntry& entry) const;
  void draw_path(Ui& ui);
  Answer draw_list(Ui& ui, const Entries& entries, float height);
  bool draw_row(Ui& ui, const base::FolderEntry& entry);
  Answer draw_buttons(Ui& ui, const Entries& entries, bool system);
  Answer take_keys(const platform::Events& events, bool text_had_keyboard, const Entries& entries);
  Answer take_key(platform::Key key, const Entries& entries);
  void take_text(const std::string& utf8);
  Answer confirm(const Entries& entries);
  Answer choose_path(std::filesystem::path path);
  void up();
  void mark(const Entries& entries, std::ptrdiff_t index);

  Mode mode_ = Mode::open;
  std::filesystem::path folder_, chosen_;
  std::string words_;      // opening: what names must contain, or a path; saving: the file's name
  std::string marked_;     // name of the entry that is marked
  bool by_key_ = false;    // marked by an arrow: Enter then means the mark, not the name
  bool scroll_ = false;    // to the mark
  bool all_ = false;       // also files that no format is known for
  bool untouched_ = true;  // typing replaces the name
  double read_at_ = -1;    // s, of State::seconds
  std::string problem_;    // why the folder cannot be shown
  std::vector<base::FolderEntry> entries_;
};

}  // namespace coaster::ui
