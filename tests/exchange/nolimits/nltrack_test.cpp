#include "exchange/nolimits/nltrack.h"

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "base/portable_math.h"
#include "sim/shape/derived_track.h"
#include "world/topology.h"

namespace coaster::exchange {
namespace nltrack_test {

// An encoder independent of the program.
struct Vertex {
  glm::vec3 point, in, out;
  float roll = 0;
};

void put(std::string& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xff);
}
void put(std::string& bytes, float value) { put(bytes, std::bit_cast<std::uint32_t>(value)); }

constexpr std::size_t kFront = 21;  // bytes before the first chunk that is read
constexpr std::size_t kCount = kFront + 24, kFirst = kFront + 28;

std::string encode(const std::vector<Vertex>& vertices, bool closed) {
  std::string bytes = "NLIM some other chunk";
  bytes += "BEZR";
  put(bytes, static_cast<std::uint32_t>(20 + 60 * vertices.size() + 20));
  bytes.append(16, '\0');
  put(bytes, static_cast<std::uint32_t>(vertices.size()));
  for (const Vertex& v : vertices) {
    for (const glm::vec3 p : {v.point, v.in, v.out})
      for (int axis = 0; axis < 3; ++axis) put(bytes, p[axis]);
    put(bytes, v.roll);
    bytes += std::string("\xff\xff\x00", 3) + std::string(17, '\0');
  }
  bytes.append(20, '\0');
  bytes += "SEGM";
  put(bytes, 5u);
  put(bytes, static_cast<std::uint32_t>(vertices.size()));
  return bytes += closed ? '\xff' : '\0';
}

Vertex vertex(glm::vec3 point, glm::dvec3 direction, double in, double out, float roll = 0) {
  const glm::dvec3 unit = glm::normalize(direction), p(point);
  return {point, glm::vec3(p - in * unit), glm::vec3(p + out * unit), roll};
}

std::vector<Vertex> ring() {
  return {vertex({10.3f, 5.1f, 0.7f}, {0, 0.1, 1}, 4.1, 6.3), vertex({0.9f, 7.7f, 11.3f}, {-1, 0, 0.2}, 5.9, 3.3, 0.3f),
          vertex({-9.1f, 6.1f, -0.3f}, {0.1, -0.2, -1}, 7.7, 4.9, 1.7f),
          vertex({0.3f, 4.3f, -12.1f}, {1, 0, 0}, 5.3, 6.1, -0.9f)};
}

void refused(const std::string& bytes, const std::string& place, const std::string& part) {
  const auto loaded = parse_nltrack(bytes, "a.nltrack");
  ASSERT_FALSE(loaded);
  EXPECT_EQ(loaded.status().code, base::Code::bad_file);
  EXPECT_NE(loaded.status().message.find("a.nltrack: error: at byte " + place), std::string::npos)
      << loaded.status().message;
  EXPECT_NE(loaded.status().message.find(part), std::string::npos) << loaded.status().message;
}

TEST(NoLimitsTrack, a_knot_at_the_place_of_the_one_before_is_left_out) {
  for (const bool closed : {false, true}) {
    const std::vector<Vertex> once = ring();
    std::vector<Vertex> twice;
    for (const Vertex& v : once) twice.push_back(v), twice.push_back(v);
    twice[2].out = twice[2].point, twice[3].in = twice[3].point + glm::vec3(0.3f, 2, 0.1f);  // unused
    if (closed) twice.push_back(twice[0]), twice.back().out += glm::vec3(1, 0.2f, 0);
    const auto loaded = parse_nltrack(encode(twice, closed), "a.nltrack"),
               simple = parse_nltrack(encode(once, closed), "a");
    ASSERT_TRUE(loaded) << loaded.status().message;
    EXPECT_TRUE(loaded->document == simple->document);
    ASSERT_EQ(loaded->warnings.size(), 1u);
    EXPECT_EQ(loaded->warnings[0], std::string(closed ? "5" : "4") +
                                       " knots repeat the place of the one before, the first is knot 2; left out");
  }
  refused(encode({ring()[0], ring()[0]}, false), "49", "expected knots at different places, found one");
}

TEST(NoLimitsTrack, knots_come_over_with_their_bits_and_handles_to_rounding) {
  for (const bool closed : {false, true}) {
    const auto loaded = parse_nltrack(encode(ring(), closed), "somewhere/My ring.nltrack");
    ASSERT_TRUE(loaded) << loaded.status().message;
    const world::Document& d = loaded->document;
    EXPECT_TRUE(loaded->warnings.empty());
    EXPECT_EQ(d.name, "My ring");
    EXPECT_EQ(d.track.closed, closed);
    ASSERT_EQ(d.track.knots.size(), 4u);
    EXPECT_EQ(d.track.segments.size(), closed ? 4u : 3u);
    EXPECT_EQ(world::broken_invariant(d), std::nullopt);
    for (std::size_t i = 0; i < 4; ++i) {
      const Vertex v = ring()[i];
      const world::Knot& k = world::knot(d, d.track.knots[i]);
      EXPECT_EQ(k.position, v.point);
      EXPECT_EQ(k.joint, world::JointKind::aligned);
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(world::in_handle(k)[axis], v.in[axis], 2e-7 * k.in_length + 2e-6);
        EXPECT_NEAR(world::out_handle(k)[axis], v.out[axis], 2e-7 * k.out_length + 2e-6);
      }
      EXPECT_NEAR(world::roll_deg(k), -base::degrees(double{v.roll}), 1e-4);
    }
  }
}

