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

  // `folder` need not exist: its nearest existing parent is shown. `name` is the initial name when saving.
  void start(Mode mode, std::filesystem::path folder, std::string name);

  // Builds the content of the current window, in its size. `system`: the system's own dialog is available.
  Answer build(Ui& ui, const platform::Events& events, bool text_had_keyboard, bool system);

  Mode mode() const { return mode_; }
  const std::filesystem::path& folder() const { return folder_; }
  std::filesystem::path chosen() const { return chosen_; }
  // Shows a folder, or reads the current one again.
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
  std::string words_;      // opening: a part of names, or a path; saving: the file's name
  std::string marked_;     // name of the highlighted entry
  bool by_key_ = false;    // highlighted by an arrow key: Enter then uses the entry, not the name
  bool scroll_ = false;    // to the highlighted entry
  bool all_ = false;       // also files of unknown formats
  bool untouched_ = true;  // typing replaces the name
  double read_at_ = -1;    // s, as UiState::seconds
  std::string problem_;    // why the folder cannot be shown
  std::vector<base::FolderEntry> entries_;
};

}  // namespace coaster::ui
