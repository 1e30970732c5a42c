// One eye for all cameras: selects the displayed camera, and eases between two.
#include "view/camera_rig.h"

#include <algorithm>
#include <cmath>

#include "sim/ride/train.h"
#include "sim/shape/frame_methods.h"
#include "world/camera_feel.h"

namespace coaster::view {
namespace {

using glm::dquat;
using glm::dvec3;
using world::CameraMode;

bool goes_along(CameraMode mode) { return mode == CameraMode::ride || mode == CameraMode::chase; }

const world::CartMotion* ridden_cart(const Watched& w, world::Entity& cart) {
  if (w.derived.order.empty()) return nullptr;
  cart = world::first_cart(w.document);
  const world::CartMotion* const motion = w.motion.carts.find(cart);
  return motion && w.derived.segments.contains(motion->segment) ? motion : nullptr;
}

Ridden ridden_of(const Watched& w, world::Entity cart, const world::CartMotion& motion) {
  const std::size_t index = sim::index_of_segment(w.derived, motion.segment, motion.track_distance);
  const sim::TrackPlace front{index < w.derived.order.size() ? index : 0, motion.s};
  const world::Cart* const design = w.document.entities.find<world::Cart>(cart);
  Ridden out{cart, motion, {}, {}, 0};
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
bool leapt(const CameraRig& rig, const Ridden& ridden, int ticks) {
  constexpr double kSlack = 1.0;  // m, more than one edit of a drag moves it
  return glm::distance(rig.anchor, ridden.front.position) >
         kSlack + 1.5 * std::abs(ridden.motion.speed) * ticks * world::kTick;
}

Eye with_train(CameraRig& rig, const Watched& w, int ticks, bool switched) {
  world::Entity cart;
  const world::CartMotion* const motion = ridden_cart(w, cart);
  const Ridden ridden = ridden_of(w, cart, *motion);
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

Eye target_eye(CameraRig& rig, const Watched& w, int ticks, bool switched) {
  const world::Settings& s = w.settings;
  if (goes_along(rig.mode)) {
    const Eye eye = with_train(rig, w, ticks, switched);
    if (usable(eye)) return eye;
    rig.with_train = false;
  }
  if (rig.mode == CameraMode::fly) return fly_eye(s.fly, s.camera.field_of_view_deg);
  return orbit_eye(s.camera);
}

void begin_transition(CameraRig& rig, const Eye& before, const Eye& to) {
  rig.ticks_left = kTransitionTicks;
  rig.offset = before.position - to.position;
  rig.turn = turn_of(before) * glm::inverse(turn_of(to));
  if (rig.turn.w < 0) rig.turn = -rig.turn;  // the shorter rotation
  rig.field_of_view_off = before.field_of_view_deg - to.field_of_view_deg;
}

// Returns `to` plus the remaining offset from the previous eye. The offset moves with the new camera.
Eye eased(const CameraRig& rig, const Eye& to) {
  const double left = static_cast<double>(rig.ticks_left) / kTransitionTicks, part = left * left * (3 - 2 * left);
  const dquat turned = glm::slerp(dquat(1, 0, 0, 0), rig.turn, part) * turn_of(to);
  Eye eye = to;
  eye.position += part * rig.offset;
  eye.position.y = std::max(eye.position.y, static_cast<double>(kLowestEye));
  eye.forward = turned * dvec3(0, 0, -1), eye.up = turned * dvec3(0, 1, 0);
  eye.field_of_view_deg += part * rig.field_of_view_off;
  eye.far_off *= 1 - part;
  return eye;
}

}  // namespace

CameraMode shown_mode(const Watched& w) {
  const CameraMode chosen = w.settings.camera_mode;
  world::Entity cart;
  return goes_along(chosen) && !ridden_cart(w, cart) ? CameraMode::orbit : chosen;
}

bool steps(const CameraRig& rig) { return goes_along(rig.mode); }

void follow(CameraRig& rig, const Watched& w, int ticks) {
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
  rig.eye = rig.ticks_left > 0 ? eased(rig, to) : to;
}

}  // namespace coaster::view
