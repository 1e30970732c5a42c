// Matrices, rays and projections of eyes, and the distance that shows a whole box. Following a train is in
// camera_rig.cpp; drawing is in gfx.
#include "view/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/gtc/matrix_transform.hpp>

#include "curve/cubic.h"
#include "sim/ground/ground.h"
#include "sim/ride/ride.h"
#include "world/sections.h"

namespace coaster::view {
namespace {

constexpr float kNearPlane = 0.2f;      // m
constexpr float kFarPlane = 20'000.0f;  // m, at least; more for distant eyes
constexpr float kNearest = 2.0f;        // m, the smallest distance of framing
constexpr float kFurthest = 1e5f;       // m, for intersections

Viewport with_area(Viewport v) {
  if (!(v.width >= 1)) v.width = 1;
  if (!(v.height >= 1)) v.height = 1;
  return v;
}

// Returns the direction from the target to the eye. Yaw 0 looks along -Z, so the eye is on +Z.
glm::vec3 towards_eye(float yaw_deg, float pitch_deg) {
  const float yaw = glm::radians(yaw_deg), pitch = glm::radians(std::clamp(pitch_deg, -89.0f, 89.0f));
  return {std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch)};
}

// Returns the axes of a camera: to the right, to the top and back of its picture.
glm::mat3 axes_of(const world::Camera& camera) {
  switch (camera.projection) {
    case world::Projection::front: return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    case world::Projection::side: return {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}};
    case world::Projection::top: return {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}};
    case world::Projection::perspective: break;
  }
  const glm::vec3 back = towards_eye(camera.yaw_deg, camera.pitch_deg);
  const glm::vec3 right = glm::normalize(glm::cross(glm::vec3(0, 1, 0), back));
  return {right, glm::cross(back, right), back};
}

// Returns the nearest camera with the same yaw and pitch that shows all points p for which each_point() calls visit(p):
// a long track has millions.
world::Camera frame_points(const world::Camera& from, Viewport viewport, const auto& each_point) {
  viewport = with_area(viewport);
  world::Camera out = from;
  const glm::mat3 axes = axes_of(from);
  const glm::vec3 right = axes[0], up = axes[1], back = axes[2];
  // Depth does not affect an orthographic view.
  const float by_depth = from.projection == world::Projection::perspective ? 1.0f : 0.0f;
  const float tan_y = std::tan(glm::radians(from.field_of_view_deg) * 0.5f) / kMargin,
              tan_x = tan_y * viewport.width / viewport.height;
  // A point at x across and b towards the eye is visible from an eye at x0, d if |x - x0| <= (d - b) tan. The largest x
  // + b tan and -x + b tan of all points give the nearest eye that sees them all, and its position; the same for y.
  constexpr float kLowest = std::numeric_limits<float>::lowest();
  float right_most = kLowest, left_most = kLowest, top = kLowest, bottom = kLowest, nearest = kLowest,
        furthest = kLowest;
  each_point([&](glm::vec3 p) {
    const float x = glm::dot(p, right), y = glm::dot(p, up), b = glm::dot(p, back);
    const float in_x = by_depth * b * tan_x, in_y = by_depth * b * tan_y;
    right_most = std::max(right_most, x + in_x), left_most = std::max(left_most, -x + in_x);
    top = std::max(top, y + in_y), bottom = std::max(bottom, -y + in_y);
    nearest = std::max(nearest, b), furthest = std::max(furthest, -b);
  });
  const float eye = std::max((right_most + left_most) / (2 * tan_x), (top + bottom) / (2 * tan_y));
  const float middle = 0.5f * (nearest - furthest);
  out.target = 0.5f * (right_most - left_most) * right + 0.5f * (top - bottom) * up + middle * back;
  out.distance = std::max(kNearest, eye - by_depth * middle);
  return out;
}

}  // namespace

glm::vec3 above_ground(glm::vec3 eye, const sim::Ground* ground) {
  const double surface = surface_at(ground, static_cast<double>(eye.x), static_cast<double>(eye.z));
  return {eye.x, std::max(eye.y, world::kLowestFlight + static_cast<float>(surface)), eye.z};
}

glm::dmat3 axes_of(const Eye& eye) {
  const glm::dvec3 forward = glm::normalize(eye.forward), right = glm::normalize(glm::cross(forward, eye.up));
  return {right, glm::cross(right, forward), -forward};
}

