// Advances the cameras of riding, chasing, orbiting and flying.
#include "view/camera_rig.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/glm.hpp>

#include "base/portable_math.h"
#include "curve/frames.h"
#include "sim/ground/ground.h"
#include "sim/ride/train.h"
#include "sim/shape/frame_methods.h"
#include "sim/shape/rails.h"
#include "sim/solids/coaster_form.h"
#include "world/appearance_settings.h"
#include "world/camera_feel.h"

namespace coaster::view {
namespace {

using glm::dvec3;

constexpr double kChaseHeadingLag = 0.55, kElevationLag = 0.7, kAsideLag = 0.2;  // s
constexpr double kLookOver = 0.9;                                                // m above the rails
constexpr double kElevation = 0.30;  // rad above the horizon on level track; less uphill, more downhill
constexpr double kHanging = 0.25;    // rad, most above and below a train that hangs
constexpr double kBySlope = 0.5, kLowest = 0.10, kHighest = 0.95;
constexpr double kBeside = 0.26;         // rad to the train's left, so that its side shows and the rails do not hide it
constexpr double kBesideHanging = 0.75;  // the same for a train that hangs
constexpr double kBesideOver = 0.6;      // rad more while it is upside down: shows a loop from the side
constexpr double kPerTrain = 0.6;        // m of distance per metre of train
constexpr double kOverGround = 1.2;      // m
constexpr double kInsideLag = 0.35;      // s, to go into the tube of a tunnel, or below a station's roof
constexpr double kBeforeRoof = 1;        // s before a tunnel or a station, and at least
constexpr double kLeastBefore = 8;       // m
constexpr double kTubeNearer = 0.6;      // of the distance behind the train, within a tube
constexpr double kInTube = 1, kTubeEdge = 0.5;  // m over its middle, if no train hangs; m from its wall
constexpr double kClear = 2.4;                  // m from the track that the eye keeps if possible
constexpr double kSightClear = 1.3;             // m from the track that the first half of the line of sight keeps
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A train that hangs below its rails is seen from its own height: from above, the spine hides it.
bool hangs(const CameraSubject& w) { return sim::form_of(w.derived.made.kind).side < 0; }

double elevation_of(const CameraSubject& w, const RiddenTrain& ridden) {
  const double slope = std::asin(std::clamp(ridden.middle.frame.forward.y, -1.0, 1.0));
  const double over = kElevation - kBySlope * slope;
  return hangs(w) ? std::clamp(over - kElevation, -kHanging, kHanging) : std::clamp(over, kLowest, kHighest);
}

double beside_of(const CameraSubject& w, const RiddenTrain& ridden) {
  return (hangs(w) ? kBesideHanging : kBeside) +
         kBesideOver * 0.5 * std::clamp(1 - ridden.middle.frame.up.y - 0.6, 0.0, 1.4);
}

dvec3 looked_at(const CameraSubject& w, const RiddenTrain& ridden) {
  const double over = hangs(w) ? sim::form_of(w.derived.made.kind).eye : kLookOver;
  return ridden.middle.position + dvec3(0, over, 0);
}

double distance_to(const CameraSubject& w, const RiddenTrain& ridden) {
  return w.settings.feel->chase_distance + kPerTrain * ridden.length;
}

// Returns the least height of a chasing eye.
double least_height(const CameraSubject& w, const dvec3& eye) {
  return surface_at(w.ground, eye.x, eye.z) + kOverGround;
}

bool on_land(const CameraSubject& w) { return w.ground != nullptr && !w.ground->plain(); }

sim::TrackRoom room_of(const CameraSubject& w) { return sim::track_room(sim::form_of(w.derived.made.kind)); }

bool in_tunnel(const CameraSubject& w, double distance) {
  return w.ground != nullptr && w.ground->tunnel_at(distance) != nullptr;
}

// The place on the track from where a train in a tunnel is seen, or in a station: behind it in the middle of the tube.
struct TubePlace {
  dvec3 axis{0}, eye{0};
  bool in_tunnel = false;
};
TubePlace tube_place(const CameraSubject& w, const RiddenTrain& ridden) {
  const double behind = 0.5 * ridden.length + kTubeNearer * distance_to(w, ridden);
  const sim::TrackPlace place = sim::behind(w.derived, ridden.front_place, behind);
  const sim::Pose pose = sim::pose(w.derived, place, world::FrameMethod::knots);
  TubePlace tube;
  tube.axis = pose.position + room_of(w).lift * pose.frame.up;
  tube.eye = tube.axis + (hangs(w) ? 0 : kInTube) * pose.frame.up;
  tube.in_tunnel = in_tunnel(w, w.derived.starts[place.index] + place.s);
  return tube;
}

// True where scenery shows the roof of a station over the track.
bool at_station(const CameraSubject& w, double distance) {
  if (w.settings.look->scenery == world::Scenery::plain) return false;
  const world::Entity segment = w.derived.order[sim::place_at(w.derived, distance).index];
  const auto* const equipment = w.document.entities.find<world::Equipment>(segment);
  return equipment != nullptr && equipment->kind == world::EquipmentKind::station;
}

// True from before the train enters a tunnel or a station until the eye outside would be out of the hill or the roof.
bool near_roof(const CameraSubject& w, const RiddenTrain& ridden) {
  if (!(w.derived.length > 0)) return false;
  constexpr double kStep = 3, kAfter = 5, kMostBefore = 150;  // m
  const double front = w.derived.starts[ridden.front_place.index] + ridden.front_place.s, length = w.derived.length;
  const double to = front + std::clamp(kBeforeRoof * std::abs(ridden.motion.speed), kLeastBefore, kMostBefore);
  for (double s = front - 0.5 * ridden.length - distance_to(w, ridden) - kAfter; s <= to; s += kStep) {
    const double at = w.derived.closed ? s - length * std::floor(s / length) : s;
    if (in_tunnel(w, at) || at_station(w, at)) return true;
  }
  return false;
}

dvec3 place(const CameraRig& rig, const CameraSubject& w, const RiddenTrain& ridden) {
  const dvec3 ahead = rig.heading.direction(), left = glm::cross(dvec3(0, 1, 0), ahead);
  const double distance = distance_to(w, ridden), e = rig.elevation.value, b = rig.beside.value;
  dvec3 eye = looked_at(w, ridden) +
              distance * (std::cos(e) * (std::sin(b) * left - std::cos(b) * ahead) + dvec3(0, std::sin(e), 0));
  eye.y = std::max(eye.y, least_height(w, eye));
  return eye;
}

// Returns the eye of the chase camera, taken close behind the train where that is near a tunnel or a station.
dvec3 kept_in_tube(const CameraRig& rig, const CameraSubject& w, const RiddenTrain& ridden, dvec3 eye) {
  const double share = std::clamp(rig.inside.value, 0.0, 1.0);
  if (share < 1e-3) return eye;
  const TubePlace tube = tube_place(w, ridden);
  eye = glm::mix(eye, tube.eye, share);
  if (!tube.in_tunnel) return {eye.x, std::max(eye.y, surface_at(w.ground, eye.x, eye.z) + double{kLowestEye}), eye.z};
  const dvec3 off = eye - tube.axis;
  const double away = glm::length(off), most = room_of(w).tube - kTubeEdge;
  return away > most ? tube.axis + most / away * off : eye;
}

// Returns `from` moved away from the track by the distance missing to `clear`.
dvec3 step_aside(const CameraSubject& w, const dvec3& from, double clear) {
  const NearestTrack near = nearest_track(w.derived, from, clear);
  if (!(near.distance < clear)) return dvec3(0);
  return (clear - near.distance) * (near.distance > 1e-3 ? (from - near.point) / near.distance : dvec3(0, 1, 0));
}

// Returns the offset that moves the eye clear of the track with a view of the train: a few steps away from the nearest
// track.
dvec3 way_out(const CameraSubject& w, const dvec3& from, const dvec3& aside, const dvec3& to) {
  // Start halfway to the previous offset, so that the eye stays on the same side.
  dvec3 at = from + 0.5 * aside;
  constexpr int kMostSteps = 12;  // enough to leave a stack of coils
  for (int i = 0; i < kMostSteps; ++i) {
    dvec3 step = step_aside(w, at, kClear);
    for (const double part : {0.25, 0.5}) step += step_aside(w, glm::mix(at, to, part), kSightClear) / (1 - part);
    if (step == dvec3(0)) break;
    at += step;
    at.y = std::max(at.y, least_height(w, at));
  }
  return at - from;
}

double squared_distance_to_box(const curve::Box& box, const dvec3& p) {
  const dvec3 outside = glm::max(glm::max(dvec3(box.low) - p, p - dvec3(box.high)), dvec3(0));
  return glm::dot(outside, outside);
}

constexpr double kRiderHeadingLag = 0.5;  // s
constexpr double kWideningLag = 0.8;      // s
constexpr double kWideSpeed = 30;         // m/s, where the view has widened by the full setting
constexpr double kSteepest = 0.8;         // rad, limit of the calm view's pitch
constexpr double kBobLag = 0.12;          // s, time constant of the neck
constexpr double kBobUp = 0.02, kBobSide = 0.03, kMostBob = 0.07;  // m per g, m per g, m
constexpr double kRumble = 0.003;                                  // m at 20 m/s

double wrapped(double angle) { return std::remainder(angle, 2 * base::kPi); }

// Returns the head's offset: against g, plus a small shake. The distance travelled is the only clock.
dvec3 bob_of(const CameraSubject& w, const RiddenTrain& ridden) {
  const sim::FeltAcceleration g = sim::felt(w.document, w.derived, ridden.cart, ridden.motion);
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

void settle_ride(CameraRig& rig, const CameraSubject& w, const RiddenTrain& ridden) {
  rig.forward = ridden.front.frame.forward, rig.up = ridden.front.frame.up;
  rig.roll_lag = rig.roll_rate = 0;
  rig.widening.settle(w.settings.feel->widening_deg * std::min(1.5, std::abs(ridden.motion.speed) / kWideSpeed));
  rig.bob.settle(w.settings.feel->head_bob ? bob_of(w, ridden) : dvec3(0));
}

Eye ride(CameraRig& rig, const CameraSubject& w, const RiddenTrain& ridden, double dt) {
  const world::CameraFeel& feel = *w.settings.feel;
  const curve::Frame& frame = ridden.front.frame;
  roll_after(rig, frame, feel.roll_damping, dt);
  rig.heading.follow(frame, kRiderHeadingLag, dt);
  rig.widening.approach(
      feel.reduced_motion ? 0.0 : feel.widening_deg * std::min(1.5, std::abs(ridden.motion.speed) / kWideSpeed),
      kWideningLag, dt);
  rig.bob.approach(feel.head_bob && !feel.reduced_motion ? bob_of(w, ridden) : dvec3(0), kBobLag, dt);
  Eye eye;
  eye.position = ridden.front.position +
                 (static_cast<float>(sim::form_of(w.derived.made.kind).eye) + rig.bob.value.y) * frame.up +
                 rig.bob.value.z * frame.left();
  if (!on_land(w)) eye.position.y = std::max(eye.position.y, static_cast<double>(kLowestEye));
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

using glm::dquat;
using world::CameraMode;

bool goes_along(CameraMode mode) { return mode == CameraMode::ride || mode == CameraMode::chase; }

const world::TrainMotion* ridden_cart(const CameraSubject& w, world::Entity& cart) {
  if (w.derived.order.empty()) return nullptr;
  cart = world::first_cart(w.document);
  const world::TrainMotion* const motion = w.motion.carts.find(cart);
  return motion && w.derived.segments.contains(motion->segment) ? motion : nullptr;
}

RiddenTrain ridden_of(const CameraSubject& w, world::Entity cart, const world::TrainMotion& motion) {
  const std::size_t index = sim::index_of_segment(w.derived, motion.segment, motion.track_distance);
  const sim::TrackPlace front{index < w.derived.order.size() ? index : 0, motion.s};
  const world::Train* const design = w.document.entities.find<world::Train>(cart);
  RiddenTrain out{cart, motion, {}, {}, 0, front};
  if (design) out.length = (sim::cars_on(w.derived, *design) - 1) * static_cast<double>(design->spacing);
  out.front = sim::pose(w.derived, front, w.settings.frames);
  // Banked by the knots for every frame method, because this eye is not in a seat.
  out.middle = sim::pose(w.derived, sim::behind(w.derived, front, 0.5 * out.length), world::FrameMethod::knots);
  return out;
}

dquat turn_of(const Eye& eye) { return glm::quat_cast(axes_of(eye)); }

bool finite(const dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
bool usable(const Eye& eye) {
  return finite(eye.position) && finite(eye.forward) && finite(eye.up) &&
         glm::length(glm::cross(eye.forward, eye.up)) > 1e-6;
}

// True if the train is not where its motion took it: it was reset, placed, or moved by an edit.
bool leapt(const CameraRig& rig, const RiddenTrain& ridden, int ticks) {
  constexpr double kSlack = 1.0;  // m, more than one edit of a drag moves it
  return glm::distance(rig.anchor, ridden.front.position) >
         kSlack + 1.5 * std::abs(ridden.motion.speed) * ticks * world::kTick;
}

Eye with_train(CameraRig& rig, const CameraSubject& w, int ticks, bool switched) {
  world::Entity cart;
  const world::TrainMotion* const motion = ridden_cart(w, cart);
  const RiddenTrain ridden = ridden_of(w, cart, *motion);
  const bool afresh = !rig.with_train || leapt(rig, ridden, ticks);
  if (afresh) rig.heading.settle(ridden.middle.frame);
  if (afresh || switched) {
    settle_ride(rig, w, ridden);
    settle_chase(rig, w, ridden);
  }
  rig.with_train = true;
  rig.anchor = ridden.front.position;
  const double dt = ticks * world::kTick;
  return rig.mode == CameraMode::ride ? ride(rig, w, ridden, dt) : chase(rig, w, ridden, dt);
}

Eye target_eye(CameraRig& rig, const CameraSubject& w, int ticks, bool switched) {
  const world::Settings& s = w.settings;
  if (goes_along(rig.mode)) {
    const Eye eye = with_train(rig, w, ticks, switched);
    if (usable(eye)) return eye;
    rig.with_train = false;
  }
  if (rig.mode == CameraMode::fly) return fly_eye(s.fly, s.camera.field_of_view_deg, w.ground);
  return orbit_eye(s.camera, w.ground);
}

void begin_transition(CameraRig& rig, const Eye& before, const Eye& to) {
  rig.ticks_left = kTransitionTicks;
  rig.offset = before.position - to.position;
  rig.turn = turn_of(before) * glm::inverse(turn_of(to));
  if (rig.turn.w < 0) rig.turn = -rig.turn;  // the shorter rotation
  rig.field_of_view_off = before.field_of_view_deg - to.field_of_view_deg;
}

// Returns `to` plus the remaining offset from the previous eye. The offset moves with the new camera.
Eye eased(const CameraRig& rig, const CameraSubject& w, const Eye& to) {
  const double left = static_cast<double>(rig.ticks_left) / kTransitionTicks, part = left * left * (3 - 2 * left);
  const dquat turned = glm::slerp(dquat(1, 0, 0, 0), rig.turn, part) * turn_of(to);
  Eye eye = to;
  eye.position += part * rig.offset;
  if (!on_land(w) || !goes_along(rig.mode))
    eye.position.y = std::max(eye.position.y,
                              static_cast<double>(kLowestEye) + surface_at(w.ground, eye.position.x, eye.position.z));
  eye.forward = turned * dvec3(0, 0, -1), eye.up = turned * dvec3(0, 1, 0);
  eye.field_of_view_deg += part * rig.field_of_view_off;
  eye.far_off *= 1 - part;
  return eye;
}

}  // namespace

NearestTrack nearest_track(const sim::DerivedTrack& derived, dvec3 from, double reach) {
  NearestTrack best{kInfinity, from};
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

void settle_chase(CameraRig& rig, const CameraSubject& w, const RiddenTrain& ridden) {
  rig.elevation.settle(elevation_of(w, ridden));
  rig.beside.settle(beside_of(w, ridden));
  rig.aside.settle(way_out(w, place(rig, w, ridden), dvec3(0), looked_at(w, ridden)));
  rig.inside.settle(near_roof(w, ridden) ? 1 : 0);
}

Eye chase(CameraRig& rig, const CameraSubject& w, const RiddenTrain& ridden, double dt) {
  rig.heading.follow(ridden.middle.frame, kChaseHeadingLag, dt);
  rig.elevation.approach(elevation_of(w, ridden), kElevationLag, dt);
  rig.beside.approach(beside_of(w, ridden), kElevationLag, dt);
  const dvec3 wanted = place(rig, w, ridden);
  rig.aside.approach(way_out(w, wanted, rig.aside.value, looked_at(w, ridden)), kAsideLag, dt);
  Eye eye;
  eye.position = wanted + rig.aside.value;
  eye.position.y = std::max(eye.position.y, least_height(w, eye.position));
  rig.inside.approach(near_roof(w, ridden) ? 1 : 0, kInsideLag, dt);
  eye.position = kept_in_tube(rig, w, ridden, eye.position);
  const dvec3 to = looked_at(w, ridden) - eye.position;
  const double distance = glm::length(to);
  eye.forward = distance > 0.1 ? to / distance : rig.heading.direction();
  eye.up = {0, 1, 0};
  if (std::abs(eye.forward.y) > 0.9999) eye.up = rig.heading.direction();
  eye.field_of_view_deg = w.settings.camera.field_of_view_deg;
  return eye;
}

void Heading::settle(const curve::Frame& frame) {
  // On vertical track the rider's left defines the heading.
  const dvec3 left = frame.left();
  dvec3 flat(frame.forward.x, 0, frame.forward.z);
  if (glm::length(flat) < 0.3) flat = {-left.z, 0, left.x};
  yaw = glm::length(flat) > 1e-6 ? std::atan2(-flat.x, -flat.z) : 0.0;
  rate = 0;
}

void Heading::follow(const curve::Frame& frame, double lag, double dt) {
  constexpr double kUpright = 0.2;                  // of up's height
  constexpr double kVague = 0.15, kDefinite = 0.6;  // of the tangent's horizontal length
  const dvec3 f = frame.forward;
  const double flat = std::sqrt(f.x * f.x + f.z * f.z),
               part = std::clamp((flat - kVague) / (kDefinite - kVague), 0.0, 1.0);
  double yaw_error = flat > 1e-9 ? wrapped(std::atan2(-f.x, -f.z) - yaw) : 0.0;
  if (frame.up.y < kUpright && std::cos(yaw_error) < 0) yaw_error = wrapped(yaw_error + base::kPi);
  const double k = 2 / lag;
  for (double seconds_left = dt; seconds_left > 1e-9;
       seconds_left -= world::kTick) {  // small steps, because the pull changes with the angle
    const double step = std::min(seconds_left, world::kTick);
    rate += step * (k * k * part * yaw_error - 2 * k * rate);
    yaw += step * rate, yaw_error -= step * rate;
  }
  yaw = wrapped(yaw);
}

CameraMode shown_mode(const CameraSubject& w) {
  const CameraMode chosen = w.settings.camera_mode;
  world::Entity cart;
  return goes_along(chosen) && !ridden_cart(w, cart) ? CameraMode::orbit : chosen;
}

bool steps(const CameraRig& rig) { return goes_along(rig.mode); }

void follow(CameraRig& rig, const CameraSubject& w, int ticks) {
  const CameraMode mode = shown_mode(w);
  const bool reduced = w.settings.feel->reduced_motion,
             changed = !rig.begun || mode != rig.mode || reduced != rig.reduced;
  const Eye before = rig.eye;
  const bool switched = mode != rig.mode;
  rig.with_train = rig.with_train && goes_along(mode);
  rig.mode = mode, rig.reduced = reduced;
  const Eye to = target_eye(rig, w, ticks, switched);
  const bool cut = before.parallel || to.parallel;  // the two projections cannot be interpolated
  if (reduced || !rig.begun || cut || (changed && !w.eased)) rig.ticks_left = 0;
  else if (changed) begin_transition(rig, before, to);
  else rig.ticks_left = std::max(0, rig.ticks_left - ticks);
  rig.begun = true;
  rig.eye = rig.ticks_left > 0 ? eased(rig, w, to) : to;
}

}  // namespace coaster::view
