// Fillets in place of the corners of elements.
#include "exchange/nolimits/nl2_spline.h"

#include <gtest/gtest.h>

#include "exchange/nolimits/nl2_rule.h"
#include "exchange/nolimits/nl2elem.h"
#include "sim/tracks.h"

namespace coaster::exchange {
namespace nl2_corners_test {

using glm::dvec3;
using Vertex = test::RuleVertex;
using test::encode;

// Two legs of 20 m that turn by `degrees` at the vertex between them.
std::vector<Vertex> corner(double degrees) {
  const double a = degrees * M_PI / 180;
  const dvec3 at(3.3, 7.1, -4.7);
  return {{at - 20.0 * dvec3(0.6, 0, 0.8)},
          {at, true},
          {at + 20.0 * (std::cos(a) * dvec3(0.6, 0, 0.8) + std::sin(a) * dvec3(0, 1, 0))}};
}

TEST(nl2_corners, a_corner_becomes_a_fillet_within_3_cm_and_is_reported) {
  for (const double degrees : {0.01, 0.1, 1.0, 7.0, 30.0, 60.0, 89.0, 90.0}) {
    const std::vector<Vertex> vertices = corner(degrees);
    const auto loaded = parse_nl2elem(encode(vertices), "x");
    ASSERT_TRUE(loaded) << degrees << loaded.status().message;
    ASSERT_EQ(loaded->warnings.size(), 1u) << degrees;
    EXPECT_NE(loaded->warnings[0].find("at vertex 2 was rounded"), std::string::npos) << loaded->warnings[0];
    const world::Document& d = loaded->document;
    ASSERT_EQ(d.track.segments.size(), 3u);
    double off = 0;  // of the document from the two legs, and of the corner from the document
    double missed = 1e9;
    for (const world::Entity e : d.track.segments) {
      const curve::Cubic cubic = world::cubic_of(d, e);
      for (int k = 0; k <= 100; ++k) {
        const dvec3 here = curve::point(cubic, k / 100.0);
        const auto from_leg = [&](dvec3 a, dvec3 b) {
          const double t = std::clamp(glm::dot(here - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
          return glm::distance(here, a + t * (b - a));
        };
        off = std::max(off, std::min(from_leg(vertices[0].p, vertices[1].p), from_leg(vertices[1].p, vertices[2].p)));
        missed = std::min(missed, glm::distance(here, vertices[1].p));
      }
    }
    EXPECT_LT(off, 0.03) << degrees;
    EXPECT_LT(missed, 0.0301) << degrees;
    EXPECT_NEAR(loaded->import->max_error, missed, 1e-3 * missed + 2e-5) << degrees;
    // As wide as the distance allows, up to 45 % of the legs.
    if (degrees < 0.2) EXPECT_LT(missed, 0.01);
    else EXPECT_GT(missed, 0.0299) << degrees;
  }
  // Handles that turn by less than the rounding of a file's decimals are turned.
  const auto hardly = parse_nl2elem(encode(corner(1e-4)), "x");
  ASSERT_TRUE(hardly);
  EXPECT_TRUE(hardly->warnings.empty());
  EXPECT_EQ(hardly->document.track.segments.size(), 2u);
  EXPECT_LT(hardly->import->max_error, 1e-4);
}

// Beside the corner the parabola before it bends tightly, so the fillet is farthest off away from its middle.
TEST(nl2_corners, a_fillet_beside_a_tight_bend_is_within_3_cm_everywhere) {
  const std::vector<Vertex> vertices{{{5.545388, 12.998060, 3}},
                                     {{3.777317, 11.553183, -0.588025}},
                                     {{3.472357, 11.748708, -0.984257}, true},
                                     {{-6.390274, 17.659572, -12.285961}},
                                     {{-6.842315, 17.859530, -12.499640}},
                                     {{-13.709963, 18.229418, -25.835135}},
                                     {{-22.580084, 16.410224, -37.931454}, true}};
  const auto loaded = parse_nl2elem(encode(vertices), "x");
  ASSERT_TRUE(loaded) << loaded.status().message;
  std::vector<dvec3> legs;
  const std::vector<test::RuleSpan> spans = test::rule_spans(vertices);
  for (std::size_t span = 0; span < 2; ++span)
    for (int i = 0; i <= 5000; ++i) legs.push_back(spans[span].at(i / 5000.0));
  const curve::Cubic fillet = world::cubic_of(loaded->document, loaded->document.track.segments[1]);
  double off = 0;
  for (int k = 0; k <= 100; ++k) {
    double nearest = 1e9;
    for (const dvec3& place : legs) nearest = std::min(nearest, glm::distance(curve::point(fillet, k / 100.0), place));
    off = std::max(off, nearest);
  }
  EXPECT_LT(off, 0.0301);
}

TEST(nl2_corners, corners_beyond_90_degrees_are_refused_with_their_vertex) {
  for (const double degrees : {90.1, 120.0, 180.0}) {
    const auto loaded = parse_nl2elem(encode(corner(degrees)), "x");
    ASSERT_FALSE(loaded.ok()) << degrees;
    EXPECT_NE(loaded.status().message.find("expected corners of at most 90 degrees, found one of "), std::string::npos)
        << loaded.status().message;
    EXPECT_NE(loaded.status().message.find(" degrees at vertex 2"), std::string::npos) << loaded.status().message;
  }
  const auto hardly = parse_nl2elem(encode(corner(90.006)), "x");
  EXPECT_NE(hardly.status().message.find("found one of 90.006 degrees"), std::string::npos) << hardly.status().message;
}

// Through vertices on one line that lead back: the derivative vanishes at one place, in a run of three, four or more,
// within a piece or between two. A hairpin less than 6 cm wide is as good as one, a wider one is not.
TEST(nl2_corners, curves_that_turn_back_on_one_line_are_refused) {
  const dvec3 start(3.3, 7.1, -4.7), along(0.6, 0.3, 0.74), side(0.78, 0, -0.63);
  const auto made = [&](const std::vector<std::pair<double, double>>& places) {
    std::vector<Vertex> vertices;
    for (const auto& [far, aside] : places) vertices.push_back({start + far * along + aside * side});
    return parse_nl2elem(encode(vertices), "x");
  };
  for (const double wide : {0.0, 1e-4, 0.02}) {
    for (const auto& result : {made({{0, 0}, {20, 0}, {0, wide}}), made({{0, 0}, {20, 0}, {20, wide}, {5, wide}}),
                               made({{0, 0}, {10, 0}, {20, 0.5 * wide}, {10, wide}, {0, wide}}),
                               made({{0, 0}, {10, 0}, {20, 0}, {20, wide}, {10, wide}, {0, wide}})}) {
      ASSERT_FALSE(result.ok()) << wide;
      const std::string& message = result.status().message;
      EXPECT_NE(message.find("s of at most 90 degrees"), std::string::npos) << message;
      EXPECT_TRUE(message.find(" degrees near vertex ") != std::string::npos ||  // in a run
                  message.find(" degrees at vertex ") != std::string::npos)      // where two pieces meet
          << message;
    }
  }
  EXPECT_NE(
      made({{0, 0}, {20, 0}, {0, 0}})
          .status()
          .message.find("expected turns of at most 90 degrees within 6 cm, found one of 180 degrees near vertex 1"),
      std::string::npos);
  EXPECT_TRUE(made({{0, 0}, {10, 0}, {20, 0}, {20, 1}, {10, 1}, {0, 1}}).ok());
  EXPECT_TRUE(made({{0, 0}, {10, 0}, {9, 0}, {20, 0}, {30, 0}}).ok()) << "the spline does not turn back";
}

TEST(nl2_corners, vertices_at_one_place_add_no_segment) {
  const dvec3 a(3.3, 7.1, -4.7), b(13.3, 7.1, -4.7), c(23.3, 9.1, -4.7), d(33.3, 9.1, -2.7);
  const auto once = parse_nl2elem(encode({{a}, {b, true}, {c}, {d}}), "x"),
             twice = parse_nl2elem(encode({{a}, {b, true}, {b, true}, {c}, {d}}), "x");
  ASSERT_TRUE(once && twice) << twice.status().message;
  EXPECT_EQ(twice->document, once->document);
  EXPECT_EQ(once->document.track.segments.size(), 3u) << "a line, a fillet and a parabola";
}

TEST(nl2_corners, a_polygon_of_strict_vertices_gets_a_fillet_at_each_and_20_warnings) {
  std::vector<Vertex> polygon;
  for (int i = 0; i < 40; ++i) polygon.push_back({{7.0 * i, 5 + (i % 2), 0.1 * i}, true});
  const auto loaded = parse_nl2elem(encode(polygon), "x");
  ASSERT_TRUE(loaded) << loaded.status().message;
  EXPECT_EQ(loaded->document.track.segments.size(), 39u + 38u);
  ASSERT_EQ(loaded->warnings.size(), 21u);
  EXPECT_NE(loaded->warnings.back().find("18 more corners"), std::string::npos) << loaded->warnings.back();
  EXPECT_LT(loaded->import->max_error, 0.0301);
}

}  // namespace nl2_corners_test
}  // namespace coaster::exchange