View view_of(const Eye& eye, Viewport viewport, float density) {
  View out;
  out.viewport = with_area(viewport);
  out.density = density;
  out.eye = glm::vec3(eye.position);
  // Built from the direction itself: eye + forward would lose it to rounding when the eye is kilometres away.
  const glm::dmat3 to_eye = glm::transpose(axes_of(eye));
  out.view = glm::mat4(glm::dmat4(to_eye));
  out.view[3] = glm::vec4(glm::vec3(-(to_eye * glm::dvec3(out.eye))), 1);
  const float fov = glm::radians(
      std::clamp(static_cast<float>(eye.field_of_view_deg), world::kMinFieldOfView, world::kMaxFieldOfView));
  if (eye.parallel) {
    // The eye's own plane is no limit: everything in front of and behind it shows.
    out.parallel = std::max(static_cast<float>(eye.far_off), 0.1f);
    const float half = out.parallel * std::tan(0.5f * fov), wide = half * out.viewport.width / out.viewport.height;
    out.projection = glm::orthoRH_NO(-wide, wide, -half, half, -kFarPlane, kFarPlane);
    return out;
  }
  // The near plane moves away with the viewing distance, so that depth stays precise over a large track.
  const float far_off = static_cast<float>(eye.far_off), near_plane = std::max(kNearPlane, far_off * 2e-3f),
              far_plane = std::max(kFarPlane, far_off * 4.0f);
  out.projection = glm::perspectiveRH_NO(fov, out.viewport.width / out.viewport.height, near_plane, far_plane);
  return out;
}

double surface_at(const sim::Ground* ground, double x, double z) {
  return ground != nullptr ? ground->surface(x, z) : 0;
}

Eye orbit_eye(const world::Camera& camera, const sim::Ground* ground) {
  const float distance = std::max(camera.distance, 0.1f);
  if (camera.projection != world::Projection::perspective) {
    const glm::dmat3 axes(axes_of(camera));
    const double far_off = distance;
    return {glm::dvec3(camera.target) + far_off * axes[2], -axes[2], axes[1], camera.field_of_view_deg, far_off, true};
  }
  const glm::vec3 back = towards_eye(camera.yaw_deg, camera.pitch_deg);
  glm::vec3 eye = camera.target + back * distance;
  const float lowest =
      kLowestEye + static_cast<float>(surface_at(ground, static_cast<double>(eye.x), static_cast<double>(eye.z)));
  eye.y = std::max(eye.y, lowest);
  // The difference to a distant target is exact enough only where the ground has moved the eye.
  glm::vec3 forward = -back;
  if (eye.y == lowest && glm::distance(camera.target, eye) > 1e-4f) forward = glm::normalize(camera.target - eye);
  // From a raised eye the target can be straight below: then the yaw's forward direction is up in the picture.
  const float yaw = glm::radians(camera.yaw_deg);
  const glm::vec3 up =
      std::abs(forward.y) > 0.99999f ? glm::vec3(-std::sin(yaw), 0, -std::cos(yaw)) : glm::vec3(0, 1, 0);
  return {eye, forward, up, camera.field_of_view_deg, distance};
}

Eye fly_eye(const world::FlyCamera& fly, float field_of_view_deg, const sim::Ground* ground) {
  const glm::vec3 forward = -towards_eye(fly.yaw_deg, -fly.pitch_deg), eye = above_ground(fly.eye, ground);
  return {eye, forward, {0, 1, 0}, field_of_view_deg, 0};
}

Eye ride_eye(const sim::Pose& pose, float field_of_view_deg) {
  const glm::vec3 up(pose.frame.up), eye = glm::vec3(pose.position) + kRiderEye * up;
  return {eye, glm::vec3(pose.frame.forward), up, field_of_view_deg, 0};
}

View orbit_view(const world::Camera& camera, Viewport viewport) { return view_of(orbit_eye(camera), viewport); }

world::FlyCamera fly_from(const View& view, const sim::Ground* ground) {
  const glm::vec3 forward = line_of_sight(view), up = top_of(view);
  // Looking straight up or down, the picture's up direction defines the yaw.
  const glm::vec3 ahead = std::abs(forward.y) < 0.9999f ? forward : -std::copysign(1.0f, forward.y) * up;
  world::FlyCamera fly;
  fly.eye = above_ground(view.eye, ground);
  fly.yaw_deg = glm::degrees(std::atan2(-ahead.x, -ahead.z));
  fly.pitch_deg = std::clamp(glm::degrees(std::asin(std::clamp(forward.y, -1.0f, 1.0f))), -89.0f, 89.0f);
  return fly;
}

