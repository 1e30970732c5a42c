#include "sim/track_mesh.h"

#include <gtest/gtest.h>

#include "sim/tracks.h"

namespace coaster::sim {
namespace track_mesh_test {

bool finite(const Mesh& mesh) {
  for (const MeshVertex& v : mesh.vertices)
    for (int i = 0; i < 3; ++i)
      if (!std::isfinite(v.position[i]) || !std::isfinite(v.normal[i])) return false;
  return true;
}

// Volume enclosed by the triangles of one part, by the divergence theorem: negative when they are turned inside out.
double volume(const Mesh& mesh, Part part) {
  double sum = 0;
  const glm::dvec3 origin(mesh.vertices.at(0).position);
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const MeshVertex& a = mesh.vertices.at(mesh.indices[i]);
    if (a.part != static_cast<float>(part)) continue;
    const glm::dvec3 b(mesh.vertices.at(mesh.indices[i + 1]).position), c(mesh.vertices.at(mesh.indices[i + 2]).position);
    sum += glm::dot(glm::dvec3(a.position) - origin, glm::cross(b - origin, c - origin)) / 6;
  }
  return sum;
}

// Triangles whose corner normals point to the side from which they are clockwise, or that are not closer to 1 than a percent.
int wrong_normals(const Mesh& mesh) {
  int wrong = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const MeshVertex *a = &mesh.vertices[mesh.indices[i]], *b = &mesh.vertices[mesh.indices[i + 1]], *c = &mesh.vertices[mesh.indices[i + 2]];
    const glm::vec3 face = glm::cross(b->position - a->position, c->position - a->position);
    for (const MeshVertex* v : {a, b, c}) {
      // Fans over the ends of tubes use the tube's own normals, which are at right angles to them.
      if (glm::dot(face, v->normal) < -1e-3f * glm::length(face) - 1e-6f || std::abs(glm::length(v->normal) - 1) > 1e-5f) ++wrong;
    }
  }
  return wrong;
}

Mesh swept(const SegmentShape& shape) {
  Mesh mesh;
  sweep_track(shape, mesh);
  return mesh;
}

TEST(track_mesh, tubes_enclose_the_volume_of_octagonal_prisms) {
  const world::Document d = test::straight_document({3.3f, 7.1f, -2.9f}, {17.7f, 11.3f, 9.1f});
  const Derived derived = test::derived_of(d);
  const Mesh mesh = swept(derived.shape(derived.order[0]));
  const double length = glm::distance(glm::dvec3(3.3, 7.1, -2.9), glm::dvec3(17.7, 11.3, 9.1));
  const double octagon = 4 * std::sin(M_PI / 4);  // area for circumradius 1: n/2 sin(2 pi/n)
  EXPECT_NEAR(volume(mesh, Part::rail), 2 * octagon * kRailRadius * kRailRadius * length, 1e-4 * length);
  EXPECT_NEAR(volume(mesh, Part::spine), octagon * kSpineRadius * kSpineRadius * length, 1e-4 * length);
  EXPECT_GT(volume(mesh, Part::tie), 0);
  EXPECT_EQ(wrong_normals(mesh), 0);
}

TEST(track_mesh, normals_of_bent_track_point_outwards) {
  for (const auto& d : {test::ring_document(8, 21.3), test::sample_document(), test::circle_document(7.5, {3.1, 2.2, -1.7}, {1, 0, 0.3}, 8)}) {
    const Derived derived = test::derived_of(d);
    for (const world::Entity e : derived.order) {
      const Mesh mesh = swept(derived.shape(e));
      EXPECT_TRUE(finite(mesh));
      EXPECT_EQ(wrong_normals(mesh), 0);
      EXPECT_GT(volume(mesh, Part::rail), 0);
      for (const std::uint32_t i : mesh.indices) ASSERT_LT(i, mesh.vertices.size());
    }
  }
}

