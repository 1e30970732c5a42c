#include "ui/tools/transform_math.h"

#include <cmath>

#include "view/pick.h"
#include "world/selection.h"

namespace coaster::ui {
namespace {

using glm::dvec2;
using glm::dvec3;

dvec3 unit(int axis) {
  dvec3 v(0);
  v[axis] = 1;
  return v;
}

// Returns the point nearest to the ray on the line through `pivot` along an axis.
std::optional<dvec3> meet_axis(const view::Ray& ray, dvec3 pivot, int axis) {
  const dvec3 a = unit(axis), d(ray.direction), off = dvec3(ray.origin) - pivot;
  const double cosine = glm::dot(a, d), sine2 = 1 - cosine * cosine;
  constexpr double kAlong = 1e-4;  // squared sine of the angle between axis and ray
  if (sine2 < kAlong) return std::nullopt;
  const double t = (glm::dot(off, a) - glm::dot(off, d) * cosine) / sine2;
  return std::abs(t) < world::kMaxCoordinate ? std::optional(pivot + t * a) : std::nullopt;
}

}  // namespace

std::optional<dvec3> meet(const view::View& view, glm::vec2 pixel, glm::vec3 pivot, const Constraint& constraint) {
  const view::Ray ray = view::ray_through(view, pixel);
  if (constraint.kind == Constraint::Kind::axis) return meet_axis(ray, dvec3(pivot), constraint.axis);
  const glm::vec3 normal(constraint.kind == Constraint::Kind::plane ? unit(constraint.axis)
                                                                    : dvec3(view::line_of_sight(view)));
  const auto hit = view::meet_plane(ray, pivot, normal);
  return hit ? std::optional(dvec3(*hit)) : std::nullopt;
}

glm::vec3 rotation_axis(const view::View& view, const Constraint& constraint) {
  return constraint.kind == Constraint::Kind::free ? view::line_of_sight(view) : glm::vec3(unit(constraint.axis));
}

double turned_angle(const view::View& view, glm::vec2 from, glm::vec2 to, glm::vec3 pivot, glm::vec3 axis) {
  const auto middle = view::project(view, pivot);
  if (!middle) return 0;
  const dvec2 a = dvec2(from) - dvec2(middle->x, middle->y), b = dvec2(to) - dvec2(middle->x, middle->y);
  if (!(glm::length(a) > 1) || !(glm::length(b) > 1)) return 0;
  // Pixels grow downwards: turning clockwise on the screen is right-handed about what points away from the eye.
  const double clockwise = std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b));
  return glm::dot(dvec3(axis), dvec3(view::line_of_sight(view))) >= 0 ? clockwise : -clockwise;
}

dvec3 snapped(const SnapScene& scene, world::SnapTo to, dvec3 position, dvec3 start, const Constraint& constraint) {
  dvec3 wanted = position;
  switch (to) {
    case world::SnapTo::off: break;
    case world::SnapTo::grid:
      for (int i = 0; i < 3; ++i)
        wanted[i] = std::round(position[i] / scene.settings.snapping.step) * scene.settings.snapping.step;
      break;
    case world::SnapTo::knots: {
      double least = 12.0 * static_cast<double>(view::mark_scale(scene.settings, scene.view));
      for (const world::Entity e : scene.document.track.knots) {
        if (world::is_selected(scene.settings, e)) continue;
        const glm::vec3 at = world::knot(scene.document, e).position;
        const auto seen = view::project(scene.view, at);
        if (!seen || std::abs(seen->z) > 1) continue;
        const double distance = glm::length(glm::vec2(seen->x, seen->y) - scene.cursor);
        if (distance < least) least = distance, wanted = dvec3(at);
      }
      break;
    }
    case world::SnapTo::ground:
      if (constraint.kind == Constraint::Kind::free)
        if (const auto hit = view::meet_plane(view::ray_through(scene.view, scene.cursor), glm::vec3(0), {0, 1, 0}))
          wanted = dvec3(*hit);
      wanted.y = 0;
      break;
  }
  for (int i = 0; i < 3; ++i)
    if (!constraint.allows(i)) wanted[i] = start[i];
  return wanted;
}

}  // namespace coaster::ui
