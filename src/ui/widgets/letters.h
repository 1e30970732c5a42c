// The panels' fonts, with the letters that texts need.
#pragma once

#include <imgui.h>

#include <set>
#include <string>
#include <vector>

namespace coaster::ui {

class Letters {
 public:
  // Loads the fonts of the current context if `scale` changed or the last frame showed letters for the first time:
  // those of Inter, else of the system's fonts, else a box for each. Returns true if it did. Call outside a frame.
  bool load(float scale);
  float scale() const { return scale_; }  // of the last load()

 private:
  struct File {
    std::string path, bytes;
    int index = 0;
  };
  bool build();
  ImFont* add_font(float pixels, const ImWchar* base) const;
  bool add_files(const std::set<ImWchar>& blocks);

  float scale_ = 0;
  std::set<ImWchar> blocks_;  // of letters, by the first one (imgui_compat.h)
  std::vector<File> files_;
  std::vector<ImWchar> ranges_;  // of Inter's and the files' letters; the fonts refer to it
};

}  // namespace coaster::ui
