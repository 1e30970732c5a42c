// Rails stay in place while the curve becomes the heartline and the rails again.
#include "sim/fit/heartline_rails_conversion.h"

#include <cstring>

#include <gtest/gtest.h>

#include "base/files.h"
#include "exchange/formats.h"
#include "sim/shape/rails.h"
#include "sim/solids/conflicts.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace heartline_rails_conversion_test {

using glm::dvec3;
using world::TrackCurve;

world::Document sample(const char* name) {
  base::Files files;
  auto loaded = exchange::load_track(files, std::string(COASTER_SOURCE_DIR "/tracks/") + name);
  EXPECT_TRUE(loaded) << loaded.status().message;
  return loaded->document;
}

// A straight that rolls over once, in two segments, then a banked curve: rolls and bends at once.
world::Document rolling() {
  world::Document d;
  const auto add = [&](glm::vec3 at, glm::vec3 along, double roll, float handle) {
    world::append_knot(d, test::skew_knot(at, along, handle, handle));
    world::set_roll(d.entities.get<world::Knot>(d.track.knots.back()), roll);
  };
  add({3.7f, 21.3f, -5.1f}, {1, 0, 0}, 0, 8);
  add({27.7f, 21.3f, -5.1f}, {1, 0, 0}, 170, 8);
  add({51.7f, 21.3f, -5.1f}, {1, 0, 0}, 0, 10);
  add({71.7f, 21.3f, 14.9f}, {0, 0, 1}, 62, 10.5f);
  add({66.7f, 12.3f, 44.9f}, {-0.3f, -0.2f, 1}, -35, 12);
  d.entities.get<world::Segment>(d.track.segments[1]).turns = 1;
  world::add_cart(d, d.track.segments[1], 0.61);
  world::add_cart(d, d.track.segments[3], 0.97);
  return d;
}

std::vector<dvec3> rails_of(const world::Document& document) {
  const DerivedTrack derived = test::derived_of(document);
  const double height = document.curve == TrackCurve::heartline ? document.heartline : 0;
  std::vector<dvec3> line;
  for (std::size_t i = 0; i < derived.order.size(); ++i) {
    const SegmentShape& shape = derived.shape_at(i);
    const int steps = std::max(10, static_cast<int>(shape.arc.length() / 0.1));
    for (int k = 0; k <= steps; ++k) {
      const double s = shape.arc.length() * k / steps;
      line.push_back(curve::point(shape.key.cubic, shape.arc.parameter(s)) - height * frame_at(shape, s).up);
    }
  }
  return line;
}

// Returns the largest distance of a point of one line from the chords of the other, searched near the last one.
double apart(const std::vector<dvec3>& points, const std::vector<dvec3>& line) {
  double most = 0;
  std::size_t at = 0;
  for (const dvec3& p : points) {
    double least = 1e300;
    std::size_t best = at;
    for (std::size_t i = at > 40 ? at - 40 : 0; i + 1 < line.size() && i < at + 80; ++i) {
      const dvec3 chord = line[i + 1] - line[i];
      const double square = glm::dot(chord, chord),
                   t = square > 0 ? std::clamp(glm::dot(p - line[i], chord) / square, 0.0, 1.0) : 0.0;
      if (const double d = glm::distance(p, line[i] + t * chord); d < least) least = d, best = i;
    }
    at = best;
    most = std::max(most, least);
  }
  return most;
}

SwitchedCurve switched(const world::Document& document, TrackCurve to) {
  auto result = switch_curve(document, test::derived_of(document), to);
  EXPECT_TRUE(result) << result.status().message;
  if (!result) return {};
  EXPECT_EQ(world::broken_invariant(result->document), std::nullopt);
  return std::move(*result);
}

class SwitchCurve : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Tracks, SwitchCurve,
                         testing::Values("rolling", "loop.json", "gentle.json", "helix.json", "kingfisher.json"),
                         [](const auto& one) { return std::string(one.param, std::strcspn(one.param, ".")); });

