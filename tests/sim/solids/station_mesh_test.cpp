#include "sim/solids/station_mesh.h"

#include <algorithm>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "sim/kinds.h"
#include "sim/solids/coaster_form.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace station_mesh_test {

// A level straight of 60 m, 3 m above the ground, along a skew direction, whose middle third is a station.
world::Document station_document(world::CoasterKind kind, int stations = 2) {
  world::Document document = test::straight_document({-24, 3, 18}, {24, 3, -18}, 6);
  document.kind = kind;
  for (int i = 0; i < stations; ++i)
    document.entities.put(document.track.segments[static_cast<std::size_t>(2 + i)],
                          world::Equipment{.kind = world::EquipmentKind::station});
  return document;
}

Mesh mesh_of(const world::Document& document, std::string_view name) {
  const DerivedTrack derived = test::derived_of(document);
  Ground ground;
  ground.update(document, derived, track_room(form_of(document.kind)));
  return station_mesh(derived, ground, name);
}

class Stations : public testing::TestWithParam<world::CoasterKind> {};
INSTANTIATE_TEST_SUITE_P(all, Stations, testing::ValuesIn(test::kinds()), test::kind_name);

TEST_P(Stations, leave_trains_their_room) {
  const world::Document document = station_document(GetParam());
  const DerivedTrack derived = test::derived_of(document);
  const CoasterForm& form = form_of(GetParam());
  const Mesh mesh = mesh_of(document, "Old Oak");
  ASSERT_GT(mesh.vertices.size(), 500u);
  const glm::dvec3 forward = glm::normalize(glm::dvec3(4, 0, -3)), up(0, 1, 0), left = glm::cross(up, forward);
  for (const MeshVertex& vertex : mesh.vertices) {
    const glm::dvec3 from = glm::dvec3(vertex.position) - glm::dvec3(0, 3, 0);
    const double aside = glm::dot(from, left), above = from.y;
    EXPECT_GT(std::hypot(aside, above - form.riders.lift), form.riders.radius - 0.02) << aside << ' ' << above;
    EXPECT_GT(std::hypot(aside, above - form.envelope.lift), std::min(form.envelope.radius, 1.35)) << aside;
    EXPECT_LT(std::abs(glm::dot(from, forward)), 14) << "beside the station, which is 20 m long";
    EXPECT_GT(vertex.position.y, -0.01) << "not under the ground";
    EXPECT_NEAR(glm::length(vertex.normal), 1, 1e-4);
  }
}

// The dots of a letter face away from the track on both boards.
TEST(StationMesh, writes_the_name_on_both_sides) {
  const world::Document document = station_document(world::CoasterKind::steel);
  const auto dots = [&](std::string_view name) {
    const Mesh mesh = mesh_of(document, name), blank = mesh_of(document, " ");
    return (mesh.indices.size() - blank.indices.size()) / 6;
  };
  EXPECT_EQ(dots("I"), 2u * 11);  // 3 + 5 + 3
  EXPECT_EQ(dots("i"), dots("I"));
  EXPECT_EQ(dots("\xc3\xa4"), 0u);  // no glyph
  EXPECT_EQ(dots("LL"), 2u * 2 * 11);
  EXPECT_EQ(mesh_of(document, std::string(200, 'A')).indices.size(),
            mesh_of(document, std::string(kMostLetters, 'A')).indices.size());
}

TEST(StationMesh, stands_only_where_people_can_walk) {
  EXPECT_TRUE(mesh_of(station_document(world::CoasterKind::steel, 0), "A").vertices.empty());
  world::Document steep = test::straight_document({0, 3, 0}, {30, 33, 0}, 2);
  steep.entities.put(steep.track.segments[0], world::Equipment{.kind = world::EquipmentKind::station});
  EXPECT_TRUE(mesh_of(steep, "A").vertices.empty());
  world::Document tiny = test::straight_document({0, 3, 0}, {9, 3, 0}, 3);
  tiny.entities.put(tiny.track.segments[1], world::Equipment{.kind = world::EquipmentKind::station});
  EXPECT_TRUE(mesh_of(tiny, "A").vertices.empty());
}

// Steps lead from the plaza up to the platform, none of them higher than a foot lifts.
TEST(StationMesh, is_reached_by_steps) {
  const Mesh mesh = mesh_of(station_document(world::CoasterKind::steel), "A");
  const glm::dvec3 right = glm::cross(glm::normalize(glm::dvec3(4, 0, -3)), glm::dvec3(0, 1, 0));
  std::set<long> treads;  // heights in mm, of what is level beside the platform
  for (const MeshVertex& vertex : mesh.vertices)
    if (vertex.normal.y > 0.99f && vertex.part == static_cast<float>(Material::concrete) && vertex.position.y > 0.01f &&
        std::abs(glm::dot(glm::dvec3(vertex.position), right)) > 2)
      treads.insert(std::lround(1000 * double{vertex.position.y}));
  ASSERT_GE(treads.size(), 8u);
  long below = 0;
  for (const long tread : treads) EXPECT_LT(tread - std::exchange(below, tread), 220);
  EXPECT_GT(below, 1500);
}

// A station over the start of a closed track is one building, as it is when the track starts elsewhere.
TEST(StationMesh, is_one_building_across_the_start_of_a_circuit) {
  world::Document document = test::ring_document(24, 80, 0);
  document.entities.put(document.track.segments[0], world::Equipment{.kind = world::EquipmentKind::station});
  const std::size_t one = mesh_of(document, "A").indices.size();
  document.entities.put(document.track.segments[23], world::Equipment{.kind = world::EquipmentKind::station});
  const std::size_t both = mesh_of(document, "A").indices.size();
  EXPECT_GT(both, one);
  EXPECT_LT(both, 2 * one - 100) << "one board and one queue";
}

}  // namespace station_mesh_test
}  // namespace coaster::sim
