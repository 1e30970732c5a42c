// Block sections: a section is the track from one block's end to the next one's, and no two trains are ever in the same
// section.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "sim/ride/equipment.h"
#include "sim/ride/ride.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace blocks_test {

// A flat ring of 16 segments, driven everywhere by tyres, with the given blocks and three trains of 3 cars in different
// sections.
world::Document operated_ring(const std::set<std::size_t>& blocks, double station_seconds) {
  world::Document d = test::ring_document(16, 30.7, 0.0);
  for (std::size_t i = 0; i < 16; ++i) {
    world::Equipment e{world::EquipmentKind::lift, 3.7f, 3.0f, 0, 0};
    if (blocks.contains(i)) e = {world::EquipmentKind::block, 4.0f, 4.0f, 0.5f, 0};
    if (i == 0) e = {world::EquipmentKind::station, 4.0f, 3.0f, 0, static_cast<float>(station_seconds)};
    d.entities.put(d.track.segments[i], e);
  }
  d.start_speed = 3;
  for (const std::size_t i : {1u, 6u, 10u})
    d.entities.get<world::Train>(world::add_cart(d, d.track.segments[i], 0.9)).cars = 3;
  return d;
}

// Returns the section of a position: the number of the ascending ends before it; that of the last is the first's.
std::size_t section_of(const std::vector<double>& ends, double length, double at) {
  at -= length * std::floor(at / length);
  std::size_t before = 0;
  while (before < ends.size() && at > ends[before]) ++before;
  return before % ends.size();
}

struct CameraSubject {
  int shared = 0, held = 0;  // ticks with two trains in a section; ticks in which some train stood in a block
  std::vector<std::int64_t> laps;
  bool failed = false;
  std::vector<int> stops;  // ticks that trains stood in the station, one for each stop
};

CameraSubject watch(const world::Document& d, const std::set<std::size_t>& blocks, int ticks) {
  DerivedTrack derived;
  derive(d, {}, {}, derived);
  std::vector<double> ends{derived.starts[1]};
  for (const std::size_t i : blocks) ends.push_back(derived.starts[i + 1]);
  RideCache cache;
  world::Motion motion;
  reset(d, derived, motion);
  motion.state = world::RideState::running;
  CameraSubject seen;
  std::vector<int> standing(motion.carts.size(), 0);
  for (int tick = 0; tick < ticks; ++tick) {
    step(d, derived, {}, 1, cache, motion);
    std::set<std::size_t> taken;
    for (std::size_t train = 0; train < motion.carts.size(); ++train) {
      const world::TrainMotion& cart = motion.carts.items()[train];
      std::set<std::size_t> mine;
      // A train at a block's exact end has not left it: half a car of tolerance.
      for (int car = 0; car < 3; ++car)
        mine.insert(section_of(ends, derived.length, cart.track_distance - 3.0 * car - 0.1));
      for (const std::size_t section : mine) seen.shared += !taken.insert(section).second;
      const bool stands = cart.speed == 0;
      seen.held += stands && cart.segment != d.track.segments[0];
      if (stands && cart.segment == d.track.segments[0]) ++standing[train];
      else if (standing[train] > 0) seen.stops.push_back(std::exchange(standing[train], 0));
    }
  }
  for (const world::TrainMotion& cart : motion.carts.items()) seen.laps.push_back(cart.laps);
  seen.failed = motion.state != world::RideState::running;
  return seen;
}

TEST(blocks, no_two_trains_are_ever_in_one_section_and_the_station_sets_the_headway) {
  const std::set<std::size_t> blocks{4, 8, 12};
  const double seconds = 12.0;
  const int ticks = 120 * 240;
  const CameraSubject seen = watch(operated_ring(blocks, seconds), blocks, ticks);
  EXPECT_FALSE(seen.failed);
  EXPECT_EQ(seen.shared, 0);
  EXPECT_GT(seen.held, 120);  // the station is slow: those behind had to wait
  for (const std::int64_t laps : seen.laps) EXPECT_GE(laps, 2);
  // They keep their order, so no one is more than a lap ahead.
  EXPECT_LE(
      *std::max_element(seen.laps.begin(), seen.laps.end()) - *std::min_element(seen.laps.begin(), seen.laps.end()), 1);
  // Each stop takes its time, and trains leave at least a stop apart.
  ASSERT_GE(seen.stops.size(), 6u);
  for (const int stop : seen.stops) EXPECT_GE(stop, 120 * seconds);
  EXPECT_LE(static_cast<double>(seen.stops.size()), ticks / (120 * seconds));
}

TEST(blocks, without_them_the_same_trains_meet) {
  const CameraSubject seen = watch(operated_ring({}, 12.0), {}, 120 * 120);
  EXPECT_TRUE(seen.failed);
}

}  // namespace blocks_test
}  // namespace coaster::sim