TEST(track_mesh, rails_run_a_gauge_apart_on_the_rails_plane) {
  // On the straight the frame is known by hand: forward (0.8, 0, 0.6), up Y, left = up x forward = (0.6, 0, -0.8).
  const world::Document d = test::straight_document({1.7f, 4.3f, 2.1f}, {9.7f, 4.3f, 8.1f});
  const Derived derived = test::derived_of(d);
  const Mesh mesh = swept(derived.shape(derived.order[0]));
  const glm::dvec3 left(0.6, 0, -0.8), start(1.7, 4.3, 2.1);
  double widest = 0, lowest = 0;
  for (const MeshVertex& v : mesh.vertices) {
    const double x = glm::dot(glm::dvec3(v.position) - start, left), y = v.position.y - 4.3;
    if (v.part == static_cast<float>(Part::tie)) widest = std::max(widest, std::abs(x)), lowest = std::min(lowest, y);
    if (v.part == static_cast<float>(Part::rail)) {
      EXPECT_NEAR(std::hypot(std::abs(x) - kGauge / 2, y), kRailRadius, 1e-5);
    }
    if (v.part == static_cast<float>(Part::spine)) {
      EXPECT_NEAR(std::hypot(x, y + kSpineDrop), kSpineRadius, 1e-5);
    }
  }
  // Ties end inside the rails and inside the spine.
  EXPECT_NEAR(widest, kGauge / 2, kRailRadius);
  EXPECT_NEAR(lowest, -kSpineDrop, kSpineRadius);
}

TEST(track_mesh, end_rings_of_neighbours_coincide) {
  world::Document d = test::ring_document(7, 19.1);
  for (std::size_t i = 0; i < 7; ++i) world::set_roll(d.entities.get<world::Knot>(d.track.knots[i]), 31.7 * static_cast<double>(i) - 90);
  d.entities.get<world::Segment>(d.track.segments[3]).turns = 2;
  const Derived derived = test::derived_of(d);
  for (std::size_t i = 0; i < derived.order.size(); ++i) {
    const Mesh before = swept(derived.shape(derived.order[i])), after = swept(derived.shape(derived.order[(i + 1) % derived.order.size()]));
    // The first tube is a rail: its last ring stands before the second tube's first, which the same number of vertices precede.
    std::size_t tube = 0;
    while (before.vertices[tube].part == static_cast<float>(Part::rail)) ++tube;
    tube /= 2;
    for (std::size_t k = 0; k < kTubeSides; ++k) {
      const MeshVertex &a = before.vertices[tube - kTubeSides + k], &b = after.vertices[k];
      // Handles are rounded to float, so the two sides' tangents differ by 1e-6.
      EXPECT_LT(glm::distance(a.position, b.position), 2e-5f) << "joint " << i;
      EXPECT_LT(glm::distance(a.normal, b.normal), 2e-5f);
    }
  }
}

TEST(track_mesh, degenerate_segments_give_no_nan) {
  const auto shape_of = [](glm::vec3 p, glm::vec3 q, float in, float out, glm::vec3 tangent, int turns) {
    world::Document d;
    world::append_knot(d, test::skew_knot(p, tangent, in, out));
    world::append_knot(d, test::skew_knot(q, -tangent, in, out));
    d.entities.get<world::Segment>(d.track.segments[0]).turns = turns;
    return test::derived_of(d).segments.items()[0];
  };
  const glm::vec3 p(7.3f, 1.9f, -5.7f);
  EXPECT_TRUE(finite(swept(shape_of(p, p, world::kMinHandle, world::kMinHandle, {0.3f, 0.2f, 0.9f}, 0))));
  EXPECT_TRUE(finite(swept(shape_of(p, p, 5, 5, {0, 1, 0}, 16))));
  EXPECT_TRUE(finite(swept(shape_of(p, p + glm::vec3(0, 9.1f, 0), 3, 3, {0, 1, 0}, -16))));
  EXPECT_TRUE(finite(swept(shape_of(p, p + glm::vec3(4, 0, 0), 4, 4, {-1, 0, 0}, 3))));
  EXPECT_TRUE(finite(swept(shape_of(glm::vec3(1e5f), glm::vec3(-1e5f), world::kMaxHandle, world::kMaxHandle, {1, 0.1f, 0}, 16))));
  SegmentShape point;  // four equal points
  point.key.cubic = {p, p, p, p};
  point.key.up_from = point.key.up_to = {0, 1, 0};
  point.arc = curve::ArcLengthMap(point.key.cubic);
  point.frames.resize(kFrameIntervals + 1);
  EXPECT_TRUE(finite(swept(point)));
}

