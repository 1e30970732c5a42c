// The rider's eye: the track's frame with a lagging roll and a moving head, and a calm form of both (reduced motion).
#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "curve/frames.h"
#include "sim/ride/ride.h"
#include "view/camera_rig.h"
#include "world/camera_feel.h"

namespace coaster::view {
namespace {

using glm::dvec3;

constexpr double kRiderHeadingLag = 0.5;  // s
constexpr double kWideningLag = 0.8;      // s
constexpr double kWideSpeed = 30;         // m/s, where the view has widened by the full setting
constexpr double kSteepest = 0.8;         // rad, limit of the calm view's pitch
constexpr double kBobLag = 0.12;          // s, time constant of the neck
constexpr double kBobUp = 0.02, kBobSide = 0.03, kMostBob = 0.07;  // m per g, m per g, m
constexpr double kRumble = 0.003;                                  // m at 20 m/s

double wrapped(double angle) { return std::remainder(angle, 2 * base::kPi); }

// Returns the head's offset: against g, plus a small shake. The distance travelled is the only clock.
dvec3 bob_of(const Watched& w, const Ridden& ridden) {
  const sim::Felt g = sim::felt(w.document, w.derived, ridden.cart, ridden.motion);
  const double shake = kRumble * std::min(std::abs(ridden.motion.speed) / 20, 1.5), d = ridden.motion.travelled;
  const auto part = [](double metres) { return std::isfinite(metres) ? std::clamp(metres, -kMostBob, kMostBob) : 0.0; };
  return {0, part(kBobUp * (1 - g.up)) + shake * std::sin(2 * base::kPi * d / 3.1),
          part(-kBobSide * g.left) + shake * std::sin(2 * base::kPi * d / 4.7)};
}

// Turns the rider's up: carried along by the least rotation, then rolled after the track's roll.
void roll_after(CameraRig& rig, const curve::Frame& frame, double lag, double dt) {
  dvec3 up = curve::across(curve::least_rotation(rig.forward, frame.forward, rig.up, rig.up), frame.forward);
  const double length = glm::length(up);
  rig.forward = frame.forward;
  if (!(length > 1e-6) || !(lag > 0)) {
    rig.up = frame.up, rig.roll_lag = rig.roll_rate = 0;
    return;
  }
  up /= length;
  // Beyond half a turn the lag is ambiguous: take the value nearest to the last one.
  const double seen = curve::signed_angle(up, frame.up, frame.forward);
  rig.roll_lag += wrapped(seen - rig.roll_lag);
  Damped<double> roll{-rig.roll_lag, rig.roll_rate};
  roll.approach(0, lag, dt);
  rig.up = curve::rotate(up, frame.forward, roll.value + rig.roll_lag);
  rig.roll_lag = -roll.value, rig.roll_rate = roll.rate;
}

}  // namespace

void Heading::settle(const curve::Frame& frame) {
  // On vertical track the rider's left defines the heading.
  const dvec3 left = frame.left();
  dvec3 flat(frame.forward.x, 0, frame.forward.z);
  if (glm::length(flat) < 0.3) flat = {-left.z, 0, left.x};
  yaw = glm::length(flat) > 1e-6 ? std::atan2(-flat.x, -flat.z) : 0.0;
  rate = 0;
}

void Heading::follow(const curve::Frame& frame, double lag, double dt) {
  constexpr double kUpright = 0.2;               // of up's height
  constexpr double kVague = 0.15, kClear = 0.6;  // of the tangent's horizontal length
  const dvec3 f = frame.forward;
  const double flat = std::sqrt(f.x * f.x + f.z * f.z),
               part = std::clamp((flat - kVague) / (kClear - kVague), 0.0, 1.0);
  double off = flat > 1e-9 ? wrapped(std::atan2(-f.x, -f.z) - yaw) : 0.0;
  if (frame.up.y < kUpright && std::cos(off) < 0) off = wrapped(off + base::kPi);
  const double k = 2 / lag;
  for (double rest = dt; rest > 1e-9; rest -= world::kTick) {  // small steps, because the pull changes with the angle
    const double step = std::min(rest, world::kTick);
    rate += step * (k * k * part * off - 2 * k * rate);
    yaw += step * rate, off -= step * rate;
  }
  yaw = wrapped(yaw);
}

void settle_ride(CameraRig& rig, const Watched& w, const Ridden& ridden) {
  rig.forward = ridden.front.frame.forward, rig.up = ridden.front.frame.up;
  rig.roll_lag = rig.roll_rate = 0;
  rig.widening.settle(w.settings.feel->widening_deg * std::min(1.5, std::abs(ridden.motion.speed) / kWideSpeed));
  rig.bob.settle(w.settings.feel->head_bob ? bob_of(w, ridden) : dvec3(0));
}

Eye ride(CameraRig& rig, const Watched& w, const Ridden& ridden, double dt) {
  const world::CameraFeel& feel = *w.settings.feel;
  const curve::Frame& frame = ridden.front.frame;
  roll_after(rig, frame, feel.roll_damping, dt);
  rig.heading.follow(frame, kRiderHeadingLag, dt);
  rig.widening.approach(
      feel.reduced_motion ? 0.0 : feel.widening_deg * std::min(1.5, std::abs(ridden.motion.speed) / kWideSpeed),
      kWideningLag, dt);
  rig.bob.approach(feel.head_bob && !feel.reduced_motion ? bob_of(w, ridden) : dvec3(0), kBobLag, dt);
  Eye eye;
  eye.position = ridden.front.position + (kRiderEye + rig.bob.value.y) * frame.up + rig.bob.value.z * frame.left();
  eye.position.y = std::max(eye.position.y, static_cast<double>(kLowestEye));
  eye.field_of_view_deg =
      std::min<double>(world::kMaxFieldOfView, feel.ride_view_deg + (feel.reduced_motion ? 0.0 : rig.widening.value));
  eye.forward = frame.forward, eye.up = rig.up;
  if (feel.reduced_motion) {
    const double pitch = std::clamp(std::asin(std::clamp(frame.forward.y, -1.0, 1.0)), -kSteepest, kSteepest);
    eye.forward = std::cos(pitch) * rig.heading.direction() + dvec3(0, std::sin(pitch), 0);
    eye.up = {0, 1, 0};
  }
  return eye;
}

}  // namespace coaster::view
