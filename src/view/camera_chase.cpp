// The eye behind a train: upright, at a fixed distance from the train's middle, on the damped heading, above the ground
// and clear of the track.
#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/shape/rails.h"
#include "view/camera_rig.h"
#include "world/camera_feel.h"

namespace coaster::view {
namespace {

using glm::dvec3;

constexpr double kChaseHeadingLag = 0.55, kElevationLag = 0.7, kAsideLag = 0.2;  // s
constexpr double kLookOver = 0.9;                                                // m above the rails
constexpr double kElevation = 0.30;  // rad above the horizon on level track; less uphill, more downhill
constexpr double kBySlope = 0.5, kLowest = 0.10, kHighest = 0.95;
constexpr double kBeside = 0.26;     // rad to the train's left, so that its side shows and the rails do not hide it
constexpr double kBesideOver = 0.6;  // rad more while it is upside down: shows a loop from the side
constexpr double kPerTrain = 0.6;    // m of distance per metre of train
constexpr double kOverGround = 1.2;  // m
constexpr double kClear = 2.4;       // m from the track that the eye keeps if possible
constexpr double kSightClear = 1.3;  // m from the track that the first half of the line of sight keeps
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double elevation_of(const Ridden& ridden) {
  const double slope = std::asin(std::clamp(ridden.middle.frame.forward.y, -1.0, 1.0));
  return std::clamp(kElevation - kBySlope * slope, kLowest, kHighest);
}

double beside_of(const Ridden& ridden) {
  return kBeside + kBesideOver * 0.5 * std::clamp(1 - ridden.middle.frame.up.y - 0.6, 0.0, 1.4);
}

dvec3 looked_at(const Ridden& ridden) { return ridden.middle.position + dvec3(0, kLookOver, 0); }

dvec3 place(const CameraRig& rig, const Watched& w, const Ridden& ridden) {
  const dvec3 ahead = rig.heading.direction(), left = glm::cross(dvec3(0, 1, 0), ahead);
  const double distance = w.settings.feel->chase_distance + kPerTrain * ridden.length, e = rig.elevation.value,
               b = rig.beside.value;
  dvec3 eye = looked_at(ridden) +
              distance * (std::cos(e) * (std::sin(b) * left - std::cos(b) * ahead) + dvec3(0, std::sin(e), 0));
  eye.y = std::max(eye.y, kOverGround);
  return eye;
}

// Returns `from` moved away from the track by the distance missing to `clear`.
dvec3 step_aside(const Watched& w, const dvec3& from, double clear) {
  const NearTrack near = nearest_track(w.derived, from, clear);
  if (!(near.distance < clear)) return dvec3(0);
  return (clear - near.distance) * (near.distance > 1e-3 ? (from - near.point) / near.distance : dvec3(0, 1, 0));
}

// Returns the offset that moves the eye clear of the track with a view of the train: a few steps away from the nearest
// track.
dvec3 way_out(const Watched& w, const dvec3& from, const dvec3& aside, const dvec3& to) {
  // Start halfway to the previous offset, so that the eye stays on the same side.
  dvec3 at = from + 0.5 * aside;
  constexpr int kMostSteps = 12;  // enough to leave a stack of coils
  for (int i = 0; i < kMostSteps; ++i) {
    dvec3 step = step_aside(w, at, kClear);
    for (const double part : {0.25, 0.5}) step += step_aside(w, glm::mix(at, to, part), kSightClear) / (1 - part);
    if (step == dvec3(0)) break;
    at += step;
    at.y = std::max(at.y, kOverGround);
  }
  return at - from;
}

double squared_distance_to_box(const curve::Box& box, const dvec3& p) {
  const dvec3 outside = glm::max(glm::max(dvec3(box.low) - p, p - dvec3(box.high)), dvec3(0));
  return glm::dot(outside, outside);
}

}  // namespace

NearTrack nearest_track(const sim::Derived& derived, dvec3 from, double reach) {
  NearTrack best{kInfinity, from};
  double best_squared = reach * reach;
  for (const world::Entity e : derived.order) {
    const sim::SegmentShape& shape = derived.shape(e);
    const auto [low, high] = curve::control_box(shape.key.cubic);
    const auto off_curve = static_cast<float>(std::abs(shape.key.rails));
    if (squared_distance_to_box({low - off_curve, high + off_curve}, from) >= best_squared) continue;
    // Chords of at most half a metre: less than a centimetre from a curve of 5 m radius.
    const int steps = std::clamp(static_cast<int>(shape.arc.length() * 2), 8, 512);
    dvec3 last = sim::rails_point(shape, 0.0);
    for (int i = 1; i <= steps; ++i) {
      const dvec3 next = sim::rails_point(shape, static_cast<double>(i) / steps), chord = next - last;
      const double square = glm::dot(chord, chord),
                   t = square > 0 ? std::clamp(glm::dot(from - last, chord) / square, 0.0, 1.0) : 0.0;
      const dvec3 point = last + t * chord, off = from - point;
      if (const double squared = glm::dot(off, off); squared < best_squared)
        best_squared = squared, best = {std::sqrt(squared), point};
      last = next;
    }
  }
  return best;
}

void settle_chase(CameraRig& rig, const Watched& w, const Ridden& ridden) {
  rig.elevation.settle(elevation_of(ridden));
  rig.beside.settle(beside_of(ridden));
  rig.aside.settle(way_out(w, place(rig, w, ridden), dvec3(0), looked_at(ridden)));
}

Eye chase(CameraRig& rig, const Watched& w, const Ridden& ridden, double dt) {
  rig.heading.follow(ridden.middle.frame, kChaseHeadingLag, dt);
  rig.elevation.approach(elevation_of(ridden), kElevationLag, dt);
  rig.beside.approach(beside_of(ridden), kElevationLag, dt);
  const dvec3 wanted = place(rig, w, ridden);
  rig.aside.approach(way_out(w, wanted, rig.aside.value, looked_at(ridden)), kAsideLag, dt);
  Eye eye;
  eye.position = wanted + rig.aside.value;
  eye.position.y = std::max(eye.position.y, kOverGround);
  const dvec3 to = looked_at(ridden) - eye.position;
  const double distance = glm::length(to);
  eye.forward = distance > 0.1 ? to / distance : rig.heading.direction();
  eye.up = {0, 1, 0};
  if (std::abs(eye.forward.y) > 0.9999) eye.up = rig.heading.direction();
  eye.field_of_view_deg = w.settings.camera.field_of_view_deg;
  return eye;
}

}  // namespace coaster::view