float metres_per_pixel(const View& view, float depth) {
  return 2 * (view.parallel > 0 ? 1 : depth) / (view.projection[1][1] * std::max(1.0f, view.viewport.height));
}

world::Camera in_perspective(world::Camera camera) {
  if (camera.projection == world::Projection::perspective) return camera;
  const glm::vec3 back = axes_of(camera)[2];
  camera.yaw_deg = glm::degrees(std::atan2(back.x, back.z));
  camera.pitch_deg = back.y > 0 ? world::kMaxPitch : 0;
  camera.projection = world::Projection::perspective;
  return camera;
}

std::optional<glm::vec3> project(const View& view, glm::vec3 world) {
  const glm::vec4 clip = view.projection * (view.view * glm::vec4(world, 1));
  if (!(clip.w > 1e-4f)) return std::nullopt;
  const glm::vec3 ndc = glm::vec3(clip) / clip.w;
  const Viewport& v = view.viewport;
  return glm::vec3(v.x + (ndc.x + 1) * 0.5f * v.width, v.y + (1 - ndc.y) * 0.5f * v.height, ndc.z);
}

Ray ray_through(const View& view, glm::vec2 pixel) {
  const Viewport& v = view.viewport;
  const float x = ((pixel.x - v.x) / v.width * 2 - 1) / view.projection[0][0];
  const float y = (1 - (pixel.y - v.y) / v.height * 2) / view.projection[1][1];
  if (view.parallel > 0) return {view.eye + x * right_of(view) + y * top_of(view), line_of_sight(view), true};
  // The view matrix is a rotation and a translation: its transpose inverts the rotation.
  return {view.eye, glm::normalize(glm::transpose(glm::mat3(view.view)) * glm::vec3(x, y, -1))};
}

std::optional<glm::vec3> meet_plane(const Ray& ray, glm::vec3 point, glm::vec3 normal) {
  const float towards = glm::dot(ray.direction, normal);
  if (!(std::abs(towards) > 1e-6f * glm::length(normal))) return std::nullopt;
  const float distance = glm::dot(point - ray.origin, normal) / towards;
  if (!(distance >= 0 || ray.endless) || !(std::abs(distance) <= kFurthest)) return std::nullopt;
  return ray.origin + distance * ray.direction;
}

std::optional<glm::vec3> meet_land(const Ray& ray, const sim::Land& land, double over) {
  const glm::dvec3 down(0, over, 0), direction(ray.direction);
  glm::dvec3 origin(ray.origin);
  if (ray.endless) origin -= static_cast<double>(kFurthest) * direction;  // of an orthographic view
  const double most = 2000 + (ray.endless ? 2 * static_cast<double>(kFurthest) : 0.0);
  const auto distance = land.meet(origin - down, direction, most);
  return distance ? std::optional(glm::vec3(origin + *distance * direction)) : std::nullopt;
}

std::optional<float> meet_vertical(const Ray& ray, glm::vec3 point) {
  // Nearest points of the ray o + a d and the line p + b Y: the component of o - p + a d perpendicular to Y is
  // perpendicular to d.
  const glm::dvec3 d(ray.direction), w = glm::dvec3(ray.origin) - glm::dvec3(point);
  const double flat = 1.0 - d.y * d.y;
  if (!(flat > 1e-8)) return std::nullopt;
  const double along = -(w.x * d.x + w.z * d.z) / flat;
  if (!(along >= 0 || ray.endless) || !(std::abs(along) <= kFurthest)) return std::nullopt;
  return static_cast<float>(ray.origin.y + along * d.y);
}

