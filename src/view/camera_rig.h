// The eye that goes from picture to picture: it rides, chases, orbits or flies, eases from one to the other, and is
// damped by ticks, never by a clock, so that a script's pictures are the same on every run. No part of document, undo
// or motion; nothing here is hashed.
#pragma once

#include <glm/gtc/quaternion.hpp>

#include "view/camera.h"
#include "view/damping.h"
#include "world/motion.h"

namespace coaster::view {

// What an eye looks at.
struct Watched {
  const world::Document& document;
  const sim::Derived& derived;
  const world::Motion& motion;
  const world::Settings& settings;
  bool eased = true;  // a change of camera takes kTransitionTicks
};

// The chosen camera, or orbit while there is no cart on any track to go with.
world::CameraMode shown_mode(const Watched& watched);

// The way a train heads over the ground as a damped angle. A loop is no turn: while the train is upside down the
// heading is held to the line that it was on, and near the vertical, where a tangent says little, it hardly moves.
struct Heading {
  double yaw = 0, rate = 0;  // rad as the orbit camera's yaw (0 is -Z), rad/s
  glm::dvec3 direction() const { return {-std::sin(yaw), 0, -std::cos(yaw)}; }
  void settle(const curve::Frame& frame);
  void follow(const curve::Frame& frame, double lag, double dt);
};

struct CameraRig {
  Eye eye;                                            // to look with: of the last follow()
  world::CameraMode mode = world::CameraMode::orbit;  // shown
  bool begun = false, reduced = false;

  // Of the cameras that go with a train; made anew where the train has leapt.
  bool with_train = false;
  glm::dvec3 anchor{0};  // m, where the train was
  Heading heading;
  glm::dvec3 forward{1, 0, 0}, up{0, 1, 0};  // the rider's, unit
  double roll_lag = 0,
         roll_rate = 0;  // rad by which `up` is behind the track's, over whole turns too; rad/s of `up` about `forward`
  Damped<double> widening, elevation, beside;  // degrees; rad over the horizon; rad to the train's left
  Damped<glm::dvec3> bob, aside;               // m on the seat's axes; m out of the way of the track

  // From the eye before to the one now: what is left of the difference.
  int ticks_left = 0;
  glm::dvec3 offset{0};
  glm::dquat turn{1, 0, 0, 0};
  double field_of_view_off = 0;
};
inline constexpr int kTransitionTicks = 48;  // 0.4 s

// Brings the rig up to the present state, `ticks` after the last call. While it goes with a train it wants to be called
// tick by tick (steps()), so that what it shows does not depend on how ticks are bundled; with 0 ticks after a command.
// Finite for every document.
void follow(CameraRig& rig, const Watched& watched, int ticks);
bool steps(const CameraRig& rig);

// For the two cameras that go with a train; private to them and to follow().
struct Ridden {
  world::Entity cart;
  const world::CartMotion& motion;
  sim::Pose front, middle;  // of the first car and of the train's middle
  double length = 0;        // m from the first car to the last
};
void settle_ride(CameraRig& rig, const Watched& watched, const Ridden& ridden);
Eye ride(CameraRig& rig, const Watched& watched, const Ridden& ridden, double dt);
void settle_chase(CameraRig& rig, const Watched& watched, const Ridden& ridden);
Eye chase(CameraRig& rig, const Watched& watched, const Ridden& ridden, double dt);

// How far the nearest piece of track is from a place, within `reach` metres, and where; 1 cm exact. About 10 ns a
// segment that is elsewhere.
struct NearTrack {
  double distance;  // m; infinity where there is none
  glm::dvec3 point;
};
NearTrack nearest_track(const sim::Derived& derived, glm::dvec3 from, double reach);

}  // namespace coaster::view
