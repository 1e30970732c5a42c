// Tests which numbers a search may change (edit/perform/seek.h).
#include "edit/perform/seek.h"

#include "edit/force_fixture.h"
#include "world/element.h"
#include "world/element_rows.h"

namespace coaster::edit {
namespace seek_numbers_test {

constexpr double kMost = world::kMaxCoordinate;

class SeekNumbers : public test::Forces {
 protected:
  SeekNumbers() { start_on(test::sample_document()); }
  std::vector<SeekNumber> numbers(const std::string& rest) {
    const auto found = seek_numbers(session, *command("seek 20 " + rest).as<SeekGoal>());
    EXPECT_TRUE(found) << rest << ": " << found.status().message;
    return found ? *found : std::vector<SeekNumber>{};
  }
  std::string refusal(const std::string& rest) {
    const auto found = seek_numbers(session, *command("seek 20 " + rest).as<SeekGoal>());
    EXPECT_FALSE(found) << rest;
    return found ? "" : found.status().message;
  }
  static void expect_unknown(const SeekNumber& number, double start, double step, double low, double high) {
    EXPECT_NEAR(number.unknown.start, start, 1e-5);
    EXPECT_NEAR(number.unknown.step, step, 1e-9);
    EXPECT_EQ(number.unknown.low, low);
    EXPECT_EQ(number.unknown.high, high);
  }
  world::Knot& changed(std::uint32_t name) {
    return session.document.entities.get<world::Knot>(world::find(session.document, {world::EntityKind::knot, name}));
  }
};

TEST_F(SeekNumbers, knots_at_or_above_the_ground_stay_there_and_those_below_may_go_anywhere) {
  for (const float height : {7.7f, 0.0f, -0.5f, -8.0f}) {
    changed(3).position.y = height;
    expect_unknown(numbers("by height of @k3").at(0), height, 0.25, height < 0 ? -kMost : 0, kMost);
    const auto place = numbers("by place of @k3");
    ASSERT_EQ(place.size(), 3u);
    const glm::vec3 at = knot(3).position;
    expect_unknown(place[0], at.x, 0.25, -kMost, kMost);
    expect_unknown(place[1], at.y, 0.25, height < 0 ? -kMost : 0, kMost);
    expect_unknown(place[2], at.z, 0.25, -kMost, kMost);
    for (const SeekNumber& number : place) EXPECT_EQ(number.unit, "m");
  }
  for (const float x : {4.0f, -4.0f}) {
    changed(3).position.x = x;
    expect_unknown(numbers("by x of @k3").at(0), x, 0.25, -kMost, kMost);
  }
  EXPECT_EQ(numbers("by roll of @k3").at(0).unit, "deg");
  expect_unknown(numbers("by roll of @k3").at(0), world::roll_deg(knot(3)), 1, -360, 360);
}

TEST_F(SeekNumbers, the_commands_limits_count_where_they_are_narrower) {
  changed(3).position.y = 7.75f;
  expect_unknown(numbers("by height of @k3 above 2 below 30").at(0), 7.75, 0.25, 2, 30);
  expect_unknown(numbers("by height of @k3 above -30 below 7.75").at(0), 7.75, 0.25, 0, 7.75);
  expect_unknown(numbers("by height of @k3 above 7.75").at(0), 7.75, 0.25, 7.75, kMost);
  expect_unknown(numbers("by roll of @k3 below 90").at(0), world::roll_deg(knot(3)), 1, -360, 90);
  EXPECT_NE(refusal("by height of @k3 above 7.76").find("beyond the limits"), std::string::npos);
  EXPECT_NE(refusal("by height of @k3 below 7.7").find("beyond the limits"), std::string::npos);
  EXPECT_NE(refusal("by height of @k3 above 9 below 8").find("above <= below"), std::string::npos);
}

TEST_F(SeekNumbers, several_knots_give_theirs_in_order_without_those_that_stay) {
  const auto found = numbers("by height of @k2..@k5 except @k3..@k4");
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].entity, entity("k2"));
  EXPECT_EQ(found[1].entity, entity("k5"));
  EXPECT_NE(refusal("by height of @k2..@k3 except @k1..@k4").find("nothing to change"), std::string::npos);
}

// One hundredth of the parameter's default, or of its range if that is 0.
TEST_F(SeekNumbers, parameters_of_sections_have_their_limits_and_units) {
  start_on(world::Document{});
  good("element loop left height 15");
  const world::Element& loop = world::section(session.document, entity("q1")).element;
  for (const auto& row : base::row_of(loop.kind).parameters) {
    if (!row.names.empty()) continue;
    const SeekNumber number = numbers("by " + std::string(row.name) + " of @q1").at(0);
    const double usual = row.usual != 0 ? std::abs(row.usual) : row.high - row.low;
    expect_unknown(number, *world::found_value(loop, row.name), usual / 100, row.low, row.high);
    EXPECT_EQ(number.unit, row.unit);
    EXPECT_EQ(number.kind, SeekKind::parameter);
  }
  EXPECT_EQ(numbers("by height of @q1").at(0).unknown.start, 15);
}

TEST_F(SeekNumbers, force_sections_have_a_length_and_keys) {
  start_on(world::Document{});
  drop_and_force();
  const std::string of = " of @" + section;
  expect_unknown(numbers("by length" + of).at(0), 60, 0.6, world::kShortestForce_m, world::kLongestForce_m);
  EXPECT_EQ(numbers("by length" + of).at(0).unit, "m");
  key("vertical key 1 at 0"), key("vertical key 1.5 at 20"), key("vertical key 1 at 40");
  const auto keys = numbers("by vertical" + of);
  ASSERT_EQ(keys.size(), 3u);
  const double limit = world::channel_of(world::ForceQuantity::forces, world::ForceChannel::vertical).limit;
  for (std::size_t i = 0; i < 3; ++i) {
    expect_unknown(keys[i], i == 1 ? 1.5 : 1.0, 0.1, -limit, limit);
    EXPECT_EQ(keys[i].key, i);
    EXPECT_EQ(keys[i].unit, "g");
  }
  const auto one = numbers("by vertical at 20" + of);
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].key, 1u);
  EXPECT_EQ(numbers("by vertical at 20.00001" + of).size(), 1u) << "as far as it is printed";
  EXPECT_NE(refusal("by vertical at 20.001" + of), "");
}

TEST_F(SeekNumbers, sentences_tell_how_many_changed_and_by_how_much) {
  std::vector<SeekNumber> three(3);
  for (SeekNumber& number : three) number.unit = "m", number.unknown.start = 10;
  EXPECT_EQ(changed_text("height", {three[0]}, {12.5}), "Height: from 10 to 12.5 m.");
  EXPECT_EQ(changed_text("height", three, {10, 8.75, 10.5}), "Height: 2 of 3 changed, by up to 1.25 m.");
  EXPECT_EQ(changed_text("height", three, {10, 10, 10}), "Height: 0 of 3 changed, by up to 0 m.");
  three[0].unit = "";
  EXPECT_EQ(changed_text("height", {three[0]}, {9}), "Height: from 10 to 9.");
}

}  // namespace seek_numbers_test
}  // namespace coaster::edit
