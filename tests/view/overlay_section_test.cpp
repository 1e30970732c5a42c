// The marks of selected sections.
#include "view/overlay.h"

#include <gtest/gtest.h>

#include <map>

#include "sim/tracks.h"
#include "world/element_rows.h"
#include "world/panel_settings.h"
#include "world/sections.h"
#include "world/topology.h"

namespace coaster::view {
namespace overlay_section_test {

const Viewport kViewport{57, 31, 640, 480};

TEST(overlay_section, selected_sections_and_the_one_under_the_mouse_of_build_have_wide_lines) {
  world::Document d = test::ring_document(12, 30);
  world::make_section(d, 0, 3, {});
  const world::Entity first = world::segment(d, d.track.segments[0]).section;
  const world::Entity planned =
      world::make_section(d, 3, 4, {{}, world::SectionKind::element, world::usual_element(world::ElementKind::curve)});
  const sim::DerivedTrack derived = test::derived_of(d);
  world::Settings settings;
  const View view = orbit_view(settings.camera, kViewport);
  const auto widths = [&](const Pick& hovered) {
    std::map<float, std::vector<Line>> by_width;
    for (const Line& line : build_overlay(d, derived, settings, view, hovered).lines)
      by_width[line.width_px].push_back(line);
    return by_width;
  };
  constexpr float kSelected = 5, kHovered = 2;
  EXPECT_FALSE(widths({}).contains(kSelected));
  settings.selected = first;
  std::vector<Line> lines = widths({})[kSelected];
  ASSERT_EQ(lines.size(), 3u * 16u);
  EXPECT_LT(glm::distance(lines.front().from, world::knot(d, d.track.knots[0]).position), 1e-4f);
  EXPECT_LT(glm::distance(lines.back().to, world::knot(d, d.track.knots[3]).position), 1e-4f);
  settings.also = {planned};
  EXPECT_EQ(widths({})[kSelected].size(), 7u * 16u);
  settings.also.clear();
  const Pick over{PickKind::curve, d.track.segments[4], 0.5, {}};
  EXPECT_FALSE(widths(over).contains(kHovered)) << "in Build alone";
  settings.panels->workspace = world::Workspace::build;
  EXPECT_EQ(widths(over)[kHovered].size(), 4u * 16u);
  EXPECT_FALSE(widths({PickKind::curve, d.track.segments[9], 0.5, {}}).contains(kHovered)) << "a hand-shaped one";
}

}  // namespace overlay_section_test
}  // namespace coaster::view
