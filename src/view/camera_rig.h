// The eye from picture to picture: it rides, chases, orbits or flies, and eases from one camera to the other. Damping
// depends on ticks, never on a clock, so a script's pictures are the same on every run. Not part of document, undo or
// motion; not hashed.
#pragma once

#include <glm/gtc/quaternion.hpp>

#include "sim/ride/ride.h"
#include "view/camera.h"
#include "world/motion.h"

namespace coaster::view {

// A value that follows another without overshoot: critical damping, solved exactly for a constant target during a step,
// so that two steps of one tick equal one step of two.
// x'' = -2 k x' - k^2 (x - target), k = 2 / lag. Lags a steadily moving target by `lag` seconds; lag 0 is the target
// itself.
template <class T>
struct Damped {
  T value{}, rate{};

  void approach(const T& target, double lag, double dt) {
    if (!(lag > 0)) {
      value = target, rate = T{};
      return;
    }
    const double k = 2.0 / lag, decay = std::exp(-k * dt);
    const T off = value - target, push = rate + k * off;
    value = target + (off + push * dt) * decay;
    rate = (rate - k * dt * push) * decay;
  }
  void settle(const T& target) { value = target, rate = T{}; }
};

// The state that a camera follows.
struct CameraSubject {
  const world::Document& document;
  const sim::DerivedTrack& derived;
  const world::Motion& motion;
  const world::Settings& settings;
  bool eased = true;                    // a change of camera takes kTransitionTicks
  const sim::Ground* ground = nullptr;  // null, or without a land: the plane y = 0
};

// Returns the selected camera, or orbit while there is no train.
world::CameraMode shown_mode(const CameraSubject& watched);

// The heading of a train over the ground, as a damped angle. A loop does not count as a turn: while the train is upside
// down the heading stays on its line, and near the vertical, where the tangent has little horizontal length, it hardly
// moves.
struct Heading {
  double yaw = 0, rate = 0;  // rad, as the orbit camera's yaw (0 is -Z), rad/s
  glm::dvec3 direction() const { return {-std::sin(yaw), 0, -std::cos(yaw)}; }
  void settle(const curve::Frame& frame);
  void follow(const curve::Frame& frame, double lag, double dt);
};

struct CameraRig {
  Eye eye;                                            // the result of the last follow()
  world::CameraMode mode = world::CameraMode::orbit;  // the camera shown
  bool begun = false, reduced = false;

  // State of the cameras that follow a train; reset when the train leaps.
  bool with_train = false;
  glm::dvec3 anchor{0};  // m, position of the train
  Heading heading;
  glm::dvec3 forward{1, 0, 0}, up{0, 1, 0};    // the rider's, unit
  double roll_lag = 0;                         // rad by which `up` lags the track's, including whole turns
  double roll_rate = 0;                        // rad/s of `up` about `forward`
  Damped<double> widening, elevation, beside;  // degrees; rad above the horizon; rad to the train's left
  Damped<double> inside;          // 0..1: the chase camera close behind the train, in a tunnel or a station
  Damped<glm::dvec3> bob, aside;  // m on the seat's axes; m to stay clear of the track

  // The transition from the previous eye to this one: the remaining offset.
  int ticks_left = 0;
  glm::dvec3 offset{0};
  glm::dquat turn{1, 0, 0, 0};
  double field_of_view_off = 0;
};
inline constexpr int kTransitionTicks = 48;  // 0.4 s

// Updates the rig to the present state, `ticks` after the last call. While it follows a train, call it tick by tick
// (steps()), so that the result does not depend on how ticks are grouped; call it with 0 ticks after a command. Finite
// for every document.
void follow(CameraRig& rig, const CameraSubject& watched, int ticks);
bool steps(const CameraRig& rig);

// State for the two cameras that follow a train; private to them and to follow(), as is the chase camera.
struct RiddenTrain {
  world::Entity cart;
  const world::TrainMotion& motion;
  sim::Pose front, middle;  // of the first car and of the train's middle
  double length = 0;        // m from the first car to the last
  sim::TrackPlace front_place = {};
};
void settle_chase(CameraRig& rig, const CameraSubject& watched, const RiddenTrain& ridden);
Eye chase(CameraRig& rig, const CameraSubject& watched, const RiddenTrain& ridden, double dt);

// The track nearest to a point within `reach` metres: its distance and position, exact to 1 cm. Costs about 10 ns per
// distant segment.
struct NearestTrack {
  double distance;  // m; infinity if there is none
  glm::dvec3 point;
};
NearestTrack nearest_track(const sim::DerivedTrack& derived, glm::dvec3 from, double reach);

}  // namespace coaster::view
