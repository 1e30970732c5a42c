// The orbit camera's matrices, rays and projections. Pixels have their origin at the top left.
#pragma once

#include <optional>
#include <span>

#include <glm/glm.hpp>

#include "world/document.h"
#include "world/settings.h"

namespace coaster::sim {
class Ground;
class Land;
struct DerivedTrack;
struct Pose;
}  // namespace coaster::sim

namespace coaster::view {

// A rectangle of the window in pixels.
struct Viewport {
  float x = 0, y = 0, width = 1, height = 1;
  bool contains(glm::vec2 p) const { return p.x >= x && p.y >= y && p.x < x + width && p.y < y + height; }
};

// Eye position and matrices of a picture.
struct View {
  glm::mat4 view{1}, projection{1};  // OpenGL clip space, right-handed
  glm::vec3 eye{0};                  // in an orthographic view: the eye of the corresponding perspective view
  Viewport viewport;
  float parallel = 0;  // m from the eye to the subject in an orthographic view; 0: perspective
  float reach = 1;     // sizes of targets when picking, as multiples of those that are drawn: larger for a finger
  float density = 1;   // pixels per point of the screen: 2 on a dense one. Marks and targets have their sizes in points
};
// Returns the metres that a pixel covers at `depth` metres in front of the eye; at any depth in an orthographic view.
float metres_per_pixel(const View& view, float depth);
// Return the unit directions into the picture, to its right and to its top.
inline glm::vec3 line_of_sight(const View& v) { return -glm::vec3(v.view[0][2], v.view[1][2], v.view[2][2]); }
inline glm::vec3 right_of(const View& v) { return {v.view[0][0], v.view[1][0], v.view[2][0]}; }
inline glm::vec3 top_of(const View& v) { return {v.view[0][1], v.view[1][1], v.view[2][1]}; }

struct Ray {
  glm::vec3 origin, direction;  // unit
  bool endless = false;         // extends to both sides: a line, as in an orthographic view
};

// An eye, independent of the size of the picture.
struct Eye {
  glm::dvec3 position{0, 5, 80};              // m, at least kLowestEye above the ground
  glm::dvec3 forward{0, 0, -1}, up{0, 1, 0};  // unit; `up` need not be perpendicular to `forward`, only not parallel
  double field_of_view_deg = 45;              // vertical
  double far_off = 0;                         // m, typical distance of the subject: the near plane moves away with it
  bool parallel = false;                      // orthographic; the picture is as high as a perspective one at far_off
};
inline constexpr float kLowestEye = 0.3f;  // m above ground and water
inline constexpr float kRiderEye = 1.1f;   // m above the rails

// Returns right, up and back of an eye as columns: unit, perpendicular. `up` must not be parallel to `forward`.
glm::dmat3 axes_of(const Eye& eye);

// Returns the height (m) of ground or water at a place; null, or without a land: that of the plane y = 0.
double surface_at(const sim::Ground* ground, double x, double z);

// Return the eyes of both cameras, which stay above ground and water; that of an orthographic view may be anywhere.
Eye orbit_eye(const world::Camera& camera, const sim::Ground* ground = nullptr);
Eye fly_eye(const world::FlyCamera& fly, float field_of_view_deg, const sim::Ground* ground = nullptr);
// Returns a place of the fly camera, raised to at least kLowestFlight above ground and water.
glm::vec3 above_ground(glm::vec3 eye, const sim::Ground* ground);
// Returns the eye on the seat of a car, looking forward.
Eye ride_eye(const sim::Pose& pose, float field_of_view_deg);
// Returns the view; a viewport of zero area counts as 1 x 1.
View view_of(const Eye& eye, Viewport viewport, float density = 1);

View orbit_view(const world::Camera& camera, Viewport viewport);

// Returns the perspective camera with the same direction; a top view becomes as steep as a camera can be.
world::Camera in_perspective(world::Camera camera);

// Returns the fly camera that is closest to this view.
world::FlyCamera fly_from(const View& view, const sim::Ground* ground = nullptr);

// Returns the window pixel of a world point, or nothing if it is behind the eye. z: depth as NDC in [-1,1].
std::optional<glm::vec3> project(const View& view, glm::vec3 world);
Ray ray_through(const View& view, glm::vec2 pixel);

// Returns where the ray meets the plane through `point` with `normal`; nothing if parallel, before its origin or beyond
// 1e5 m.
std::optional<glm::vec3> meet_plane(const Ray& ray, glm::vec3 point, glm::vec3 normal);
// Returns the place `over` m above the land, as people left it, or its water, where the ray first meets all such
// places; nothing if it does not within 2 km.
std::optional<glm::vec3> meet_land(const Ray& ray, const sim::Land& land, double over = 0);
// Returns the height (y) on the vertical line through `point` that is nearest to the ray.
std::optional<float> meet_vertical(const Ray& ray, glm::vec3 point);

inline constexpr float kMargin = 1.1f;  // a tenth of the picture stays free
// Returns the nearest camera with the same yaw and pitch that shows a box with a margin, at the viewport's aspect
// ratio.
world::Camera frame_box(const world::Camera& from, glm::vec3 low, glm::vec3 high, Viewport viewport);
// Returns the camera moved perpendicular to its line of sight, and back if that is not enough, by the least amount that
// shows all points in `free`, the part of the viewport that nothing covers, and leaves a margin: `free` is at least
// `margin` (>= 1) times as wide and high as what they take around its middle. No point is nearer than a fifth of its
// distance. Returns the camera itself if it already does.
world::Camera kept_in_view(const world::Camera& camera, std::span<const glm::vec3> points, Viewport viewport,
                           Viewport free, float margin = kMargin);
// Does the same as frame_box() for the whole track (40 m about the origin, on its land, if it is empty) or for one
// entity.
world::Camera frame_all(const world::Camera& from, const world::Document& document, Viewport viewport);
world::Camera frame_entity(const world::Camera& from, const world::Document& document, world::Entity entity,
                           Viewport viewport);

}  // namespace coaster::view
