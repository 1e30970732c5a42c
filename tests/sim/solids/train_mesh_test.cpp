#include "sim/solids/train_mesh.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "sim/kinds.h"
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

class TrainMeshOfKind : public testing::TestWithParam<world::CoasterKind> {};
INSTANTIATE_TEST_SUITE_P(all, TrainMeshOfKind, testing::ValuesIn(test::kinds()), test::kind_name);

TEST_P(TrainMeshOfKind, cars_are_closed_and_face_outwards) {
  const world::CoasterKind kind = GetParam();
  for (const Mesh& mesh : {car_mesh(kind, true), car_mesh(kind, false), coupling_mesh(), distant_car_mesh(kind),
                           car_mesh(kind, true, {1, true}), car_mesh(kind, false, {1, false})}) {
    EXPECT_TRUE(test::finite(mesh));
    EXPECT_EQ(test::wrong_normals(mesh), 0);
    EXPECT_EQ(test::open_edges(mesh), 0);
    EXPECT_EQ(test::inside_out(mesh, mesh.indices), 0);
  }
  for (const bool leading : {true, false})
    for (const Material part : {Material::wheel, Material::seat, Material::skin, Material::body})
      if (kind != world::CoasterKind::inverted || part != Material::seat)
        EXPECT_GT(volume(car_mesh(kind, leading), part), 0);
}

TEST_P(TrainMeshOfKind, a_car_is_as_long_as_what_collides_and_narrower_than_what_stands_beside_it) {
  const CoasterForm& form = form_of(GetParam());
  for (const bool leading : {true, false}) {
    const Mesh mesh = car_mesh(GetParam(), leading);
    const Bounds all = bounds_of(mesh, [](const MeshVertex&) { return true; });
    EXPECT_NEAR(all.high.x, 1.1, 1e-5);
    EXPECT_NEAR(all.low.x, -1.1, 1e-5);
    EXPECT_NEAR(all.low.z, -all.high.z, 1e-5);
    EXPECT_LT(all.high.z, 1.0);  // platforms begin there
    for (const MeshVertex& v : mesh.vertices)
      ASSERT_LT(std::hypot(v.position.z, v.position.y - static_cast<float>(form.train.lift)), form.train.radius)
          << "conflicts count this as the train";
  }
}

TEST_P(TrainMeshOfKind, wheels_touch_the_rails_from_above_beside_and_below) {
  const CoasterForm& form = form_of(GetParam());
  const Mesh mesh = car_mesh(GetParam(), false);
  std::set<char> touched;
  for (const MeshVertex& v : mesh.vertices) {
    if (v.part != static_cast<float>(Material::wheel)) continue;
    const double beside = std::abs(v.position.z) - kGauge / 2, over = v.position.y;
    EXPECT_GT(std::hypot(beside, over), kRailRadius - 1e-5) << "a wheel cuts into its rail";
    if (std::abs(over - kRailRadius) < 5e-3) touched.insert('a');
    if (std::abs(beside - kRailRadius) < 5e-3) touched.insert('b');
    if (std::abs(over + kRailRadius) < 5e-3) touched.insert('c');
    const bool with_the_riders =
        std::hypot(double{v.position.z}, double{v.position.y} - form.riders.lift) < form.riders.radius;
    EXPECT_TRUE(with_the_riders || std::hypot(beside, over) < form.wheels) << "supports keep out of both";
  }
  EXPECT_EQ(touched.size(), 3u);
}

// The ride camera is over the middle of the first car, at the height of the riders' eyes, and looks forward.
TEST_P(TrainMeshOfKind, nothing_of_the_first_car_stands_before_the_riders_eyes) {
  const float eye = static_cast<float>(form_of(GetParam()).eye);
  for (const MeshVertex& v : car_mesh(GetParam(), true).vertices) {
    if (v.position.x <= 0.05f || std::abs(v.position.z) > 0.5f) continue;
    const float rise = (v.position.y - eye) / v.position.x;
    ASSERT_TRUE(rise < 0.12f || rise > 0.6f) << v.position.x << " " << v.position.y << " " << v.position.z;
  }
}

