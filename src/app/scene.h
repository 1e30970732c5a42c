// The scene of a frame: the findings that it needs, and its picture.
#pragma once

#include <vector>

#include "app/program.h"

namespace coaster::app {

// The view of a picture and the settings it is drawn with.
struct PictureSettings {
  const world::Settings& settings;  // those of the session, or a copy without the selection
  const view::View& view;
  view::Pick hovered;
  bool alone = false;   // without marks of knots
  bool unseen = false;  // everything except the pixels, because nobody will look at them
};

// What a picture shows besides the track and its trains.
struct PictureContents {
  view::MarkedFindings marked;
  const sim::TrackValues& values;
  const sim::Supports* supports;  // null: not shown
};
// Finds what a picture needs, seen from its eye.
PictureContents find_seen(Program& program, const PictureSettings& look);

// Adds land, plants and stations as a scenery shows them, after the scene's style is set.
void add_surroundings(gfx::Scene& scene, const edit::SessionFindings& find, world::Scenery scenery);
inline constexpr float kEyeRoom = 16;  // m about an eye that does not ride, where no plant stands in the view

// Draws the scene; the numbers of supports and colours go to program.stats.
gfx::DrawStats draw_scene(Program& program, const PictureSettings& look, const PictureContents& seen,
                          platform::Size size);

// Draws the pixels of the last frame. Without a window most frames are never looked at, so pixels are drawn on demand;
// the rest of a frame is always done.
void draw_pixels(Program& program);

// Draws the present scene from its eye without panels, marks of knots and selection into the renderer's picture,
// outside any frame and its statistics.
void draw_scene_alone(Program& program, platform::Size size);

// Returns the pose of each car of each train, for a picture from this eye.
std::vector<sim::Pose> cart_poses(const edit::Session& session, glm::vec3 eye);

}  // namespace coaster::app
