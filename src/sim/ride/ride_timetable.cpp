// The integrators that are not stepped: by a timetable of the whole ride, and by the vertices of the polyline (Barrett
// 2012, section 6).
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "sim/ride/ride_parts.h"

namespace coaster::sim {
namespace {

// Applies the next tick's entry. Returns false if the timetable ends the ride.
bool follow_timetable(const RideInput& input, GhostMemo& memo, world::Entity entity, world::CartMotion& cart,
                      world::FailureKind& failure) {
  const Ghost* ghost = &memo.from(input.document, input.derived, start_of(input, entity, cart.timetable));
  const auto last = static_cast<std::int64_t>(ghost->samples.size()) - 1;
  if (cart.timetable.tick >= last) {
    if (ghost->end != world::FailureKind::none || last == 0) {
      failure = ghost->end;
      return false;
    }
    cart.timetable = timetable_from(cart);
    ghost = &memo.from(input.document, input.derived, start_of(input, entity, cart.timetable));
    if (ghost->samples.size() < 2) return false;
  }
  const auto now = static_cast<std::size_t>(cart.timetable.tick), next = now + 1;
  const GhostSample &before = ghost->samples[now], &after = ghost->samples[next];
  const double from = ghost->start.front + before.travelled, to = ghost->start.front + after.travelled;
  if (input.derived.closed)
    cart.laps +=
        static_cast<std::int64_t>(std::floor(to / ghost->track_length) - std::floor(from / ghost->track_length));
  cart.travelled += after.travelled - before.travelled;
  cart.work += after.work - before.work;
  cart.speed = after.speed;
  cart.furthest = std::max(cart.furthest, cart.travelled);
  cart.peak_kinetic = std::max(cart.peak_kinetic, 0.5 * cart.speed * cart.speed);
  settle_on(input.derived, place_at(input.derived, ghost->distance(next)), cart);
  cart.timetable.tick = static_cast<std::int64_t>(next);
  return true;
}

// Returns the speed by the energy, with the first car at height `height` m (of a vertex: not exactly on the curve) and
// the others behind it on the curve.
double speed_at(const RideInput& input, const TrainLoad& load, const world::CartMotion& cart, TrackPlace front,
                double height) {
  if (load.cars > 1) {
    std::vector<TrackPlace> places;
    place_cars(input.derived, front, load.cars, load.spacing, places);
    for (std::size_t i = 1; i < places.size(); ++i)
      height += rail_point(input.derived.shape_at(places[i].index), places[i].s).height;
    height /= load.cars;
  }
  const double kinetic = cart.reference_energy + cart.work - world::kGravity * (height - input.document.datum);
  return kinetic > 0 ? std::sqrt(2.0 * kinetic) : 0.0;
}

bool begin_timetables(world::Motion& motion) {
  for (world::CartMotion& cart : motion.carts.items())
    if (!cart.timetable.valid) cart.timetable = timetable_from(cart);
  return true;
}

}  // namespace

bool step_by_timetable(const RideInput& input, int ticks, GhostMemo& memo, world::Motion& motion) {
  memo.keep(std::min(motion.carts.size(), kMostTimetables) + 4);
  const bool shared = motion.carts.size() > kMostTimetables;
  if (!(shared ? share_timetables(input, memo, motion) : begin_timetables(motion))) return false;
  std::vector<std::size_t> rounds, others;  // trains whose laps repeat, and the others
  std::vector<const LapTable*> table_of = LapTables(input, memo).of(motion.carts);
  for (std::size_t i = 0; i < motion.carts.size(); ++i) (table_of[i]->valid() ? rounds : others).push_back(i);
  if (shared && !others.empty()) return false;
  int done = 0;  // ticks, including the one in which the ride failed, which is the last for all trains
  for (; done < ticks && motion.state == world::RideState::running && (done == 0 || !others.empty()); ++done) {
    bool any = !rounds.empty();
    for (const std::size_t i : others) {
      world::CartMotion& cart = motion.carts.items()[i];
      world::FailureKind failure = world::FailureKind::none;
      const double arrival = cart.speed;
      if (motion.state != world::RideState::running ||
          follow_timetable(input, memo, motion.carts.entities()[i], cart, failure)) {
        any = true;
        continue;
      }
      halt(cart);
      if (failure == world::FailureKind::none) continue;
      if (motion.failure.kind == world::FailureKind::none)
        motion.failure = {failure, motion.carts.entities()[i], cart.track_distance, arrival};
      if (failure != world::FailureKind::off_end) motion.state = world::RideState::failed;
    }
    if (!any && motion.state == world::RideState::running) motion.state = world::RideState::ended;
  }
  if (others.empty()) done = ticks;
  else table_of = LapTables(input, memo).of(motion.carts);  // the others may have evicted tables
  follow_laps(input, table_of, rounds, done, motion.carts.items());
  return true;
}

bool advance_by_vertices(const RideInput& input, const TrainLoad& load, double dt, world::CartMotion& cart) {
  const Derived& derived = input.derived;
  constexpr int kMostVertices = 100'000;  // per tick
  double time = cart.carry + dt;
  const bool forward = cart.speed > 0 || (cart.speed == 0 && load.drive >= 0);
  const double sign = forward ? 1.0 : -1.0;
  std::size_t index = front_place(derived, cart).index;
  Polyline polyline;  // of that segment; empty: not yet evaluated
  for (int n = 0; n < kMostVertices; ++n) {
    const SegmentShape& shape = derived.shape_at(index);
    if (polyline.points.empty()) evaluate_polyline(shape, polyline);
    // A GPU evaluator has no polyline here: use as many steps of the exact curve.
    const int count = derived.steps + 1;
    const auto vertex = [&](int i) {
      return polyline.points.empty() ? curve::point(shape.key.cubic, static_cast<double>(i) / (count - 1))
                                     : glm::dvec3(polyline.points[static_cast<std::size_t>(i)]);
    };
    const double at = shape.arc.parameter(cart.s) * (count - 1);
    constexpr double kOnVertex = 1e-6;  // of a step
    const int from = std::clamp(static_cast<int>(std::lround(at)), 0, count - 1);
    const int here =
        std::abs(at - from) < kOnVertex ? from : static_cast<int>(forward ? std::floor(at) : std::ceil(at));
    const int to = here + (forward ? 1 : -1);
    if (to < 0 || to >= count) {
      const bool at_end = forward ? index + 1 == derived.order.size() : index == 0;
      if (at_end && !derived.closed) return false;
      if (at_end) cart.laps += forward ? 1 : -1;
      index = forward ? (index + 1) % derived.order.size() : (index + derived.order.size() - 1) % derived.order.size();
      settle_on(derived, {index, forward ? 0.0 : derived.shape_at(index).arc.length()}, cart);
      polyline.points.clear();
      continue;
    }
    const glm::dvec3 a = vertex(here), b = vertex(to);
    const double chord = glm::length(b - a), s = shape.arc.distance(static_cast<double>(to) / (count - 1));
    cart.speed = sign * speed_at(input, load, cart, {index, cart.s}, a.y);
    // From rest, equipment moves it over the first chord with v^2 = 2 a s, at half of that speed on average.
    const double pace =
        cart.speed != 0 ? std::abs(cart.speed) : 0.5 * std::sqrt(std::max(0.0, 2.0 * sign * load.drive * chord));
    if (!(pace > 0) || !(time >= chord / pace)) break;
    time -= chord / pace;
    cart.work += (sign * load.drive - loss(load.resistance, pace)) * std::abs(s - cart.s);
    cart.travelled += s - cart.s;
    settle_on(derived, {index, s}, cart);
    cart.speed = sign * speed_at(input, load, cart, {index, s}, b.y);
  }
  cart.carry = cart.speed != 0 || load.drive != 0 ? time : 0.0;
  return true;
}

}  // namespace coaster::sim
