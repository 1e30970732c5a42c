// Printed elements of NoLimits 2.
#include <gtest/gtest.h>

#include "exchange/nolimits/nl2_rule.h"
#include "exchange/nolimits/nl2elem.h"
#include "sim/tracks.h"

namespace coaster::exchange {
namespace nl2elem_print_test {

using glm::dvec3;

// A track with whole turns, unequal handles, jumps of the roll's rate, and a slope at its ends.
world::Document rolled_document() {
  world::Document d = test::sample_document();
  for (std::size_t i = 0; i < d.track.knots.size(); ++i) {
    world::Knot& knot = d.entities.get<world::Knot>(d.track.knots[i]);
    world::set_roll(knot, i % 2 ? 47.0 : -23.0);
    knot.out_length *= 1.37f, knot.joint = world::JointKind::aligned;
  }
  d.entities.get<world::Segment>(d.track.segments[1]).turns = -1;
  return d;
}

std::vector<world::Document> documents() {
  return {test::sample_document(), rolled_document(), test::ring_document(9, 23.1),
          test::circle_document(11, {3, 4, 5}, {1, 0, 0.3}), test::straight_document({-20, 5, 1}, {20, 9, 1}, 3)};
}

TEST(nl2elem_print, the_rule_makes_our_curve_of_three_vertices_a_segment_and_one) {
  for (const world::Document& d : documents()) {
    ASSERT_TRUE(check_nl2elem(d).ok());
    const std::string text = print_nl2elem(d);
    EXPECT_EQ(text, print_nl2elem(d));
    std::vector<test::RuleVertex> vertices;
    std::vector<test::RuleRoll> rolls;
    test::read_by_rule(text, vertices, rolls);
    ASSERT_EQ(vertices.size(), 3 * d.track.segments.size() + 1);
    EXPECT_EQ(vertices.front().p == vertices.back().p, d.track.closed);
    const std::vector<test::RuleSpan> spans = test::rule_spans(vertices);
    ASSERT_EQ(spans.size(), d.track.segments.size());
    for (std::size_t i = 0; i < spans.size(); ++i)
      for (int k = 0; k <= 16; ++k)
        ASSERT_LT(glm::distance(spans[i].at(k / 16.0), curve::point(world::cubic_of(d, d.track.segments[i]), k / 16.0)),
                  1e-4)
            << i;
  }
}

// The frames of the track at `steps` places of each segment, with the angle against the rotation-minimising frame.
struct Place {
  double s, angle;
  dvec3 forward, up, carried;
};
std::vector<Place> places_of(const sim::DerivedTrack& derived, int steps) {
  std::vector<Place> places;
  curve::Frame carried;
  dvec3 last(0);
  for (std::size_t i = 0; i < derived.order.size(); ++i) {
    const sim::SegmentShape& shape = derived.shape(derived.order[i]);
    for (int k = 0; k < steps + (i + 1 == derived.order.size() ? 1 : 0); ++k) {
      const double s = shape.arc.length() * k / steps;
      const curve::Frame frame = sim::frame_at(shape, s);
      const dvec3 here = curve::point(shape.key.cubic, shape.arc.parameter(s));
      carried = places.empty() ? frame : curve::transport(carried, last, here, frame.forward);
      last = here;
      double angle = curve::signed_angle(carried.up, frame.up, frame.forward);
      if (!places.empty()) angle += 2 * M_PI * std::round((places.back().angle - angle) / (2 * M_PI));
      places.push_back({derived.starts[i] + s, angle, frame.forward, frame.up, carried.up});
    }
  }
  return places;
}

TEST(nl2elem_print, rolls_give_our_frames_back_within_0_1_degrees_as_a_spline_and_0_3_linear) {
  for (const world::Document& d : documents()) {
    std::vector<test::RuleVertex> vertices;
    std::vector<test::RuleRoll> rolls;
    test::read_by_rule(print_nl2elem(d), vertices, rolls);
    ASSERT_GT(rolls.size(), d.track.segments.size());
    EXPECT_EQ(rolls.front().coord, 0);
    EXPECT_EQ(rolls.back().coord, 1);
    const sim::DerivedTrack derived = test::derived_of(d);
    const std::vector<Place> places = places_of(derived, 400);
    std::vector<double> s, angle;
    for (const test::RuleRoll& roll : rolls) {
      s.push_back(roll.coord * derived.length);
      const auto nearest = std::min_element(places.begin(), places.end(), [&](const Place& a, const Place& b) {
        return std::abs(a.s - s.back()) < std::abs(b.s - s.back());
      });
      double a =
          curve::signed_angle(nearest->carried, curve::perpendicular(nearest->forward, roll.up), nearest->forward);
      if (!angle.empty()) a += 2 * M_PI * std::round((angle.back() - a) / (2 * M_PI));
      angle.push_back(a);
    }
    const std::vector<double> rates = test::rule_rates(s, angle);
    std::size_t i = 0;
    double worst = 0, worst_smooth = 0;
    for (const Place& place : places) {
      while (i + 2 < s.size() && s[i + 1] < place.s) ++i;
      const double h = s[i + 1] - s[i], u = (place.s - s[i]) / h, v = 1 - u, turn = angle[i + 1] - angle[i];
      const double linear = angle[i] + u * turn,
                   smooth = angle[i] + u * u * (3 - 2 * u) * turn + h * u * v * (v * rates[i] - u * rates[i + 1]);
      worst = std::max(worst, std::abs(linear - place.angle) * 180 / M_PI);
      worst_smooth = std::max(worst_smooth, std::abs(smooth - place.angle) * 180 / M_PI);
    }
    EXPECT_LT(worst, 0.3) << rolls.size();
    EXPECT_LT(worst_smooth, 0.1) << rolls.size();
  }
}

TEST(nl2elem_print, reading_it_again_gives_the_same_knots_to_float) {
  for (const world::Document& d : documents()) {
    const auto again = parse_nl2elem(print_nl2elem(d), "x");
    ASSERT_TRUE(again) << again.status().message;
    EXPECT_TRUE(again->warnings.empty()) << again->warnings.front();
    EXPECT_LT(again->import->max_error, 3e-5);
    EXPECT_LT(again->import->frame_error, 0.02);
    EXPECT_EQ(again->document.track.closed, d.track.closed);
    ASSERT_EQ(again->document.track.knots.size(), d.track.knots.size());
    for (std::size_t i = 0; i < d.track.knots.size(); ++i) {
      const world::Knot &was = world::knot(d, d.track.knots[i]),
                        &is = world::knot(again->document, again->document.track.knots[i]);
      EXPECT_EQ(is.position, was.position) << i;
      EXPECT_LT(glm::distance(is.tangent, was.tangent), 3e-7f) << i;
      EXPECT_LT(glm::distance(is.up, was.up), 2e-5f) << i;
      const bool open = !d.track.closed;
      if (i > 0 || !open) {
        EXPECT_FLOAT_EQ(is.in_length, was.in_length) << i;
      }
      if (i + 1 < d.track.knots.size() || !open) {
        EXPECT_FLOAT_EQ(is.out_length, was.out_length) << i;
      }
    }
    for (std::size_t i = 0; i < d.track.segments.size(); ++i)
      EXPECT_EQ(again->document.entities.get<world::Segment>(again->document.track.segments[i]).turns,
                d.entities.get<world::Segment>(d.track.segments[i]).turns)
          << i;
  }
}

TEST(nl2elem_print, tracks_without_segments_or_with_handles_beyond_the_limits_are_refused) {
  EXPECT_FALSE(check_nl2elem(world::Document{}).ok());
  world::Document far = test::straight_document({99'000, 5, 1}, {99'990, 9, 1}, 1);
  EXPECT_TRUE(check_nl2elem(far).ok()) << "nothing leads to the last knot's handle";
  far.entities.get<world::Knot>(far.track.knots[0]).out_length = 1'500;
  EXPECT_FALSE(check_nl2elem(far).ok());
}

// With handles 2.5 times as long as its straight the train turns back twice on the same line.
TEST(nl2elem_print, a_track_that_turns_back_within_6_cm_is_refused_because_it_could_not_be_read) {
  world::Document line = test::straight_document({3, 5, 1}, {33, 9, 7}, 3);
  EXPECT_TRUE(check_nl2elem(line).ok());
  line.entities.get<world::Knot>(line.track.knots[1]).out_length = 26;
  line.entities.get<world::Knot>(line.track.knots[2]).in_length = 26;
  EXPECT_EQ(check_nl2elem(line).message,
            "error: expected turns of at most 90 degrees within 6 cm, found one of 180 degrees behind knot k2; a file "
            "with it could not be read");
}

}  // namespace nl2elem_print_test
}  // namespace coaster::exchange
