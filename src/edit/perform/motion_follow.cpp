// Keeps moving trains in place when topology changes.
#include "edit/perform/motion_follow.h"

namespace coaster::edit {
namespace {

// A split keeps the shape, so distances stay; they are scaled only by the rounding of the lengths.
void follow_split(const MotionFollowUp& change, const sim::Derived& derived, world::CartMotion& cart) {
  const double left = derived.shape(change.first).arc.length(), right = derived.shape(change.second).arc.length();
  const double s = cart.segment_length > 0 ? cart.s * ((left + right) / cart.segment_length) : 0;
  const bool beyond = s > left;
  cart.segment = beyond ? change.second : change.first;
  cart.s = beyond ? s - left : s;
  cart.segment_length = beyond ? right : left;
}

// The length stays that of both old segments: reconcile scales it to the survivor's.
void follow_merge(const MotionFollowUp& change, world::CartMotion& cart) {
  if (cart.segment == change.second) cart.s += change.first_length;
  cart.segment = change.first;
  cart.segment_length = change.first_length + change.second_length;
}

// The rails stay and their direction is reversed: the rear of a train becomes its front, and it keeps moving the same
// way in space.
void follow_reversal(const world::Document& document, const sim::Derived& derived, world::Motion& motion) {
  for (std::size_t i = 0; i < motion.carts.size(); ++i) {
    world::CartMotion& cart = motion.carts.items()[i];
    const auto index = world::index_of(derived.order, cart.segment);
    const world::Cart* const design = document.entities.find<world::Cart>(motion.carts.entities()[i]);
    if (!index || !design) continue;
    // `s` was measured from the present end of the segment.
    const double front = derived.starts[*index + 1] - cart.s, behind = design->behind();
    cart.track_distance = front + behind;
    if (derived.closed && derived.length > 0 && cart.track_distance >= derived.length)
      cart.track_distance -= derived.length;
    cart.segment = world::kNone;
    cart.speed = -cart.speed, cart.travelled = -cart.travelled, cart.laps = -cart.laps, cart.furthest = cart.travelled;
    cart.timetable = {};
  }
}

}  // namespace

void follow(const MotionFollowUp& change, const world::Document& document, const sim::Derived& derived,
            world::Motion& motion) {
  if (change.kind == MotionFollowUp::Kind::none) return;
  if (change.kind == MotionFollowUp::Kind::reversed) return follow_reversal(document, derived, motion);
  for (world::CartMotion& cart : motion.carts.items()) {
    if (cart.segment != change.first && cart.segment != change.second) continue;
    if (change.kind == MotionFollowUp::Kind::split) follow_split(change, derived, cart);
    else follow_merge(change, cart);
  }
}

void follow_by_distance(const world::Document& present, const world::Document& next, const sim::Derived& derived,
                        world::Motion& motion) {
  for (world::CartMotion& cart : motion.carts.items()) {
    const auto* const now = present.entities.find<world::Segment>(cart.segment);
    const auto* const then = next.entities.find<world::Segment>(cart.segment);
    if (now && then && now->from == then->from && now->to == then->to) continue;
    if (const auto index = world::index_of(derived.order, cart.segment))
      cart.track_distance = derived.starts[*index] + cart.s;
    cart.segment = world::kNone;
  }
}

}  // namespace coaster::edit
