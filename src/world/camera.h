// The orbit camera and the free camera, from which views are made.
#pragma once

#include <cstdint>
#include <span>

#include <glm/glm.hpp>

#include "base/enum_names.h"
#include "world/setting_row.h"

namespace coaster::world {

enum class CameraMode : std::uint8_t { orbit, ride, chase, fly };
inline constexpr base::NameRow kCameraModes[] = {
    {"orbit", "Orbit"}, {"ride", "Ride"}, {"chase", "Chase"}, {"fly", "Fly"}};
constexpr std::span<const base::NameRow> rows_of(CameraMode) { return kCameraModes; }
// The projection of the orbit camera. The last three are orthographic along an axis, for any yaw and pitch.
enum class Projection : std::uint8_t { perspective, front, side, top };
inline constexpr base::NameRow kProjections[] = {
    {"perspective", "Perspective", "Distant objects are smaller."},
    {"front", "Front", "Orthographic, along -Z: x to the right, height up."},
    {"side", "Side", "Orthographic, along -X: z to the left, height up."},
    {"top", "Top", "Orthographic, from above: x to the right, z down."}};
constexpr std::span<const base::NameRow> rows_of(Projection) { return kProjections; }

inline constexpr float kMaxPitch = 89;                               // degrees
inline constexpr float kMinFieldOfView = 30, kMaxFieldOfView = 110;  // degrees, vertical

// The orbit camera: looks at `target` from `distance` metres; yaw about +Y (0 looks along -Z), pitch above the horizon
// (up to kMaxPitch either way; the view keeps it above the ground). The chase and fly cameras have the same vertical
// field of view.
struct Camera {
  glm::vec3 target{0, 5, 0};
  float yaw_deg = 35, pitch_deg = 18, distance = 80;
  float field_of_view_deg = 45;
  Projection projection = Projection::perspective;
  friend bool operator==(const Camera&, const Camera&) = default;

  static constexpr auto kRows = std::tuple{
      setting(&Camera::field_of_view_deg, "camera.field_of_view",
              "Vertical field of view of all cameras but the rider's.",
              {.low = kMinFieldOfView, .high = kMaxFieldOfView, .unit = "degrees", .query = "field_of_view"}),
      setting(&Camera::projection, "camera.projection",
              "Perspective, or an orthographic view from the front, the side or "
              "above. Its height is that of the perspective view at the target.",
              {.query = "projection"})};
};

// The fly camera: level, at `eye` (m), yaw as the orbit camera's, pitch above the horizon (up to kMaxPitch).
struct FlyCamera {
  glm::vec3 eye{0, 12, 60};  // at least kLowestFlight above the ground
  float yaw_deg = 0, pitch_deg = -6;
  friend bool operator==(const FlyCamera&, const FlyCamera&) = default;
};
inline constexpr float kLowestFlight = 0.5f;  // m

}  // namespace coaster::world