RC_GTEST_PROP(NoLimitsTrack, random_knots_keep_place_handles_and_roll, ()) {
  std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
  const auto value = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  std::vector<Vertex> vertices;
  for (int i = 0; i < 5; ++i)
    vertices.push_back(vertex({value(-900, 900), value(0, 90), value(-900, 900)},
                              {value(-1, 1), value(-0.7, 0.7), value(1, 2)}, value(1, 40), value(1, 40),
                              static_cast<float>(value(-3, 3))));
  const auto loaded = parse_nltrack(encode(vertices, true), "x.nltrack");
  RC_ASSERT(loaded.ok());
  RC_ASSERT(world::broken_invariant(loaded->document) == std::nullopt);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const world::Knot& k = world::knot(loaded->document, loaded->document.track.knots[i]);
    RC_ASSERT(k.position == vertices[i].point);
    RC_ASSERT(glm::length(glm::dvec3(world::in_handle(k)) - glm::dvec3(vertices[i].in)) < 2e-4);
    RC_ASSERT(glm::length(glm::dvec3(world::out_handle(k)) - glm::dvec3(vertices[i].out)) < 2e-4);
    RC_ASSERT(std::abs(std::remainder(world::roll_deg(k) + base::degrees(double{vertices[i].roll}), 360.0)) < 2e-3);
  }
}

// On a straight track the frame does not turn by itself: the twist is the difference of the rolls.
TEST(NoLimitsTrack, roll_that_goes_on_over_turns_is_ridden_in_full) {
  const float rolls[] = {0, 2.5f, 9.0f, -4.0f, 30.0f};
  std::vector<Vertex> vertices;
  for (int i = 0; i < 5; ++i)
    vertices.push_back(vertex({20.0f * static_cast<float>(i), 10, 0}, {1, 0, 0}, 6, 6, rolls[i]));
  const auto loaded = parse_nltrack(encode(vertices, false), "x.nltrack");
  ASSERT_TRUE(loaded) << loaded.status().message;
  sim::DerivedTrack derived;
  sim::derive(loaded->document, {}, {}, derived);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(derived.shape(derived.order[i]).roll.twist, -(double{rolls[i + 1]} - double{rolls[i]}), 1e-5) << i;
}

// On a level ring neither horizon nor frame turns against the other: the twist is the difference of the rolls, over the
// closing joint the least that leads back to the first roll.
TEST(NoLimitsTrack, the_closing_joint_gets_the_least_turn_back_to_the_first_roll) {
  for (const float step : {1.7f, -1.7f, 0.9f, 3.7f}) {
    std::vector<Vertex> vertices;
    for (int i = 0; i < 4; ++i) {
      const double a = M_PI / 2 * i;
      vertices.push_back(vertex({20 * std::cos(a), 5, -20 * std::sin(a)}, {-std::sin(a), 0, -std::cos(a)}, 11, 11,
                                step * static_cast<float>(i)));
    }
    const auto loaded = parse_nltrack(encode(vertices, true), "x.nltrack");
    ASSERT_TRUE(loaded) << loaded.status().message;
    sim::DerivedTrack derived;
    sim::derive(loaded->document, {}, {}, derived);
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(derived.shape(derived.order[i]).roll.twist, -double{step}, 1e-4) << i;
    double back = 3.0 * double{step};
    while (back > M_PI) back -= 2 * M_PI;
    while (back < -M_PI) back += 2 * M_PI;
    EXPECT_NEAR(derived.shape(derived.order[3]).roll.twist, back, 1e-4) << step;
  }
}