TEST(track_mesh, rings_follow_bend_and_twist_within_their_cap) {
  const auto rings = [](const world::Document& d) {
    const Derived derived = test::derived_of(d);
    const Mesh mesh = swept(derived.shape(derived.order[0]));
    std::size_t spine = 0;
    for (const MeshVertex& v : mesh.vertices) spine += v.part == static_cast<float>(Part::spine);
    return spine / kTubeSides;
  };
  world::Document straight = test::straight_document({1.1f, 2.3f, 3.7f}, {81.1f, 2.3f, 3.7f});
  EXPECT_EQ(rings(straight), 2u);
  straight.entities.get<world::Segment>(straight.track.segments[0]).turns = 2;
  EXPECT_NEAR(static_cast<double>(rings(straight)), 720 / 6 + 1, 1.0);
  straight.entities.get<world::Segment>(straight.track.segments[0]).turns = 16;
  EXPECT_EQ(rings(straight), static_cast<std::size_t>(kMaxRings));
  EXPECT_NEAR(static_cast<double>(rings(test::circle_document(5.0, {1, 2, 3}, {1, 0, 0}, 8))), 45 / 6.0 + 1.5, 1.0);
  // 90 degrees over 157 m: length decides.
  EXPECT_NEAR(static_cast<double>(rings(test::circle_document(100.0, {1, 2, 3}, {1, 0, 0}, 4))), 157.1 / 3 + 1.5, 1.0);
}

TEST(track_mesh, five_thousand_segments_stay_under_a_million_and_a_half_vertices) {
  // A ring of 20 m radius bends as much as coasters do; one of its 10 m segments counts for 5,000.
  const int count = 13;
  const Derived derived = test::derived_of(test::ring_document(count, 20.0, 2.0));
  std::size_t vertices = 0;
  for (const world::Entity e : derived.order) vertices += swept(derived.shape(e)).vertices.size();
  EXPECT_GT(derived.length / count, 9.6);
  EXPECT_LT(vertices * 5000 / count, 1'500'000u);
}

TEST(track_mesh, the_cart_fits_its_box_and_is_closed) {
  const Mesh mesh = cart_mesh();
  glm::vec3 low(9), high(-9);
  for (const MeshVertex& v : mesh.vertices) low = glm::min(low, v.position), high = glm::max(high, v.position);
  EXPECT_NEAR(high.x - low.x, 2.2, 1e-5);
  EXPECT_NEAR(high.z - low.z, 1.3, 1e-5);
  EXPECT_NEAR(high.y, 1.1, 1e-5);
  EXPECT_NEAR(low.y, kRailRadius, 1e-5);  // wheels touch the rails
  EXPECT_EQ(wrong_normals(mesh), 0);
  for (const Part part : {Part::body, Part::stripe, Part::wheel}) EXPECT_GT(volume(mesh, part), 0);
  // Closed: the faces' area vectors of each part cancel.
  for (const Part part : {Part::body, Part::stripe, Part::wheel}) {
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      const MeshVertex &v = mesh.vertices[mesh.indices[i]], &b = mesh.vertices[mesh.indices[i + 1]], &c = mesh.vertices[mesh.indices[i + 2]];
      if (v.part == static_cast<float>(part)) sum += glm::cross(b.position - v.position, c.position - v.position);
    }
    EXPECT_LT(glm::length(sum), 1e-4);
  }
}

}  // namespace track_mesh_test
}  // namespace coaster::sim