// Seats and wheels are darker than heads, except where riders hang below the rails.
TEST_P(TrainMeshOfKind, the_body_hides_the_sky_from_what_is_below_it) {
  const bool hangs = form_of(GetParam()).side < 0;
  int hidden = 0;
  for (const MeshVertex& v : car_mesh(GetParam(), false).vertices) {
    EXPECT_LT(v.along, 1);
    hidden += v.along > 0.3f;
    if (v.part == static_cast<float>(Material::wheel)) EXPECT_EQ(v.along > 0.3f, !hangs && v.position.y < 0.3f);
    if (v.position.y > 1) EXPECT_LE(v.along, 0);
  }
  EXPECT_EQ(hidden > 100, !hangs);
}

TEST_P(TrainMeshOfKind, riders_hearts_are_at_the_kinds_heartline) {
  const Mesh mesh = car_mesh(GetParam(), false);
  const Bounds hair = bounds_of(mesh, of(Material::hair));
  const double heart = base::row_of(GetParam()).heartline;
  EXPECT_GT(hair.high.y, heart + 0.2);
  EXPECT_LT(hair.high.y, heart + 0.75);
}

TEST_P(TrainMeshOfKind, nothing_of_a_car_floats_or_hangs_below_its_riders_shoes_and_wheels) {
  for (const bool leading : {true, false})
    for (const bool raised : {true, false}) {
      const Mesh mesh = car_mesh(GetParam(), leading, {0, raised});
      EXPECT_EQ(test::separate_groups(mesh, 0.02f), 1) << leading << " " << raised;
      const auto frame = [](const MeshVertex& v) { return of(Material::body)(v) || of(Material::stripe)(v); };
      const auto others = [&](const MeshVertex& v) { return !frame(v); };
      EXPECT_GE(bounds_of(mesh, frame).low.y, bounds_of(mesh, others).low.y) << leading << " " << raised;
    }
}

TEST(train_mesh, the_leading_car_alone_has_a_nose) {
  const auto high_in_front = [](const MeshVertex& v) { return of(Material::body)(v) && v.position.x > 0.5f; };
  const Bounds nose = bounds_of(car_mesh({}, true), high_in_front),
               plain = bounds_of(car_mesh({}, false), high_in_front);
  EXPECT_GT(nose.high.y, plain.high.y + 0.02f);
  // It is round: its tip is much narrower than it.
  const auto tip = [](const MeshVertex& v) { return of(Material::body)(v) && v.position.x > 1.09f; };
  EXPECT_LT(bounds_of(car_mesh({}, true), tip).high.z, 0.4f * nose.high.z);
  EXPECT_GT(bounds_of(car_mesh({}, false), tip).high.z, 0.6f * plain.high.z);
}

TEST(train_mesh, riders_sit_in_two_rows_of_two_and_out_of_the_ride_cameras_sight) {
  const Mesh mesh = car_mesh({}, true);
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

// Raised hands stay within what trains need, and well below it nothing else moves.
TEST_P(TrainMeshOfKind, riders_raise_their_arms_within_the_envelope) {
  const CoasterForm& form = form_of(GetParam());
  const Mesh down = car_mesh(GetParam(), false), up = car_mesh(GetParam(), false, {0, true});
  ASSERT_EQ(down.vertices.size(), up.vertices.size());
  float raised = 0;
  for (std::size_t i = 0; i < up.vertices.size(); ++i) {
    const glm::vec3 a = down.vertices[i].position, b = up.vertices[i].position;
    if (a == b) continue;
    raised = std::max(raised, b.y - a.y);
    ASSERT_LT(std::hypot(b.z, b.y - static_cast<float>(form.riders.lift)), form.riders.radius + 0.01);
  }
  EXPECT_GT(raised, 0.6f);
}

TEST_P(TrainMeshOfKind, the_second_group_wears_other_clothes) {
  const auto colours = [&](std::uint8_t group) {
    std::multiset<float> parts;
    for (const MeshVertex& v : car_mesh(GetParam(), false, {group, false}).vertices) parts.insert(v.part);
    return parts;
  };
  EXPECT_NE(colours(0), colours(1));
}

}  // namespace train_mesh_test
}  // namespace coaster::sim
