#include "sim/solids/train_mesh.h"

#include <cmath>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "sim/solids.h"
#include "sim/solids/clearance.h"
#include "sim/solids/track_mesh.h"

namespace coaster::sim {
namespace train_mesh_test {

using test::volume;

struct Bounds {
  glm::vec3 low{9}, high{-9};
};
template <class Rule>
Bounds bounds_of(const Mesh& mesh, const Rule& rule) {
  Bounds b;
  for (const MeshVertex& v : mesh.vertices)
    if (rule(v)) b.low = glm::min(b.low, v.position), b.high = glm::max(b.high, v.position);
  return b;
}
auto of(Material part) {
  return [part](const MeshVertex& v) { return v.part == static_cast<float>(part); };
}

TEST(train_mesh, cars_are_closed_and_face_outwards) {
  for (const Mesh& mesh : {car_mesh(true), car_mesh(false), coupling_mesh(), distant_car_mesh()}) {
    EXPECT_TRUE(test::finite(mesh));
    EXPECT_EQ(test::wrong_normals(mesh), 0);
    EXPECT_EQ(test::open_edges(mesh), 0);
    EXPECT_EQ(test::inside_out(mesh, mesh.indices), 0);
  }
  for (const bool leading : {true, false})
    for (const Material part : {Material::wheel, Material::seat, Material::skin})
      EXPECT_GT(volume(car_mesh(leading), part), 0);
}

TEST(train_mesh, a_car_is_as_long_as_what_collides_and_narrower_than_what_stands_beside_it) {
  for (const bool leading : {true, false}) {
    const Bounds all = bounds_of(car_mesh(leading), [](const MeshVertex&) { return true; });
    EXPECT_NEAR(all.high.x, 1.1, 1e-5);
    EXPECT_NEAR(all.low.x, -1.1, 1e-5);
    EXPECT_NEAR(all.low.z, -all.high.z, 1e-5);
    EXPECT_LT(all.high.z, 1.0);  // platforms begin there
    EXPECT_LT(all.high.y, 1.5);
  }
}

TEST(train_mesh, wheels_touch_the_rails_from_above_beside_and_below) {
  const Mesh mesh = car_mesh(false);
  std::set<char> touched;
  for (const MeshVertex& v : mesh.vertices) {
    if (v.part != static_cast<float>(Material::wheel)) continue;
    const double beside = std::abs(v.position.z) - kGauge / 2, over = v.position.y;
    EXPECT_GT(std::hypot(beside, over), kRailRadius - 1e-5) << "a wheel cuts into its rail";
    if (std::abs(over - kRailRadius) < 5e-3) touched.insert('a');
    if (std::abs(beside - kRailRadius) < 5e-3) touched.insert('b');
    if (std::abs(over + kRailRadius) < 5e-3) touched.insert('c');
    const bool with_the_riders = std::hypot(v.position.z, v.position.y - kRiderLift) < kRiderRadius;
    EXPECT_TRUE(with_the_riders || std::hypot(beside, over) < kWheelRoom) << "supports keep out of both";
  }
  EXPECT_EQ(touched.size(), 3u);
}

TEST(train_mesh, the_leading_car_alone_has_a_nose) {
  const auto high_in_front = [](const MeshVertex& v) { return of(Material::body)(v) && v.position.x > 0.5f; };
  const Bounds nose = bounds_of(car_mesh(true), high_in_front), plain = bounds_of(car_mesh(false), high_in_front);
  EXPECT_GT(nose.high.y, plain.high.y + 0.02f);
  // It is round: its tip is much narrower than it.
  const auto tip = [](const MeshVertex& v) { return of(Material::body)(v) && v.position.x > 1.09f; };
  EXPECT_LT(bounds_of(car_mesh(true), tip).high.z, 0.4f * nose.high.z);
  EXPECT_GT(bounds_of(car_mesh(false), tip).high.z, 0.6f * plain.high.z);
}

TEST(train_mesh, riders_sit_in_two_rows_of_two_and_out_of_the_ride_cameras_sight) {
  const Mesh mesh = car_mesh(true);
  std::set<std::pair<int, int>> heads;
  const Bounds skin = bounds_of(mesh, of(Material::hair));
  EXPECT_GT(skin.high.y, 1.2f);
  for (const MeshVertex& v : mesh.vertices)
    if (v.part == static_cast<float>(Material::skin) && v.position.y > 1.2f) {
      heads.insert({v.position.x > -0.5f, v.position.z > 0});
      EXPECT_LT(v.position.x, 0) << "the eye is over the middle and looks forward";
    }
  EXPECT_EQ(heads.size(), 4u);
}

TEST(train_mesh, a_coupling_is_a_metre_along_x) {
  const Bounds all = bounds_of(coupling_mesh(), [](const MeshVertex&) { return true; });
  EXPECT_NEAR(all.low.x, 0, 1e-6);
  EXPECT_NEAR(all.high.x, 1, 1e-6);
  EXPECT_LT(all.high.y, 0.1f);
}

}  // namespace train_mesh_test
}  // namespace coaster::sim
