// Overlays on the scene. Each is drawn only while it has content and the viewport has space for it.
#pragma once

#include <cstdint>
#include <string>

#include "edit/session/session.h"
#include "ui/context/ui.h"
#include "ui/tools/viewport_tool.h"
#include "view/camera.h"

namespace coaster::ui {

// Draws the title of the section under the mouse next to it; in Build.
void draw_section_name(Ui& ui, const view::Viewport& scene);
// Returns the hint at the bottom: the current transform, or what to click next; "" for none.
std::string foot_text(const ViewportTool& tool, const edit::Session& session, const KeyMap& keys);
// Draws the hint at the bottom: the current transform, or what to click next. It is behind all windows.
void draw_foot_line(const Ui& ui, const ViewportTool& tool, const view::Viewport& scene);
// Draws the first steps in the lower left corner while EditingAids::show_hints.
void draw_hints(Ui& ui, const view::Viewport& scene);
// Returns the part of the scene right of the first steps if they show and leave `width` px; else the scene.
view::Viewport beside_hints(const Ui& ui, const view::Viewport& scene, float width);
// Draws the legend of the track's colours in the upper left corner. It is behind all windows.
void draw_legend(Ui& ui, const view::Viewport& scene);
// The widget that a lesson of the tutorial points at.
struct LessonGuide {
  std::optional<Widget> target;  // that widget as last drawn, visible or not; nothing if the lesson names none
  std::optional<Widget> marked;  // the widget if visible, else the closed list or panel that contains it
  int number = 0, frames = 0;    // number of the lesson, 0 for none, and the frames since it began
  bool begins(const query::LessonCard* lesson) const;
  // Updates the guide at the end of a frame from its widgets.
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
// Draws the score card at the end of a ride, a strip at the bottom: the result, the challenge's verdict, the main
// values, and on request the others. Returns the part of the scene above it.
view::Viewport draw_score_card(Ui& ui, const view::Viewport& scene);
// Draws the progress of a job, if there is one, with a cancel button. Returns true if the user cancels; Escape does,
// too.
bool draw_job(WidgetFrame& ui, const view::Viewport& scene, const JobState& job);
// Draws the progress of the movie being recorded, with a stop button. It is not in the movie.
void draw_movie(Ui& ui, const view::Viewport& scene);

// The newest notice, shown at the bottom of the viewport for a few seconds; in scripts (no clock) until the next one.
// Above it are the warnings of the same command, such as those of a file above the note about its start speed.
struct NoticeDisplay {
  std::string shown;  // "" if there is none
  edit::NoticeKind kind = edit::NoticeKind::info;
  double since = 0;  // s
  double lasts = 0;  // s, time on screen
  std::uint64_t serial = 0;
  double updated = 0;  // s, time of the last update

  // Takes the newest notices of the session and drops the expired ones. While a dialog is `over` them, their time does
  // not run.
  void update(const edit::Session& session, double seconds, bool scripted, bool over = false);
  // Shows a notice of the UI about input that causes no command.
  void show(edit::NoticeKind what, std::string text, double seconds);
  // Returns the time from `seconds` until the notice begins to fade; afterwards 0, without a notice infinity.
  double still_for(double seconds) const;
  void draw(const Ui& ui, const view::Viewport& viewport) const;
};

}  // namespace coaster::ui
