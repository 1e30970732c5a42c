// Wavefront OBJ.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "exchange/export/shape_export.h"
#include "exchange/export/shape_readers.h"
#include "sim/solids/supports.h"
#include "sim/solids/track_mesh.h"

namespace coaster::exchange {
namespace obj_print_test {

constexpr int kRailSides = 8, kSpineSides = 12;  // of steel

using test::closed_document;
using test::Obj;
using test::read_obj;

// How far a point is from the track's exact curve.
double off_track(const world::Document& d, glm::vec3 p) {
  double least = 1e9;
  for (const world::Entity s : d.track.segments)
    least = std::min(least, curve::nearest_point(world::cubic_of(d, s), glm::dvec3(p)).distance);
  return least;
}

// Six times the volume that triangles enclose; positive when they face outwards.
double volume(const std::vector<glm::vec3>& positions, const std::vector<std::uint32_t>& indices) {
  double sum = 0;
  const glm::dvec3 origin(positions.at(0));
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const glm::dvec3 a(positions.at(indices[i])), b(positions.at(indices[i + 1])), c(positions.at(indices[i + 2]));
    sum += glm::dot(a - origin, glm::cross(b - origin, c - origin));
  }
  return sum / 6;
}

// Of two rails and a spine, at one end: a fan over n corners has n - 2 triangles.
constexpr std::size_t kCapTriangles = 2 * (kRailSides - 2) + kSpineSides - 2;

// The triangles of a tube's cap are the flat faces across the track: counts those at each end of a segment. Corners of
// sides are in two rings.
std::size_t caps_of(const Obj& obj, const char* group, const world::Document& d) {
  std::size_t caps = 0;
  const std::vector<std::uint32_t>& faces = obj.faces.at(group);
  for (const world::Entity e : d.track.knots) {
    const world::Knot& knot = world::knot(d, e);
    for (std::size_t i = 0; i < faces.size(); i += 3) {
      bool across = true;
      for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 off = glm::dvec3(obj.v.at(faces[i + k])) - glm::dvec3(knot.position);
        across = across && glm::length(off) < 1.2 && std::abs(glm::dot(off, glm::dvec3(knot.tangent))) < 1e-4;
      }
      caps += across;
    }
  }
  return caps;
}

// Returns the edges that are not in two triangles, once in each direction. Corners are equal if their positions are,
// bit for bit.
std::size_t open_edges(const Obj& obj, const char* group) {
  using G2Unknowns = std::array<float, 3>;
  std::map<std::pair<G2Unknowns, G2Unknowns>, int> ways;
  const std::vector<std::uint32_t>& faces = obj.faces.at(group);
  const auto point = [&](std::size_t i) {
    const glm::vec3 p = obj.v.at(faces[i]);
    return G2Unknowns{p.x, p.y, p.z};
  };
  for (std::size_t i = 0; i < faces.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k) ++ways[{point(i + k), point(i + (k + 1) % 3)}];
  return static_cast<std::size_t>(std::ranges::count_if(ways, [&](const auto& way) {
    const auto back = ways.find({way.first.second, way.first.first});
    return way.second != 1 || back == ways.end() || back->second != 1;
  }));
}

TEST(Obj, tubes_have_caps_at_the_ends_of_open_track_alone_and_every_edge_twice) {
  for (const world::Document& d : {test::sample_document(), closed_document()}) {
    const Obj obj = read_obj(print_obj(d));
    const std::size_t ends = d.track.closed ? 0 : 2;
    EXPECT_EQ(caps_of(obj, "rails", d), 2 * ends * (kRailSides - 2));
    EXPECT_EQ(caps_of(obj, "spine", d), ends * (kSpineSides - 2));
    EXPECT_EQ(open_edges(obj, "rails"), 0u);
    EXPECT_EQ(open_edges(obj, "spine"), 0u);
  }
}

TEST(Obj, has_the_swept_track_and_the_centre_line) {
  for (const world::Document& d : {test::sample_document(), closed_document()}) {
    const Obj obj = read_obj(print_obj(d));
    sim::DerivedTrack derived;
    sim::derive(d, {}, {}, derived);
    std::size_t triangles = 0, vertices = 0;
    sim::Mesh mesh;
    for (const world::Entity s : d.track.segments) {
      sim::sweep_track(derived.shape(s), mesh);
      triangles += mesh.indices.size(), vertices += mesh.vertices.size();
    }
    triangles -= 3 * kCapTriangles * 2 * (d.track.segments.size() - (d.track.closed ? 0 : 1));
    sim::Supports supports;
    supports.update(derived);
    for (const world::Entity s : d.track.segments) {
      sim::build_support_mesh(*supports.of(s), sim::form_of(world::CoasterKind::steel), mesh);
      triangles += mesh.indices.size(), vertices += mesh.vertices.size();
    }
    const auto size_of = [&](const char* group) {
      return obj.faces.count(group) != 0 ? obj.faces.at(group).size() : 0;
    };
    EXPECT_EQ(size_of("rails") + size_of("spine") + size_of("ties") + size_of("supports") + size_of("concrete"),
              triangles);
    for (const char* group : {"supports", "concrete"}) EXPECT_GT(volume(obj.v, obj.faces.at(group)), 0);
    EXPECT_GT(supports.count(), 0);
    EXPECT_EQ(size_of("equipment"), 0u);
    EXPECT_EQ(obj.vn.size(), vertices);
    EXPECT_EQ(obj.v.size(), vertices + obj.line.size());
    for (const glm::vec3 n : obj.vn) ASSERT_NEAR(glm::length(n), 1, 1e-5);
    // Two tubes of octagons along the track; the bends make their lengths differ from the curve's a little.
    const double octagon = 2 * std::sqrt(2.0), length = derived.length;
    EXPECT_NEAR(volume(obj.v, obj.faces.at("rails")), 2 * octagon * sim::kRailRadius * sim::kRailRadius * length,
                0.03 * length * sim::kRailRadius);
    EXPECT_GT(volume(obj.v, obj.faces.at("spine")), 0);
    EXPECT_GT(volume(obj.v, obj.faces.at("ties")), 0);
    ASSERT_GT(obj.line.size(), 10u);
    const glm::vec3 first = obj.v.at(obj.line.front()), last = obj.v.at(obj.line.back());
    EXPECT_EQ(first, world::knot(d, d.track.knots.front()).position);
    EXPECT_EQ(last, world::knot(d, d.track.closed ? d.track.knots.front() : d.track.knots.back()).position);
    for (std::size_t i = 0; i + 1 < obj.line.size(); ++i) {
      const glm::vec3 a = obj.v.at(obj.line[i]), b = obj.v.at(obj.line[i + 1]);
      ASSERT_LT(off_track(d, a), 2e-5);
      ASSERT_LT(off_track(d, 0.5f * (a + b)), 0.00103);
    }
  }
}

}  // namespace obj_print_test
}  // namespace coaster::exchange
