// The report of a ride, as text and as CSV.
#include "sim/study/ratings.h"

#include <gtest/gtest.h>

#include <sstream>

#include "sim/study/riders.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace ride_report_test {

struct Reported {
  world::Document document;
  DerivedTrack derived;
  RideCache cache;
  const SimulatedRide* simulated = nullptr;
  Ratings ratings;
  std::vector<Overload> red;
  Riders riders;

  Reported(world::Document d, double speed, int cars) : document(std::move(d)) {
    const world::Entity cart = world::add_cart(document, document.track.segments.at(0), 0.2);
    document.entities.get<world::Train>(cart).cars = cars;
    document.start_speed = speed;
    derive(document, {}, {}, derived);
    simulated = cache.ride(document, derived, cart);
    ratings = rate(*simulated, tables(), 5);
    red = red_spans(*simulated, default_envelope());
    riders.update(*simulated, tables(), derived, 5, {0, cars - 1});
  }
  const RailTables& tables() { return cache.tables(document, derived); }
  std::string text(const std::string& name = "") const {
    return report_text(*simulated, ratings, riders.all(), red, name);
  }
};

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, at);) parts.push_back(part);
  return parts;
}

// The number after a row's name.
double number_of(const std::string& report, const std::string& row) {
  const std::size_t at = report.find("  " + row + " ");
  EXPECT_NE(at, std::string::npos) << row;
  return at == std::string::npos ? NAN : std::stod(report.substr(at + 2 + row.size()));
}

TEST(ride_report, tells_the_ratings_of_the_ride) {
  Reported ride(test::ring_document(24, 40.7, 4.3), 16.3, 3);
  const std::string report = ride.text("Skew ring");
  EXPECT_EQ(report.rfind("Skew ring\n", 0), 0u);
  EXPECT_NEAR(number_of(report, "length"), ride.derived.length, 0.01);
  EXPECT_NEAR(number_of(report, "lap"), ride.simulated->lap_time, 0.01);
  EXPECT_NEAR(number_of(report, "cars"), 3, 0);
  EXPECT_NEAR(number_of(report, "top speed"), ride.ratings.top_speed.value, 0.01);
  EXPECT_NEAR(number_of(report, "highest") - number_of(report, "lowest"), 8.6, 0.05);
  EXPECT_NEAR(number_of(report, "most lateral"), ride.ratings.side_most.value, 0.01);
  EXPECT_NEAR(number_of(report, "most on road wheels"), ride.ratings.road_most.value, 0.01);
  EXPECT_NEAR(number_of(report, "most on up-stops"), ride.ratings.up_stop_most.value, 0.01);
  EXPECT_NEAR(number_of(report, "most on side wheels"), ride.ratings.side_load_most.value, 0.01);
  EXPECT_NEAR(number_of(report, "most jerk"), most_of(ride.riders.all(), RideValue::jerk).value, 0.01);
  EXPECT_NEAR(number_of(report, "most roll rate"), most_of(ride.riders.all(), RideValue::roll_rate).value, 0.01);
  EXPECT_NEAR(number_of(report, "drops"), ride.ratings.drops, 0);
  EXPECT_NEAR(number_of(report, "overloads"), static_cast<double>(ride.red.size()), 0);
  EXPECT_NE(report.find("not a compliance check"), std::string::npos);
}

TEST(ride_report, names_every_red_span_with_its_limit) {
  Reported ride(test::circle_document(6.5, {3.3, 1.7, -2.9}, {0.6, 0, 0.8}), 27, 2);
  ASSERT_FALSE(ride.red.empty());
  const std::string report = ride.text();
  std::size_t lines = 0;
  for (const std::string& line : split(report, '\n')) lines += line.find(", limit ") != std::string::npos;
  EXPECT_EQ(lines, ride.red.size());
}

TEST(ride_report, shows_no_sign_before_a_zero) {
  const std::string report = Reported(test::straight_document({0, 3, 0}, {60, 3, 1}, 3), 2, 1).text();
  EXPECT_EQ(report.find("-0.00 "), std::string::npos) << report;
}

TEST(ride_report, says_why_a_ride_ended_early) {
  Reported ride(test::ring_document(24, 40.7, 9.3), 6.3, 1);
  ASSERT_NE(ride.simulated->end, world::FailureKind::none);
  const std::string report = ride.text();
  EXPECT_NE(report.find("no complete lap"), std::string::npos);
  EXPECT_NE(report.find(std::string(base::name_of(ride.simulated->end)) + " at "), std::string::npos);
}

TEST(ride_report, the_values_by_time_are_a_table_of_the_simulated_ride) {
  Reported ride(test::ring_document(24, 40.7, 4.3), 16.3, 3);
  const std::vector<std::string> lines = split(report_csv(*ride.simulated, ride.riders.all()), '\n');
  ASSERT_EQ(lines.size(), 2 + (ride.simulated->samples.size() + kForceEvery - 2) / kForceEvery);
  const std::vector<std::string> head = split(lines[0], ',');
  ASSERT_EQ(head.size(), 5u + 9 * 3 + 5 * 3);
  EXPECT_EQ(head[0], "time_s");
  EXPECT_EQ(head[14], "up_2_g");
  EXPECT_EQ(head[22], "side_right_2_kN");
  EXPECT_EQ(head[37], "jerk_up_2_g_s");
  EXPECT_EQ(head[40], "roll_rate_2_deg_s");
  EXPECT_EQ(head[41], "roll_acceleration_2_deg_s2");
  for (const std::size_t k : {std::size_t{0}, std::size_t{17}, lines.size() - 2}) {
    const std::vector<std::string> row = split(lines[k + 1], ',');
    ASSERT_EQ(row.size(), head.size());
    const RideSample& sample = ride.simulated->samples[ride.simulated->sample_of(k)];
    EXPECT_NEAR(std::stod(row[0]), static_cast<double>(ride.simulated->sample_of(k)) * world::kTick, 1e-5);
    EXPECT_NEAR(std::stod(row[1]), ride.simulated->distance(ride.simulated->sample_of(k)), 1e-3);
    EXPECT_NEAR(std::stod(row[2]), sample.speed, 1e-3);
    EXPECT_NEAR(std::stod(row[14]), ride.simulated->forces[k * 3 + 1].up, 1e-3);
    // The wheels of the second car give 500 kg what it feels.
    const auto cell = [&](std::size_t column) { return std::stod(row[column]); };
    const double weight = 0.5 * 9.81;  // kN
    EXPECT_NEAR(cell(17) + cell(18) - cell(19) - cell(20), weight * cell(14), 2e-3);
    EXPECT_NEAR(cell(21) - cell(22), weight * cell(15), 2e-3);
    const RiderSample& rider = ride.riders.car(1).samples[k];
    EXPECT_NEAR(std::stod(row[37]), rider.jerk.up, 1e-3);
    EXPECT_NEAR(std::stod(row[39]), rider.jerk.forward, 1e-3);
    EXPECT_NEAR(std::stod(row[40]), rider.roll_rate, 1e-3);
    EXPECT_NEAR(std::stod(row[41]), rider.roll_acceleration, 1e-3);
    // Energy: no losses.
    EXPECT_NEAR(0.5 * sample.speed * sample.speed + 9.81 * std::stod(row[3]),
                0.5 * 16.3 * 16.3 + 9.81 * std::stod(split(lines[1], ',')[3]), 8.0);
  }
}

}  // namespace ride_report_test
}  // namespace coaster::sim