// A vertical loop without roll: inverted at the top, where the horizon has turned over.
TEST(NoLimitsTrack, a_plane_loop_has_no_turns) {
  const float half = static_cast<float>(base::kPi);
  const std::vector<Vertex> vertices{vertex({0, 0, 0}, {1, 0, 0}, 11, 11), vertex({0, 20, 0}, {-1, 0, 0}, 11, 11, half),
                                     vertex({0, 0, 1}, {1, 0, 0}, 11, 11, 2 * half)};
  const auto loaded = parse_nltrack(encode(vertices, false), "x.nltrack");
  ASSERT_TRUE(loaded) << loaded.status().message;
  sim::DerivedTrack derived;
  sim::derive(loaded->document, {}, {}, derived);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_LT(std::abs(derived.shape(derived.order[i]).roll.twist), 0.5) << i;
}

TEST(NoLimitsTrack, segments_without_a_size_are_read_as_well) {
  for (const bool closed : {false, true}) {
    std::string bytes = encode(ring(), closed);
    const auto sized = parse_nltrack(bytes, "a.nltrack");
    bytes.erase(bytes.size() - 9, 4);
    const auto bare = parse_nltrack(bytes, "a.nltrack");
    ASSERT_TRUE(sized.ok() && bare.ok());
    EXPECT_EQ(bare->document.track.closed, closed);
    EXPECT_EQ(world::hash(bare->document), world::hash(sized->document));
  }
}

TEST(NoLimitsTrack, cut_off_anywhere_it_is_refused_with_the_place) {
  const std::string whole = encode(ring(), true);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto loaded = parse_nltrack(std::string_view(whole).substr(0, size), "a.nltrack");
    ASSERT_FALSE(loaded) << size;
    ASSERT_NE(loaded.status().message.find("a.nltrack: error: at byte "), std::string::npos) << loaded.status().message;
  }
}

TEST(NoLimitsTrack, wrong_tags_sizes_and_counts_are_refused_before_anything_is_kept) {
  std::string bytes = encode(ring(), true);
  bytes.replace(kFront, 4, "BEZX");
  refused(bytes, "0:", "expected a chunk \"BEZR\"");
  bytes = encode(ring(), true);
  bytes.replace(bytes.size() - 13, 4, "SEGX");
  refused(bytes, std::to_string(bytes.size() - 13) + ":", "expected a chunk \"SEGM\"");
  bytes = encode(ring(), true);
  bytes.replace(kCount, 4, "\xff\xff\xff\xff");
  refused(bytes, std::to_string(kCount) + ":", "expected at most 4 knots, found 4294967295");
  bytes = encode(ring(), true);
  bytes.replace(kFront + 4, 4, "\x7f\xff\xff\xff");
  refused(bytes, std::to_string(kFront + 4) + ":", "2147483647 bytes");
  bytes = encode(ring(), true);
  bytes.back() = 7;
  refused(bytes, std::to_string(bytes.size() - 1) + ":", "closed byte 0 or 255, found 7");
  for (const bool closed : {false, true}) {
    const std::string place = std::to_string(kCount) + ":";
    refused(encode({}, closed), place, "expected at least 2 knots, found 0");
    refused(encode({ring()[0]}, closed), place, "expected at least 2 knots, found 1");
  }
}

