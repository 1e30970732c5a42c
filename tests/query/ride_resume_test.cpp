// Motion is independent of the session that made it: saving and loading the document by its text at every 100th tick,
// keeping only the motion, gives exactly the same ride as without interruption.
#include <gtest/gtest.h>

#include "edit/session/session.h"
#include "exchange/formats.h"
#include "sim/ride/ride.h"
#include "world/topology.h"

namespace coaster {
namespace ride_resume_test {

constexpr int kEvery = 100, kTicks = 800;

world::Document loaded(const world::Document& document) {
  auto track = exchange::parse_track(exchange::print_track(document), "resumed");
  EXPECT_TRUE(track.ok());
  return track->document;
}

// The same motion by the entities of another document with the same names.
world::Motion renamed(const world::Motion& motion, const world::Document& from, const world::Document& to) {
  const auto entity = [&](world::Entity e) { return e.valid() ? world::find(to, world::name_of(from, e)) : e; };
  world::Motion result;
  result.state = motion.state, result.failure = motion.failure;
  result.failure.cart = entity(motion.failure.cart);
  for (std::size_t i = 0; i < motion.carts.size(); ++i) {
    world::TrainMotion cart = motion.carts.items()[i];
    cart.segment = entity(cart.segment);
    result.carts.put(entity(motion.carts.entities()[i]), cart);
  }
  return result;
}

struct Ride {
  world::Document document;
  sim::DerivedTrack derived;
  sim::RideCache cache;
  world::Motion motion;
  explicit Ride(world::Document d) : document(std::move(d)) { sim::derive(document, {}, {}, derived); }
  void begin() {
    sim::reset(document, derived, motion);
    motion.state = world::RideState::running;
  }
  void step(int ticks, world::IntegratorId row) { sim::step(document, derived, row, ticks, cache, motion); }
  std::uint64_t hash() const { return world::hash(document, motion); }
};

world::Document sample(const std::string& name) {
  base::Files files;
  auto track = exchange::load_track(files, std::string(COASTER_SOURCE_DIR) + "/tracks/" + name + ".json");
  EXPECT_TRUE(track.ok()) << name;
  return track->document;
}

// Losses, a lift, a station, a brake, and two trains.
world::Document operated() {
  world::Document d = sample("gentle");
  d.resistance = {0.01f, 2e-5f};
  d.entities.get<world::Train>(world::first_cart(d)).cars = 3;
  const auto& segments = d.track.segments;
  world::add_cart(d, segments[segments.size() / 2], 0.4);
  d.entities.put(segments[0], world::Equipment{world::EquipmentKind::lift, 5.0f, 3.0f, 0.5f, 5});
  d.entities.put(segments[segments.size() - 1], world::Equipment{world::EquipmentKind::station, 4.0f, 3.0f, 0.5f, 1});
  d.entities.put(segments[2], world::Equipment{world::EquipmentKind::brake, 8.0f, 2.0f, 0.5f, 5});
  return d;
}

void expect_resumable(const world::Document& document, const std::string& name,
                      std::span<const sim::Integrator> rows = sim::integrators()) {
  for (std::size_t row = 0; row < rows.size(); ++row) {
    Ride whole(loaded(document));
    whole.begin();
    Ride parts(loaded(document));
    parts.begin();
    const double from = parts.motion.carts.items()[0].travelled;
    for (int tick = 0; tick < kTicks; tick += kEvery) {
      whole.step(kEvery, world::IntegratorId{static_cast<int>(row)});
      parts.step(kEvery, world::IntegratorId{static_cast<int>(row)});
      ASSERT_EQ(parts.hash(), whole.hash()) << name << " " << sim::integrators()[row].name << " tick " << tick + kEvery;
      Ride next(loaded(parts.document));
      next.motion = renamed(parts.motion, parts.document, next.document);
      ASSERT_EQ(next.hash(), parts.hash()) << "as it is loaded";
      parts = std::move(next);
    }
    EXPECT_NE(parts.motion.carts.items()[0].travelled, from) << name << " " << sim::integrators()[row].name;
  }
}

TEST(ride_resume, samples_go_on_with_the_same_bits) {
  expect_resumable(sample("loop"), "loop");
  for (const char* name : {"helix", "gentle"}) expect_resumable(sample(name), name, sim::integrators().first(1));
}

TEST(ride_resume, trains_with_equipment_and_losses_go_on_with_the_same_bits) {
  expect_resumable(operated(), "operated");
}

}  // namespace ride_resume_test
}  // namespace coaster
