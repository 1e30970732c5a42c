// Queries of one seat during the whole ride.
#include "edit/session_fixture.h"
#include "query/context.h"
#include "query/query.h"
#include "sim/study/riders.h"

namespace coaster::query {
namespace rows_riders_test {

class RiderRows : public test::SessionTest {
 protected:
  base::Result<Value> ask(std::string_view name, std::string_view argument = {}) {
    return find_query(name)->evaluate({session, stats, "", ""}, argument);
  }
  double number(std::string_view name, std::string_view argument = {}) {
    const auto value = ask(name, argument);
    EXPECT_TRUE(value) << name << ": " << value.status().message;
    return value ? std::get<double>(*value) : NAN;
  }
  // By hand: over the entries of one car.
  double value_of(int car, double distance, sim::RideValue value) {
    const sim::Rider rider = edit::SessionFindings(session).riders()->car(car);
    for (std::size_t k = 0; k + 1 < rider.entries(); ++k) {
      const double from = rider.place(k), to = rider.place(k + 1);
      if (distance < from || distance > to) continue;
      return std::lerp(rider.value(k, value), rider.value(k + 1, value), (distance - from) / (to - from));
    }
    return NAN;
  }
  FrameStats stats;
};

TEST_F(RiderRows, a_seat_at_a_distance_is_that_car_there) {
  good("train @c1 cars 5 spacing 2.5");
  good("start_speed 14");
  const double length = number("exact_length");
  for (const double part : {0.55, 0.7}) {
    const double at = part * length;
    const std::string place = std::to_string(at);
    for (const auto& [seat, car] : {std::pair("/front", 0), std::pair("/middle", 2), std::pair("/back", 4),
                                    std::pair("/4", 3), std::pair("/32", 4), std::pair("", 2)}) {
      EXPECT_NEAR(number("seat.g_up", place + seat), value_of(car, at, sim::RideValue::vertical), 1e-5) << seat;
      EXPECT_NEAR(number("seat.jerk", place + seat), value_of(car, at, sim::RideValue::jerk), 1e-4) << seat;
      EXPECT_NEAR(number("seat.roll_rate", place + seat), value_of(car, at, sim::RideValue::roll_rate), 1e-4) << seat;
    }
    double least = 1e9, most = -1e9;
    for (int car = 0; car < 5; ++car) {
      const double one = value_of(car, at, sim::RideValue::lateral);
      least = std::min(least, one), most = std::max(most, one);
    }
    EXPECT_NEAR(number("seat.g_side", place + "/least"), least, 1e-6);
    EXPECT_NEAR(number("seat.g_side", place + "/most"), most, 1e-6);
    EXPECT_GT(most, least);
    good("seat all");
    EXPECT_NEAR(number("seat.g_side", place), most, 1e-6);
    good("seat_car 2");
    good("seat car");
    EXPECT_NEAR(number("seat.g_side", place), value_of(1, at, sim::RideValue::lateral), 1e-6);
    good("seat middle");
  }
}

TEST_F(RiderRows, a_wrong_place_or_seat_is_an_error_that_says_what_is_expected) {
  for (const char* word : {"", "far", "10/", "10/roof", "10/0", "10/33", "10/1.5"}) {
    const auto value = ask("seat.jerk", word);
    ASSERT_FALSE(value) << word;
    EXPECT_EQ(value.status().message.rfind("expected ", 0), 0u) << word;
  }
}

TEST_F(RiderRows, the_live_train_rolls_as_the_whole_ride_does_there) {
  good("ride.start");
  advance(session, 90);
  good("ride.pause");
  const std::string place = std::to_string(number("ride.distance")) + "/front";
  EXPECT_NE(number("ride.roll_rate"), 0);
  EXPECT_NEAR(number("ride.roll_rate"), number("seat.roll_rate", place), 0.02 * std::abs(number("ride.roll_rate")));
  EXPECT_NEAR(number("ride.roll_acceleration"), number("seat.roll_acceleration", place),
              0.02 * std::abs(number("ride.roll_acceleration")) + 0.5);
  EXPECT_NEAR(number("ride.jerk"), number("seat.jerk", place), 1e-3);
}

TEST_F(RiderRows, the_largest_values_are_those_of_all_cars) {
  good("train @c1 cars 4 spacing 2.5");
  const std::vector<sim::Rider> riders = edit::SessionFindings(session).riders()->all();
  double jerk = 0, rate = 0;
  for (const sim::Rider& rider : riders)
    for (std::size_t k = 0; k < rider.entries(); ++k) {
      jerk = std::max(jerk, rider.value(k, sim::RideValue::jerk));
      rate = std::max(rate, std::abs(rider.value(k, sim::RideValue::roll_rate)));
    }
  EXPECT_GT(jerk, 0);
  EXPECT_EQ(number("ride.jerk_max"), jerk);
  EXPECT_EQ(number("ride.roll_rate_max"), rate);
  EXPECT_GT(number("ride.roll_acceleration_max"), 0);
  good("new");
  EXPECT_EQ(to_text(*ask("ride.jerk_max")), "none");
  EXPECT_EQ(to_text(*ask("seat.speed", "5")), "none");
}

}  // namespace rows_riders_test
}  // namespace coaster::query
