// A widget of the last frame, as the panels drew it: for queries, scripts and lessons.
#pragma once

#include <string>
#include <string_view>

namespace coaster::query {

// Its path is "Panel/Label" or "Panel/Group/Label".
struct Widget {
  std::string path;   // made of the visible parts of labels
  std::string kind;   // button, radio, checkbox, slider, number, text, cell, combo, header, menu, item, label
  std::string value;  // shown value or "on"/"off"
  float x = 0, y = 0, width = 0, height = 0;  // px
  bool visible = true;                        // inside its clip rectangle
  bool enabled = true;
  bool covered = false;    // another window lies over its middle
  std::string alias = {};  // made of the ids of labels, if different: the path before a label changed
  bool cut = false;        // its label does not fit

  bool is(std::string_view name) const { return path == name || (!alias.empty() && alias == name); }
  // Returns what it shows: its value; of a button or a text without a value, its label.
  std::string text() const {
    const bool labelled = kind == "button" || kind == "label";
    return value.empty() && labelled ? path.substr(path.rfind('/') + 1) : value;
  }
};

}  // namespace coaster::query
