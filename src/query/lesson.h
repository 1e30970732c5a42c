// A lesson's instruction to the player, from scripts to panels.
#pragma once

#include <string>

namespace coaster::query {

struct LessonCard {
  std::string text, widget;  // widget: path of the widget to highlight, "" for none
  int number = 1, count = 1;
  bool strayed = false;  // the track has changed since the lesson began
};
enum class LessonAnswer { none, show, leave };  // show: run the script's lines, from the track at the lesson's start

}  // namespace coaster::query
