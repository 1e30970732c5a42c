// The land beyond the square, as one mesh around it.
#include "gfx/land_cache.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "sim/solids/coaster_form.h"
#include "sim/tracks.h"

namespace coaster::gfx {
namespace far_land_test {

TEST(FarLand, continues_the_border_out_to_the_horizon) {
  world::Document document = test::ring_document(12, 95, 9);
  document.park = world::usual_park(world::Land::hills, 7);
  sim::DerivedTrack derived;
  sim::derive(document, {}, {}, derived);
  sim::Ground ground;
  ground.update(document, derived, sim::track_room(sim::form_of(document.kind)));
  sim::LandMesh mesh;
  mesh.update(ground, nullptr, {0, 1, 0}, false, {});
  const FarLand far = far_land(ground, mesh.field());
  // All that lies at the square's edge is a vertex of a patch.
  const float half = 384;
  std::set<std::array<float, 3>> border;
  for (std::size_t patch = 0; patch < mesh.patches().size(); ++patch)
    for (const sim::LandVertex& vertex : mesh.vertices(patch))
      if (std::max(std::abs(vertex.position.x), std::abs(vertex.position.z)) == half)
        border.insert({vertex.position.x, vertex.position.y, vertex.position.z});
  std::size_t shared = 0;
  double area = 0;
  for (const sim::LandVertex& vertex : far.vertices)
    shared += border.contains({vertex.position.x, vertex.position.y, vertex.position.z});
  EXPECT_EQ(shared, std::size_t{4} * 96);
  for (std::size_t i = 0; i < far.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) { return glm::dvec3(far.vertices[far.indices[i + k]].position); };
    const double twice = glm::cross(at(1) - at(0), at(2) - at(0)).y;
    EXPECT_GT(twice, 0);
    area += 0.5 * twice;
  }
  const double side = 2.0 * half;
  EXPECT_NEAR(area, side * side * (kFarthestLand * kFarthestLand - 1.0), side);
}

}  // namespace far_land_test
}  // namespace coaster::gfx
