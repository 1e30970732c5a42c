// What scripts and panels tell each other: widgets of the last frame, as the panels drew them, and lessons.
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

// A lesson's instruction to the player, from scripts to panels.
struct LessonCard {
  std::string text, widget;  // widget: path of the widget to highlight, "" for none
  int number = 1, count = 1;
  bool strayed = false;  // the track has changed since the lesson began
};
enum class LessonAnswer { none, show, leave };  // show: run the script's lines, from the track at the lesson's start

}  // namespace coaster::query
