// The ring that sets the spin of a knot.
#include "view/gizmo.h"

#include <cmath>

#include <gtest/gtest.h>

#include "world/aid_settings.h"
#include "world/sample_documents.h"
#include "world/topology.h"

namespace coaster::view {
namespace spin_ring_test {

struct Scene {
  world::Document document = test::sample_document();
  world::Settings settings;
  world::Entity knot;
  Scene() {
    knot = document.track.knots[1];
    settings.selected = knot;
  }
  View view() const {
    return orbit_view({world::knot(document, knot).position, 37, 12, 40}, Viewport{100, 20, 900, 600});
  }
};

TEST(spin_ring, the_ray_through_the_handle_gives_the_spin_back) {
  for (const double degrees : {-30.0, -11.0, 0.0, 0.5, 7.0, 35.0}) {
    Scene scene;
    scene.document.entities.get<world::Knot>(scene.knot).spin = static_cast<float>(degrees * M_PI / 180);
    const auto ring = spin_ring_of(scene.document, scene.settings, scene.view());
    ASSERT_TRUE(ring);
    const auto pixel = project(scene.view(), glm::vec3(ring->handle()));
    ASSERT_TRUE(pixel);
    const auto spin = spin_under(*ring, ray_through(scene.view(), {pixel->x, pixel->y}));
    ASSERT_TRUE(spin);
    EXPECT_NEAR(*spin * 180 / M_PI, degrees, 0.02);
  }
}

TEST(spin_ring, the_handle_stands_where_the_track_s_up_is_five_metres_on) {
  Scene scene;
  scene.document.entities.get<world::Knot>(scene.knot).spin = 0.2f;  // 1 rad over 5 m
  const auto ring = spin_ring_of(scene.document, scene.settings, scene.view());
  ASSERT_TRUE(ring);
  const glm::dvec3 way = glm::normalize(ring->handle() - ring->centre);
  EXPECT_NEAR(glm::dot(way, ring->up), std::cos(1.0), 1e-6);
  EXPECT_NEAR(glm::dot(way, glm::cross(ring->tangent, ring->up)), std::sin(1.0), 1e-6);  // to the rider's right
}

TEST(spin_ring, it_shows_for_one_knot_alone_and_not_without_the_gizmo) {
  Scene scene;
  scene.settings.also = {scene.document.track.knots[2]};
  EXPECT_FALSE(spin_ring_of(scene.document, scene.settings, scene.view()));
  scene.settings.also.clear();
  scene.settings.aids->show_gizmo = false;
  EXPECT_FALSE(spin_ring_of(scene.document, scene.settings, scene.view()));
  scene.settings.aids->show_gizmo = true;
  scene.settings.selected = scene.document.track.segments[0];
  EXPECT_FALSE(spin_ring_of(scene.document, scene.settings, scene.view()));
}

TEST(spin_ring, edge_on_it_turns_nothing) {
  Scene scene;
  const auto ring = spin_ring_of(scene.document, scene.settings, scene.view());
  ASSERT_TRUE(ring);
  const Ray across{glm::vec3(ring->centre) - 10.0f * glm::vec3(ring->up), glm::vec3(ring->up)};
  EXPECT_FALSE(spin_under(*ring, across));
}

}  // namespace spin_ring_test
}  // namespace coaster::view
