// Settings of the cameras that follow a train.
#pragma once

#include "world/camera.h"
#include "world/setting_row.h"

namespace coaster::world {

inline constexpr float kMinChase = 5, kMaxChase = 60;  // m

struct CameraFeel {
  float ride_view_deg = 70;
  float widening_deg = 6;
  float roll_damping = 0.25f;  // s by which the rider's roll lags in a steady roll; 0: no lag
  float chase_distance = 9;    // m
  bool reduced_motion = false;
  bool head_bob = false;
  bool follow = false;
  friend bool operator==(const CameraFeel&, const CameraFeel&) = default;

  static constexpr auto kRows = std::tuple{
      setting(&CameraFeel::ride_view_deg, "camera.ride_view", "Vertical field of view of the rider.",
              {.low = kMinFieldOfView, .high = kMaxFieldOfView, .unit = "degrees", .query = "ride_view"}),
      setting(&CameraFeel::widening_deg, "camera.widening", "How much the rider's view widens at 30 m/s.",
              {.low = 0, .high = 20, .unit = "degrees", .query = "widening"}),
      setting(&CameraFeel::roll_damping, "camera.roll_damping", "Lag of the rider's roll behind the track's. 0: none.",
              {.low = 0, .high = 2, .unit = "s", .query = "roll_damping"}),
      setting(&CameraFeel::chase_distance, "camera.chase_distance", "Distance from the chase camera to a lone car.",
              {.low = kMinChase, .high = kMaxChase, .unit = "m", .query = "chase_distance"}),
      setting(&CameraFeel::reduced_motion, "camera.reduced_motion",
              "Whether the rider's horizon stays level, cameras cut, and nothing bobs or widens.",
              {.query = "reduced_motion", .kept_as = "reduced_motion"}),
      setting(&CameraFeel::head_bob, "camera.head_bob", "Whether the rider's head moves with g.",
              {.query = "head_bob", .kept_as = "head_bob"}),
      setting(&CameraFeel::follow, "camera.follow",
              "Whether the orbit camera follows the open end and the preview when they leave the picture.",
              {.query = "follow", .kept_as = "follow", .for_user = 1})};
};

}  // namespace coaster::world