world::Camera kept_in_view(const world::Camera& camera, std::span<const glm::vec3> points, Viewport viewport,
                           Viewport free, float margin) {
  if (points.empty()) return camera;
  viewport = with_area(viewport), free = with_area(free);
  const glm::mat3 axes = axes_of(camera);
  const float by_depth = camera.projection == world::Projection::perspective ? 1.0f : 0.0f;
  const glm::vec2 size(viewport.width, viewport.height), free_size(free.width, free.height);
  const glm::vec2 tangent = std::tan(glm::radians(camera.field_of_view_deg) * 0.5f) * glm::vec2(size.x / size.y, 1);
  const glm::vec2 off = (2.0f * glm::vec2(free.x - viewport.x, free.y - viewport.y) + free_size - size) / size;
  const glm::vec2 centre(off.x, -off.y), half = free_size / size / margin;
  // From an eye at x0, d back, a point at x, b back shows if -(d - b) under <= x - x0 <= (d - b) over: bounds of x0,
  // and likewise of y0.
  const glm::vec2 over = tangent * (half + centre), under = tangent * (half - centre);
  const float distance = std::max(camera.distance, kNearest);
  const glm::vec2 middle(glm::dot(camera.target, axes[0]), glm::dot(camera.target, axes[1]));
  const float back = glm::dot(camera.target, axes[2]);
  glm::vec2 most(std::numeric_limits<float>::lowest()), least(most);
  float nearest = -distance;  // m, the largest b
  for (const glm::vec3 p : points) {
    const glm::vec2 at(glm::dot(p, axes[0]), glm::dot(p, axes[1]));
    const float b = by_depth * (glm::dot(p, axes[2]) - back);
    nearest = std::max(nearest, b);
    most = glm::max(most, at + b * over), least = glm::max(least, b * under - at);
  }
  const glm::vec2 needed = (most + least) / (over + under);  // the distance at which both bounds meet
  world::Camera out = camera;
  out.distance = std::max({distance, needed.x, needed.y, nearest + 0.2f * distance});
  const glm::vec2 low = most - out.distance * over, high = out.distance * under - least;
  const glm::vec2 to = glm::clamp(middle, glm::min(low, high), glm::max(low, high));
  out.target += (to.x - middle.x) * axes[0] + (to.y - middle.y) * axes[1];
  return out;
}

world::Camera frame_box(const world::Camera& from, glm::vec3 low, glm::vec3 high, Viewport viewport) {
  return frame_points(from, viewport, [&](const auto& visit) {
    for (int i = 0; i < 8; ++i)
      visit(glm::vec3(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z));
  });
}

world::Camera frame_all(const world::Camera& from, const world::Document& document, Viewport viewport) {
  if (document.track.knots.empty()) {
    const auto ground = static_cast<float>(sim::Land(document.park).surface(0, 0));
    return frame_box(from, {-20, ground, -20}, {20, ground + 10, 20}, viewport);
  }
  // Track has a volume, and a single knot should not fill the picture.
  const float half = 1 + static_cast<float>(std::abs(world::rails_height(document)));
  return frame_points(from, viewport, [&](const auto& visit) {
    const auto around = [&](glm::vec3 p) {
      for (const glm::vec3 by : {glm::vec3(1, 1, 1), glm::vec3(-1, 1, -1), glm::vec3(1, -1, -1), glm::vec3(-1, -1, 1)})
        visit(p + half * by);
    };
    for (const world::Entity e : document.track.knots) around(world::knot(document, e).position);
    // Sampled, because control points can be far outside the curve.
    for (const world::Entity e : document.track.segments) {
      const curve::Cubic cubic = world::cubic_of(document, e);
      for (int i = 1; i < 8; ++i) around(glm::vec3(curve::point(cubic, i / 8.0)));
    }
  });
}

world::Camera frame_entity(const world::Camera& from, const world::Document& document, world::Entity entity,
                           Viewport viewport) {
  if (const world::Knot* const knot = document.entities.find<world::Knot>(entity)) {
    const glm::vec3 p = knot->position, in = world::in_handle(*knot), out = world::out_handle(*knot);
    return frame_box(from, glm::min(glm::min(in, out), p) - glm::vec3(1), glm::max(glm::max(in, out), p) + glm::vec3(1),
                     viewport);
  }
  if (const world::Train* const cart = document.entities.find<world::Train>(entity)) entity = cart->segment;
  std::span<const world::Entity> segments;
  if (document.entities.find<world::Section>(entity)) {
    const world::SectionRun run = world::run_of(document, entity);
    segments = std::span(document.track.segments).subspan(run.first, run.count);
  } else if (document.entities.find<world::Segment>(entity)) {
    segments = {&entity, 1};
  }
  if (segments.empty()) return frame_all(from, document, viewport);
  curve::Box box = curve::control_box(world::cubic_of(document, segments.front()));
  for (const world::Entity e : segments.subspan(1)) {
    const curve::Box next = curve::control_box(world::cubic_of(document, e));
    box = {glm::min(box.low, next.low), glm::max(box.high, next.high)};
  }
  return frame_box(from, box.low - glm::vec3(1), box.high + glm::vec3(1), viewport);
}

}  // namespace coaster::view
