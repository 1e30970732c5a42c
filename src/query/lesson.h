// What a player is asked to do next, as scripts say it and panels show it.
#pragma once

#include <string>

namespace coaster::query {

struct LessonCard {
  std::string text, widget;  // widget: the path of what to look at, "" for none
  int number = 1, count = 1;
};
enum class LessonAnswer { none, show, leave };  // show: let the script do it

}  // namespace coaster::query
