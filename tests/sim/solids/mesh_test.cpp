#include "sim/solids/mesh.h"

#include <gtest/gtest.h>

#include "sim/solids.h"
#include "sim/solids/train_mesh.h"

namespace coaster::sim {
namespace mesh_test {

using glm::dvec2;
using glm::dvec3;
using test::open_edges;
using test::volume;
using test::wrong_normals;

curve::Frame skew_frame() {
  const dvec3 forward = glm::normalize(dvec3(0.3, -0.4, 0.8));
  return {forward, curve::perpendicular(forward, {0.2, 0.9, 0.1})};
}

// Two rings that face each other, `length` apart.
std::vector<Ring> straight_rings(double length) {
  const curve::Frame frame = skew_frame();
  const dvec3 start(3.7, 11.3, -6.1);
  return {{start, frame, 0},
          {start + 0.4 * length * frame.forward, frame, 0.4f},
          {start + length * frame.forward, frame, 1}};
}

void expect_solid(const Mesh& mesh, Material part, double expected, double tolerance) {
  EXPECT_TRUE(test::finite(mesh));
  EXPECT_EQ(open_edges(mesh), 0);
  EXPECT_EQ(test::inside_out(mesh, mesh.indices), 0);
  EXPECT_EQ(wrong_normals(mesh), 0);
  EXPECT_NEAR(volume(mesh, part), expected, tolerance);
}

TEST(mesh, a_tube_is_a_closed_prism_in_full_and_from_afar) {
  Mesh mesh;
  add_tube(straight_rings(7.3), {{0.4, -0.9}, 0.31, 12, 4, Material::spine}, mesh);
  expect_solid(mesh, Material::spine, 6 * std::sin(M_PI / 6) * 0.31 * 0.31 * 7.3, 1e-4);
  EXPECT_EQ(open_edges(mesh, mesh.coarse), 0);
  EXPECT_EQ(wrong_normals(mesh, mesh.coarse), 0);
  EXPECT_NEAR(volume(mesh, Material::spine, mesh.coarse), 2 * 0.31 * 0.31 * 7.3, 1e-4);
  EXPECT_LT(3 * mesh.coarse.size(), mesh.indices.size());
}

TEST(mesh, a_beam_holds_its_cross_section_times_its_length) {
  Mesh mesh;
  add_beam(straight_rings(5.9), {-0.7, 0.2}, {0.5, 0.33}, Material::deck, true, mesh);
  expect_solid(mesh, Material::deck, 1.2 * 0.13 * 5.9, 1e-4);
  EXPECT_EQ(mesh.coarse, mesh.indices);
  Mesh only_near;
  add_beam(straight_rings(5.9), {-0.7, 0.2}, {0.5, 0.33}, Material::deck, false, only_near);
  EXPECT_TRUE(only_near.coarse.empty());
}

TEST(mesh, a_box_and_a_bar_are_where_they_are_asked_for) {
  Mesh box;
  add_box({1.3, 2.9, -4.1}, skew_frame(), {0.4, 0.3, 0.7}, Material::fin, true, box);
  expect_solid(box, Material::fin, 8 * 0.4 * 0.3 * 0.7, 1e-5);
  dvec3 sum(0);
  for (const MeshVertex& v : box.vertices) sum += dvec3(v.position);
  EXPECT_LT(glm::distance(sum / static_cast<double>(box.vertices.size()), dvec3(1.3, 2.9, -4.1)), 1e-6);
  Mesh bar;
  const dvec3 from(2.1, 0.4, 7.7), to(3.3, -5.9, 8.1);
  add_bar(from, to, 0.5, 0.2, 24, Material::support, true, bar);
  // A frustum of 24 sides: a third of its height times A + sqrt(A B) + B.
  const double unit = 12 * std::sin(M_PI / 12);
  expect_solid(bar, Material::support, glm::distance(from, to) / 3 * unit * (0.25 + 0.1 + 0.04), 1e-4);
  for (const MeshVertex& v : bar.vertices) {
    const dvec3 along = glm::normalize(to - from), p = dvec3(v.position) - from;
    const double s = glm::dot(p, along) / glm::distance(from, to);
    EXPECT_NEAR(glm::length(p - glm::dot(p, along) * along), 0.5 - 0.3 * s, 1e-5);
  }
}

TEST(mesh, a_bar_without_length_adds_nothing) {
  Mesh mesh;
  add_bar({1, 2, 3}, {1, 2, 3}, 0.5, 0.2, 8, Material::support, true, mesh);
  EXPECT_TRUE(mesh.vertices.empty() && mesh.indices.empty());
}

TEST(mesh, a_ball_is_round) {
  Mesh mesh;
  add_ball({0.7, 1.9, -0.3}, {0.5, 0.8, 0.3}, 32, Material::skin, mesh);
  EXPECT_EQ(wrong_normals(mesh), 0);
  EXPECT_NEAR(volume(mesh, Material::skin), 4 * M_PI / 3 * 0.5 * 0.8 * 0.3, 0.01);
}

}  // namespace mesh_test
}  // namespace coaster::sim