TEST(NoLimitsTrack, numbers_that_are_none_or_too_large_are_refused) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 2e5f})
    for (int field = 0; field < 9; ++field) {
      std::vector<Vertex> vertices = ring();
      glm::vec3* const points[]{&vertices[1].point, &vertices[1].in, &vertices[1].out};
      (*points[field / 3])[field % 3] = bad;
      refused(encode(vertices, true), std::to_string(kFirst + 60 + 4 * static_cast<std::size_t>(field)) + ":",
              "expected a coordinate");
    }
  std::vector<Vertex> vertices = ring();
  vertices[2].roll = std::numeric_limits<float>::quiet_NaN();
  refused(encode(vertices, true), std::to_string(kFirst + 156) + ":", "roll");
  vertices[2].roll = 300;
  refused(encode(vertices, true), "", "turns");
}

TEST(NoLimitsTrack, handles_without_length_and_bent_ones_are_told_of) {
  std::vector<Vertex> vertices = ring();
  vertices[0].in = vertices[0].point, vertices[3].out = vertices[3].point;  // unused where it is open
  auto loaded = parse_nltrack(encode(vertices, false), "x.nltrack");
  ASSERT_TRUE(loaded);
  EXPECT_TRUE(loaded->warnings.empty());
  EXPECT_LT(loaded->import->max_error, 1e-5);
  EXPECT_LT(loaded->import->frame_error, 1e-3);
  loaded = parse_nltrack(encode(vertices, true), "x.nltrack");
  ASSERT_TRUE(loaded);
  ASSERT_EQ(loaded->warnings.size(), 1u);
  EXPECT_NE(loaded->warnings[0].find("2 handles shorter than 0.01"), std::string::npos);
  vertices = ring();
  vertices[1].out.y += 1;
  loaded = parse_nltrack(encode(vertices, true), "x.nltrack");
  ASSERT_TRUE(loaded);
  ASSERT_EQ(loaded->warnings.size(), 1u);
  EXPECT_NE(loaded->warnings[0].find("1 knots had handles that were not collinear, by up to "), std::string::npos);
  std::swap(vertices[1].in, vertices[2].in);
  refused(encode(vertices, true), std::to_string(kFirst + 60) + ":", "corner");
  vertices = ring();
  vertices[1].in = vertices[1].point, vertices[1].out = vertices[1].point;
  vertices[0].out = vertices[2].in;  // no direction from one neighbour to the other either
  refused(encode(vertices, true), std::to_string(kFirst + 60) + ":", "knot 2 has no direction");
}

TEST(NoLimitsTrack, handles_may_bend_by_a_right_angle_and_no_more) {
  for (const double degrees : {85.0, 89.0, 91.0, 100.0}) {
    std::vector<Vertex> vertices;
    for (int i = 0; i < 3; ++i) vertices.push_back(vertex({20.0f * static_cast<float>(i), 10, 0}, {1, 0, 0}, 6, 6));
    const double turn = base::radians(degrees);
    vertices[1].out = vertices[1].point + glm::vec3(6 * std::cos(turn), 0, 6 * std::sin(turn));
    const auto loaded = parse_nltrack(encode(vertices, false), "x.nltrack");
    EXPECT_EQ(loaded.ok(), degrees < 90) << degrees;
    if (!loaded) continue;
    // Each handle turns by half the bend; the curve moves most at t = 1/3, next to the place 5/16.
    EXPECT_NEAR(loaded->import->frame_error, degrees / 2, 1e-3);
    EXPECT_NEAR(loaded->import->rms_frame_error, degrees / 2 / std::sqrt(2), 1e-3);
    EXPECT_NEAR(loaded->import->max_error, 3 * 5 * 11 * 11 / 4096.0 * 12 * std::sin(turn / 4), 1e-5);
    EXPECT_LT(loaded->import->rms_error, loaded->import->max_error);
  }
}

TEST(NoLimitsTrack, spoilt_bytes_give_a_document_that_holds_its_promises_or_an_error) {
  std::mt19937 random(7);
  const std::string whole = encode(ring(), true);
  int good = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string bytes = whole;
    for (int k = 0; k < 3; ++k) bytes[random() % bytes.size()] = static_cast<char>(random());
    const auto loaded = parse_nltrack(bytes, "x.nltrack");
    if (!loaded) continue;
    ++good;
    ASSERT_EQ(world::broken_invariant(loaded->document), std::nullopt) << round;
  }
  EXPECT_GT(good, 100);
}

}  // namespace nltrack_test
}  // namespace coaster::exchange
