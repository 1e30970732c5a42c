#include "sim/study/colour_values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/tracks.h"
#include "world/evaluation_settings.h"
#include "world/laboratory_settings.h"

namespace coaster::sim {
namespace colour_values_test {

using world::Colouring;

struct Coloured {
  world::Document document;
  world::Settings settings;
  DerivedTrack derived;
  RideCache simulated_rides;
  TrackValueCache cache;
  Riders riders;
  world::Entity cart;

  explicit Coloured(world::Document d, double speed = 7.3) : document(std::move(d)) {
    cart = world::add_cart(document, document.track.segments[0], 0.2);
    document.start_speed = speed;
    derive(document, settings, {}, derived);
  }
  const TrackValues& by(Colouring colouring) {
    settings.lab->colouring = colouring;
    return cache.update(derived, settings, rider());
  }
  Rider rider() {
    const SimulatedRide& simulated = *simulated_rides.ride(document, derived, cart);
    riders.update(simulated, simulated_rides.tables(document, derived), derived, 5, {0, simulated.start.cars - 1});
    return riders.car(simulated.start.cars / 2);
  }
  glm::dvec3 place(std::size_t i, int j) const {
    const SegmentShape& shape = derived.shape(derived.order[i]);
    return curve::point(shape.key.cubic, shape.arc.parameter(shape.arc.length() * j / (kValuesPerSegment - 1)));
  }
};

TEST(track_values, a_frictionless_ride_is_as_fast_as_its_height_says_everywhere) {
  Coloured track(test::ring_document(9, 41.3));
  const SegmentShape& first = track.derived.shape(track.derived.order[0]);
  const double start = curve::point(first.key.cubic, first.arc.parameter(0.2 * first.arc.length())).y;
  const TrackValues& values = track.by(Colouring::speed);
  ASSERT_EQ(values.values.size(), 9u * kValuesPerSegment);
  for (std::size_t i = 0; i < 9; ++i)
    for (int j = 0; j < kValuesPerSegment; ++j) {
      const double v2 = 7.3 * 7.3 + 2 * world::kGravity * (start - track.place(i, j).y);
      EXPECT_NEAR(values.of(i)[static_cast<std::size_t>(j)], std::sqrt(v2), 0.02)
          << i << " " << j;  // linear between 60 values a second
    }
}

TEST(track_values, where_a_ride_does_not_come_is_unknown) {
  Coloured track(test::straight_document({3.1f, 2.7f, -1.9f}, {83.1f, 42.7f, -1.9f}, 4),
                 10.0);  // rolls back after 11 m on the slope
  const TrackValues& values = track.by(Colouring::speed);
  EXPECT_NE(values.of(0)[10], kUnknownValue);
  EXPECT_EQ(values.of(3)[10], kUnknownValue);
  for (const float value : track.cache.update(track.derived, track.settings, std::nullopt).values)
    EXPECT_EQ(value, kUnknownValue);
}

TEST(track_values, a_place_passed_twice_has_what_differs_most_from_rest) {
  Coloured track(test::straight_document({3.1f, 2.7f, -1.9f}, {83.1f, 42.7f, -1.9f}, 4), 10.0);
  track.document.rollback_fails = false;
  // Up the slope and, with the same speeds, down again and beyond the start, where it is faster.
  const TrackValues& values = track.by(Colouring::speed);
  EXPECT_NEAR(values.of(0)[6], 10.0, 0.3);
  EXPECT_GT(values.of(0)[1], 10.1f);
}

// Values of the riders, linear between 60 a second, by either sign of a roll.
TEST(track_values, jerk_and_roll_are_those_of_the_middle_car) {
  Coloured track(test::ring_document(9, 41.3), 12);
  track.document.entities.get<world::Train>(track.cart).cars = 5;
  world::Knot& knot = track.document.entities.get<world::Knot>(track.document.track.knots[5]);
  knot.up = glm::vec3(curve::rotate(knot.up, knot.tangent, 0.7));
  derive(track.document, track.settings, {}, track.derived);
  for (const auto& [colouring, value] :
       {std::pair(Colouring::jerk, RideValue::jerk), std::pair(Colouring::roll_rate, RideValue::roll_rate),
        std::pair(Colouring::roll_acceleration, RideValue::roll_acceleration)}) {
    const TrackValues& values = track.by(colouring);
    const Rider rider = track.rider();
    ASSERT_EQ(rider.car, 2);
    double most = 0, of_colours = 0;
    for (std::size_t k = 0; k < rider.entries(); ++k) most = std::max(most, std::abs(rider.value(k, value)));
    for (const float one : values.values) of_colours = std::max(of_colours, static_cast<double>(one));
    EXPECT_GT(most, 0.1) << base::name_of(colouring);
    // Colours are given at positions, which may miss the peak next to a joint.
    EXPECT_NEAR(of_colours, most, 0.12 * most) << base::name_of(colouring);
    EXPECT_GE(*std::min_element(values.values.begin(), values.values.end()), 0) << base::name_of(colouring);
  }
}

TEST(track_values, height_and_curvature_are_the_curves) {
  Coloured track(test::circle_document(17.3, {3.3, 1.7, -2.9}, {0.6, 0, 0.8}, 16));
  const TrackValues& heights = track.by(Colouring::height);
  for (std::size_t i = 0; i < 16; ++i)
    for (int j = 0; j < kValuesPerSegment; ++j)
      EXPECT_NEAR(heights.of(i)[static_cast<std::size_t>(j)], track.place(i, j).y, 1e-5);
  for (const float value : track.by(Colouring::curvature).values) EXPECT_NEAR(value, 1 / 17.3, 1e-4);
}

TEST(track_values, error_is_the_evaluators_deviation) {
  Coloured track(test::ring_document(9, 41.3));
  for (const int steps : {1, 5, 64, 500}) {
    track.settings.evaluation->steps = steps;
    track.settings.evaluation->evaluator = static_cast<curve::EvaluatorId>(3);
    derive(track.document, track.settings, {}, track.derived);
    const TrackValues& values = track.by(Colouring::error);
    const float largest = *std::max_element(values.values.begin(), values.values.end());
    EXPECT_NEAR(static_cast<double>(largest), 1000 * track.derived.deviation,
                1e-6 + 1e-4 * 1000 * track.derived.deviation)
        << steps;
  }
}

TEST(track_values, a_moved_knot_changes_the_heights_of_two_segments) {
  Coloured track(test::ring_document(9, 41.3));
  const std::vector<float> before = track.by(Colouring::height).values;
  world::Knot& knot = track.document.entities.get<world::Knot>(track.document.track.knots[4]);
  knot.position.y += 2.5f;
  derive(track.document, track.settings, {}, track.derived);
  const TrackValues& after = track.by(Colouring::height);
  for (std::size_t i = 0; i < 9; ++i) {
    const bool same = std::equal(after.of(i).begin(), after.of(i).end(),
                                 before.begin() + static_cast<std::ptrdiff_t>(i * kValuesPerSegment));
    EXPECT_EQ(same, i != 3 && i != 4) << i;
  }
}

// At constant height and speed riders feel 1 g upside down everywhere: the up-stops carry the weight.
TEST(track_values, up_stops_carry_the_weight_upside_down_and_nothing_upright) {
  for (const bool inverted : {false, true}) {
    world::Document document = test::straight_document({1.1f, 9.3f, 2.7f}, {61.1f, 9.3f, 22.7f}, 3);
    for (const world::Entity k : document.track.knots)
      if (inverted) document.entities.get<world::Knot>(k).up *= -1.0f;
    Coloured track(document);
    for (const float value : track.by(Colouring::up_stop).of(1)) EXPECT_NEAR(value, inverted ? 0.5 * 9.81 : 0, 1e-3);
  }
}

TEST(track_values, the_legend_is_round_and_holds_every_value) {
  Coloured track(test::ring_document(9, 41.3));
  for (std::size_t row = 1; row < std::size(world::kColourings); ++row) {
    const TrackValues& values = track.by(static_cast<Colouring>(row));
    EXPECT_LT(values.low, values.high);
    for (const float value : values.values) {
      ASSERT_NE(value, kUnknownValue);
      EXPECT_GE(static_cast<double>(value), values.low - 1e-9);
      EXPECT_LE(static_cast<double>(value), values.high + 1e-6 * values.high);
    }
    const double power = std::pow(10.0, std::floor(std::log10(values.high - values.low)));
    const double tenths = (values.high - values.low) / power * 10;
    EXPECT_NEAR(tenths, std::round(tenths), 1e-6) << world::kColourings[row].name;
  }
}

TEST(track_values, plain_needs_nothing_and_an_empty_track_has_nothing) {
  Coloured track(test::ring_document(9, 41.3));
  EXPECT_TRUE(track.by(Colouring::plain).values.empty());
  const DerivedTrack none;
  for (std::size_t row = 0; row < std::size(world::kColourings); ++row) {
    track.settings.lab->colouring = static_cast<Colouring>(row);
    const TrackValues& values = track.cache.update(none, track.settings, std::nullopt);
    EXPECT_TRUE(values.values.empty());
    EXPECT_LT(values.low, values.high);
  }
}

}  // namespace colour_values_test
}  // namespace coaster::sim
