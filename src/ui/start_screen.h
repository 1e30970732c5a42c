// The first thing that is seen: what to go on with, and the tracks by their pictures. While it is open keys and mouse are its own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ui/widgets.h"

namespace coaster::ui {

class StartScreen {
 public:
  bool open() const { return open_; }
  void show() { open_ = true, samples_.clear(); }
  void hide() { open_ = false; }

  // width, height: of the window, px. Nothing is drawn while it is closed.
  void build(Ui& ui, const platform::Events& events, float width, float height);

 private:
  void build_choices(Ui& ui, float width);
  void build_tracks(Ui& ui);
  // A picture with its name below it, a widget with this label; true when it was clicked.
  bool card(Ui& ui, const std::filesystem::path& file, const std::string& label, float width);
  void load(Ui& ui, const std::filesystem::path& file);

  bool open_ = false;
  std::vector<std::filesystem::path> samples_;  // found when it was opened
};

}  // namespace coaster::ui
