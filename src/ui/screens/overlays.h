// What lies over the scene. Each is drawn only while it has something to show and the viewport has room for it.
#pragma once

#include "ui/context/ui.h"
#include "ui/tools/viewport_tool.h"

namespace coaster::ui {

// The title of the section under the mouse, beside it; in Build.
void draw_section_name(Ui& ui, const view::Viewport& scene);
// The hint at the bottom: the current transform, or what to click next. Drawn behind all windows.
void draw_foot_line(const Ui& ui, const ViewportTool& tool, const view::Viewport& scene);
// The first steps, in the lower left corner while Aids::show_hints.
void draw_hints(Ui& ui, const view::Viewport& scene);
// The legend of the track's colours, in the upper left corner. Drawn behind all windows.
void draw_legend(Ui& ui, const view::Viewport& scene);
// What a lesson of the tutorial points at.
struct LessonGuide {
  std::optional<Widget> target;  // its widget as last drawn, in sight or not; none where it names none
  std::optional<Widget> marked;  // it, or else the closed list or panel that holds it, in sight
  int number = 0, frames = 0;    // the lesson, 0 for none, and the frames it has shown
  bool begins(const query::LessonCard* lesson) const;
  // At the end of a frame, with its widgets.
  void follow(const query::LessonCard* lesson, const std::vector<Widget>& widgets);
};
// A rectangle on the screen, and the line from a card to what it points at, px.
struct LessonBox {
  glm::vec2 low{0}, high{0};
};
struct LessonLine {
  glm::vec2 from, to;
};
// Returns the line from the edge of the card to the target: it never crosses the card.
LessonLine lesson_line(const LessonBox& card, const LessonBox& target);
// A card, and a ring around what it points at.
void draw_lesson(Ui& ui, const view::Viewport& scene, const LessonGuide& guide);
// The score card at the end of a ride, a strip at the foot: how it ended, the challenge's verdict, the main values, and
// on request the others.
void draw_score_card(Ui& ui, const view::Viewport& scene);
// Progress of a file import, with a cancel button. Escape cancels, too.
void draw_job(Ui& ui, const view::Viewport& scene);
// Progress of the movie being recorded, with a stop button. Not in the movie.
void draw_movie(Ui& ui, const view::Viewport& scene);

}  // namespace coaster::ui
