// Marks, lines and targets on a dense screen: everything that view lists and picks has its size in points.
#include <gtest/gtest.h>

#include <set>

#include "base/tries.h"
#include "edit/session_fixture.h"
#include "sim/plan/element_plan.h"
#include "view/overlay.h"
#include "world/element_rows.h"
#include "world/laboratory_settings.h"
#include "world/panel_settings.h"

namespace coaster::view {
namespace density_test {

class Density : public test::SessionTest {
 protected:
  Density() : SessionTest(world::Document{}) {
    for (const char* line : {"element straight length 30", "element climb height 20 angle 30", "element loop height 14",
                             "element curve left radius 25 angle 90 bank 0", "append at 200 30 100"})
      good(line);
    session.settings.panels->workspace = world::Workspace::build;
    sim::reset(session.document, session.derived, session.motion);
  }

  // The same picture with `density` times as many pixels on each side.
  View view(float density) const {
    const Viewport port{57 * density, 31 * density, 640 * density, 480 * density};
    View view = orbit_view(frame_all({}, session.document, {57, 31, 640, 480}), port);
    view.density = density;
    return view;
  }
  Pick at(glm::vec2 point, float density) const {
    return pick(session.document, session.derived, session.motion, session.settings, view(density), density * point);
  }
};

// The picture with twice as many pixels is the same picture: where lines and marks are and how large does not change.
TEST_F(Density, twice_the_pixels_show_every_line_and_mark_twice_as_large) {
  for (std::size_t i = 0; i < std::size(world::kLayers); ++i)
    session.settings.lab->layers.set(static_cast<world::Layer>(i), true);
  const std::vector<sim::FrenetBreak> breaks{{sim::FrenetBreak::Kind::flip, entity("s3"), 0.4, 0.4, 2},
                                             {sim::FrenetBreak::Kind::undefined, entity("s1"), 0, 1, 0}};
  const std::vector<sim::Overload> spans{{0, {}, 1, 2, 20, 40, 5, 4, 1.5}};
  const std::vector<sim::Jolt> jolts{{}, {0, 0, 2, 2, 0, 10}};
  const std::vector<sim::Conflict> conflicts{{60, 80, 55, 65, 75, 85, 0.5, {60, 5, 1}, {61, 7, 2}}};
  const std::vector<sim::Fold> folds{{90, 95, 92, 0.7, {70, 6, 1}}};
  const sim::ElementPlan element = sim::plan_element(world::usual_element(world::ElementKind::helix), session.document);
  MarkedFindings findings{breaks, spans, jolts, conflicts, folds, {world::FailureKind::stall, {}, 33, 0}, &element, {}};
  for (const char* selected : {"q4", "q3", "k3", "s4"}) {
    session.settings.selected = entity(selected);
    const Pick hovered{PickKind::curve, session.document.track.segments[1], 0.3, {10, 5, 0}};
    const auto drawn = [&](float density) {
      return build_overlay(session.document, session.derived, session.settings, view(density), hovered, findings);
    };
    const Overlay ordinary = drawn(1), dense = drawn(2);
    ASSERT_EQ(ordinary.lines.size(), dense.lines.size()) << selected;
    ASSERT_EQ(ordinary.marks.size(), dense.marks.size()) << selected;
    ASSERT_GT(ordinary.lines.size(), 500u);
    ASSERT_GT(ordinary.marks.size(), 30u);
    for (std::size_t i = 0; i < dense.lines.size(); ++i) {
      const Line &one = ordinary.lines[i], &two = dense.lines[i];
      ASSERT_LT(glm::distance(one.from, two.from) + glm::distance(one.to, two.to), 1e-3f) << selected << " " << i;
      ASSERT_FLOAT_EQ(two.width_px, 2 * one.width_px) << selected << " " << i;
    }
    for (std::size_t i = 0; i < dense.marks.size(); ++i) {
      const Mark &one = ordinary.marks[i], &two = dense.marks[i];
      ASSERT_LT(glm::distance(one.position, two.position), 1e-3f) << selected << " " << i;
      ASSERT_FLOAT_EQ(two.radius_px, 2 * one.radius_px) << selected << " " << i;
    }
  }
}

TEST_F(Density, the_mouse_reaches_as_many_points_far) {
  good("add_cart @s2 at 0.5");
  sim::reset(session.document, session.derived, session.motion);
  std::set<PickKind> found;
  for (const char* selected : {"q4", "q3", "k3", "s4"}) {
    session.settings.selected = entity(selected);
    for (float y = 32.3f; y < 510; y += test::kSanitized ? 10 : 5)
      for (float x = 58.3f; x < 696; x += 5) {
        const Pick ordinary = at({x, y}, 1);
        found.insert(ordinary.kind);
        ASSERT_EQ(at({x, y}, 2), ordinary) << selected << " " << x << " " << y;
        if (ordinary.kind != PickKind::curve) continue;
        // Where track crosses track in the picture a fraction of a point decides which of them is meant.
        for (float off = 1.25f; off < 5; off += 1.25f)
          ASSERT_EQ(at({x + off, y}, 2), at({x + off, y}, 1)) << selected << " " << x + off << " " << y;
      }
  }
  for (const PickKind kind : {PickKind::none, PickKind::knot, PickKind::handle_in, PickKind::spin, PickKind::section,
                              PickKind::turn, PickKind::cart, PickKind::curve, PickKind::axis_y, PickKind::plane_z})
    EXPECT_TRUE(found.contains(kind)) << static_cast<int>(kind);
}

}  // namespace density_test
}  // namespace coaster::view