TEST_P(SwitchCurve, there_and_back_keeps_the_rails_within_a_centimetre) {
  const world::Document document = std::string(GetParam()) == "rolling" ? rolling() : sample(GetParam());
  const std::vector<dvec3> rails = rails_of(document);
  const SwitchedCurve heart = switched(document, TrackCurve::heartline);
  ASSERT_EQ(heart.document.curve, TrackCurve::heartline);
  const std::vector<dvec3> below = rails_of(heart.document);
  EXPECT_LT(apart(rails, below), 0.006);
  EXPECT_LT(apart(below, rails), 0.006);
  EXPECT_LE(apart(rails, below), heart.max_error + 1e-4);
  const SwitchedCurve back = switched(heart.document, TrackCurve::rails);
  EXPECT_LT(apart(rails, rails_of(back.document)), 0.01);
  EXPECT_LT(apart(rails_of(back.document), rails), 0.01);
  // Knots are added where the roll rate jumps, since the other curve has a corner there; none is lost.
  const std::size_t knots = document.track.knots.size();
  EXPECT_LT(heart.document.track.knots.size(), 8 * knots);
  EXPECT_EQ(heart.document.track.knots.size(), knots + static_cast<std::size_t>(heart.added));
  RecordProperty("added", heart.added);
}

// With the handles of equal parameters, 43 knots were added.
TEST(switch_curve, takes_few_knots_more_and_none_of_them_twice) {
  const SwitchedCurve heart = switched(sample("loop.json"), TrackCurve::heartline);
  EXPECT_GT(heart.added, 0);
  EXPECT_LE(heart.added, 18);
  EXPECT_LE(switched(heart.document, TrackCurve::rails).added, 3);
}

TEST(switch_curve, keeps_names_equipment_and_the_places_of_trains) {
  const world::Document document = rolling();
  world::Document equipped = document;
  equipped.entities.put(equipped.track.segments[1], world::Equipment{world::EquipmentKind::brake});
  const DerivedTrack before = test::derived_of(equipped);
  const SwitchedCurve now = switched(equipped, TrackCurve::heartline);
  EXPECT_GT(now.added, 0);
  double with_brake = 0;  // m of rails: the heartline winds around the straight
  for (const world::Entity e : now.document.track.segments) {
    const SegmentShape& shape = now.shapes.shape(e);
    for (int i = 0; i < 100 && now.document.entities.find<world::Equipment>(e); ++i)
      with_brake += glm::distance(rails_point(shape, i / 100.0), rails_point(shape, (i + 1) / 100.0));
  }
  EXPECT_NEAR(with_brake, before.shape_at(1).arc.length(), 0.01);
  for (const world::Entity e : equipped.track.knots) {
    ASSERT_TRUE(now.document.entities.find<world::Knot>(e));
    const world::Knot &was = world::knot(equipped, e), &is = world::knot(now.document, e);
    EXPECT_LT(glm::distance(is.position, was.position + 1.1f * was.up), 1e-5f);
    EXPECT_LT(glm::distance(is.up, was.up), 1e-5f);
    EXPECT_EQ(world::name_of(now.document, e), world::name_of(equipped, e));
  }
  const auto& carts = equipped.entities.pool<world::Train>();
  for (std::size_t i = 0; i < carts.size(); ++i) {
    const world::Train &was = carts.items()[i], &is = now.document.entities.get<world::Train>(carts.entities()[i]);
    const SegmentShape &there = before.shape(was.segment), &here = now.shapes.shape(is.segment);
    EXPECT_LT(glm::distance(rails_at(there, was.fraction * there.arc.length()),
                            rails_at(here, is.fraction * here.arc.length())),
              0.02);
  }
}

