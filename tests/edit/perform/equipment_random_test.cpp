// The simulated ride and the ride on random circuits with random equipment: equal where a train has passed an end of
// equipment.
#include <array>

#include <gtest/gtest.h>

#include "edit/random_tracks.h"
#include "sim/ride/equipment.h"
#include "sim/ride/live_ride.h"

namespace coaster::edit {
namespace equipment_random_test {

class EquippedTracks : public test::RandomTracks {
 protected:
  void equip_at_random() {
    const std::vector<world::Entity> segments = session.document.track.segments;
    for (const world::Entity segment : segments) {
      if (below(3) != 0) continue;
      const std::uint32_t kind = below(4);
      const double speed = uniform(4, 24), acceleration = uniform(1, 30), hysteresis = uniform(0, 1);
      world::Equipment e;
      e.kind = std::array{world::EquipmentKind::brake, world::EquipmentKind::launch, world::EquipmentKind::lift,
                          world::EquipmentKind::block}[kind];
      e.speed = static_cast<float>(speed), e.acceleration = static_cast<float>(acceleration);
      e.hysteresis = static_cast<float>(hysteresis);
      session.document.entities.put(segment, e);
    }
  }
  void compare_with_simulated(int cars, const std::string& what) {
    world::Document document = session.document;
    document.entities.get<world::Train>(world::first_cart(document)).cars = cars;
    test::LiveRide ride(std::move(document));
    const sim::SimulatedRide simulated = ride.simulated();
    const auto spans = sim::equipment_spans(ride.document, ride.derived);
    const world::TrainMotion& train = ride.train();
    for (std::size_t tick = 1; tick < simulated.samples.size() && ride.runs(); ++tick) {
      const double before = train.track_distance;
      ride.step(1);
      for (const sim::EquipmentSpan& span : spans) {
        if (!(before < span.to && train.track_distance >= span.to)) continue;
        const double speed = std::abs(train.speed - simulated.samples[tick].speed),
                     place = std::abs(train.travelled - simulated.samples[tick].travelled);
        ++passed_, same_speed_ += speed < 1e-6, same_place_ += place < 1e-6;
        EXPECT_LT(speed, 1e-3) << what << " at " << span.to;
        EXPECT_LT(place, 2e-2) << what << " at " << span.to;
      }
    }
  }
  int passed_ = 0, same_speed_ = 0, same_place_ = 0;
};

TEST_F(EquippedTracks, the_simulated_ride_passes_every_end_as_the_ride_does) {
  for (std::uint32_t seed = 1; seed <= 24; ++seed) {
    random_track(seed);
    if (!apply("complete 1")) continue;
    equip_at_random();
    if (below(2)) session.document.resistance = {0.02f, 2e-5f};
    for (const int cars : {1, 8}) compare_with_simulated(cars, fmt::format("seed {}, {} cars", seed, cars));
  }
  EXPECT_GT(passed_, 100);
  // The simulated ride reads heights from tables: a train that is slow, or just reaches a brake's speed, makes more of
  // that.
  EXPECT_GE(same_speed_, 0.95 * passed_) << "of " << passed_;
  EXPECT_GE(same_place_, 0.8 * passed_) << "of " << passed_;
}

}  // namespace equipment_random_test
}  // namespace coaster::edit