// A banked track that crosses itself 2 m above.
TEST(switch_curve, keeps_the_conflicts_of_the_rails) {
  world::Document document;
  const auto add = [&](glm::vec3 at, glm::vec3 along, double roll, float handle = 10) {
    world::append_knot(document, test::skew_knot(at, along, handle, handle));
    world::set_roll(document.entities.get<world::Knot>(document.track.knots.back()), roll);
  };
  add({0, 5, 0}, {1, 0, 0}, 20, 20), add({60, 5, 0}, {1, 0, 0}, 30, 20), add({80, 6, 25}, {0, 0, 1}, 40);
  add({55, 7, 45}, {-1, 0, 0}, 40), add({30, 7, 25}, {0, 0, -1}, 0), add({30, 7, -25}, {0, 0, -1}, 0);
  Conflicts one, other;
  const DerivedTrack before = test::derived_of(document);
  const SwitchedCurve now = switched(document, TrackCurve::heartline);
  const std::vector<Conflict>&was = one.update(before), &is = other.update(now.shapes);
  ASSERT_EQ(was.size(), 1u);
  ASSERT_EQ(is.size(), 1u);
  EXPECT_NEAR(is[0].missing, was[0].missing, 0.03);
  EXPECT_LT(glm::distance(is[0].at_place, was[0].at_place), 2.1f);  // a chord
  // Without the rails' height it would be at the curve, a metre above.
  EXPECT_LT(std::abs(is[0].at_place.y - was[0].at_place.y), 0.1f);
}

TEST(switch_curve, is_refused_where_the_new_curve_would_fold) {
  world::Document d;
  const auto add = [&](glm::vec3 at, glm::vec3 along, float handle) {
    world::append_knot(d, test::skew_knot(at, along, handle, handle));
  };
  add({0, 30, 0}, {1, -2, 0}, 8);
  add({10, 10, 0}, {1, 0, 0}, 2);  // a valley of a radius below a metre
  add({20, 30, 0}, {1, 2, 0}, 8);
  const auto result = switch_curve(d, test::derived_of(d), TrackCurve::heartline);
  ASSERT_FALSE(result.ok());
  EXPECT_NE(result.status().message.find("the heartline would fold at 22"), std::string::npos)
      << result.status().message;
  d.curve = TrackCurve::heartline;  // a valley is harmless for rails below
  const auto rails = switch_curve(d, test::derived_of(d), TrackCurve::rails);
  EXPECT_TRUE(rails.ok()) << rails.status().message;
}

// Its new handles meet their limits in a bend that almost folds: pieces get shorter, but not nearer.
TEST(switch_curve, is_refused_where_halves_come_no_nearer) {
  world::Document d;
  world::Knot first = test::skew_knot({-654.12262f, 71.5633545f, -193.260117f},
                                      {0.177316397f, 0.416821837f, -0.891525924f}, 61.1210747f, 61.1210747f),
              second = first;
  second.position = {-686.635925f, -4.866436f, -29.7870464f};
  first.up = {-0.288032532f, 0.888194561f, 0.357977241f};
  second.up = {0.63631773f, 0.642503917f, 0.426952511f};
  world::append_knot(d, first), world::append_knot(d, second);
  d.entities.get<world::Segment>(d.track.segments[0]).turns = -1;
  d.curve = TrackCurve::heartline;
  d.heartline = 0.659184f;
  const auto result = switch_curve(d, test::derived_of(d), TrackCurve::rails);
  ASSERT_FALSE(result.ok());
  EXPECT_NE(result.status().message.find("the rails would move by more than 0.01 m at "), std::string::npos)
      << result.status().message;
}

TEST(switch_curve, of_no_height_or_no_segments_is_trivial) {
  world::Document d = test::sample_document();
  d.heartline = 0;
  world::Document same = switched(d, TrackCurve::heartline).document;
  same.curve = TrackCurve::rails;
  EXPECT_EQ(same, d);
  world::Document lone;
  world::append_knot(lone, test::skew_knot({3, 4, 5}, {1, 0, 0}, 5, 5));
  const SwitchedCurve moved = switched(lone, TrackCurve::heartline);
  EXPECT_EQ(world::knot(moved.document, lone.track.knots[0]).position, glm::vec3(3, 5.1f, 5));
  EXPECT_TRUE(switch_curve({}, {}, TrackCurve::heartline).ok());
}

}  // namespace heartline_rails_conversion_test
}  // namespace coaster::sim
