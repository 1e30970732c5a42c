#include "sim/plan/element_plan.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/tries.h"
#include "sim/plan/element_plan_cache.h"
#include "sim/random_elements.h"
#include "world/element_rows.h"
#include "world/topology.h"

namespace coaster::sim {
namespace element_plan_test {

using world::ElementKind;

TEST(elements, values_beyond_the_limits_are_cut_with_a_line_that_says_limit) {
  for (std::size_t kind = 0; kind < world::elements().size(); ++kind) {
    const world::Element usual = world::usual_element(static_cast<ElementKind>(kind));
    const auto& parameters = base::row_of(usual.kind).parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i)
      for (const double far : {-1e9, 1e9}) {
        world::Element element = usual;
        element.values[i] = far;
        const ElementPlan plan = plan_element(element, TrackEnd{});
        ASSERT_FALSE(plan.lines.empty()) << parameters[i].name;
        EXPECT_NE(plan.lines[0].find("limit"), std::string::npos) << plan.lines[0];
        EXPECT_NE(plan.lines[0].find(parameters[i].name), std::string::npos) << plan.lines[0];
        EXPECT_TRUE(plan.refusal.empty()) << plan.refusal;
      }
  }
}

TEST(elements, what_is_no_number_becomes_the_usual_one_and_nothing_is_ever_nan) {
  for (std::size_t kind = 0; kind < world::elements().size(); ++kind) {
    const world::Element usual = world::usual_element(static_cast<ElementKind>(kind));
    world::Element broken = usual;
    for (double& value : broken.values) value = std::numeric_limits<double>::quiet_NaN();
    broken.right = !base::row_of(usual.kind).sided;
    EXPECT_EQ(plan_element(broken, TrackEnd{}).element, usual) << world::elements()[kind].name;
  }
  test::RandomElements random(31);
  for (int i = 0; i < test::tries(80); ++i) {
    const ElementPlan plan = plan_element(random.any(), random.end());
    for (const ElementPoint& p : plan.ideal.points)
      ASSERT_TRUE(std::isfinite(glm::dot(p.position, p.tangent) + glm::dot(p.curvature, p.up)));
    for (const world::Knot& k : plan.fit.knots)
      ASSERT_TRUE(std::isfinite(glm::dot(k.position, k.tangent) + glm::dot(k.up, k.up) + k.in_length + k.out_length));
  }
}

TEST(elements, what_cannot_be_has_to_give_way) {
  const auto line = [](const world::Element& element) {
    const ElementPlan plan = plan_element(element, TrackEnd{{0, 100, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}});
    EXPECT_TRUE(plan.refusal.empty()) << plan.refusal;
    return plan.lines.empty() ? "" : plan.lines[0];
  };
  world::Element hill = world::usual_element(ElementKind::camelback);
  hill.values = {50, 20};
  hill.values[2] = 20;
  EXPECT_NE(
      line(hill).find("Raised speed from 20 m/s to the limit of 33.588 m/s: a slower train cannot pass the crest."),
      std::string::npos)
      << line(hill);
  world::Element helix = world::usual_element(ElementKind::helix);
  helix.values = {5, 1, -100, 0, 0};
  EXPECT_NE(line(helix).find("Raised height from -100 m to the limit"), std::string::npos) << line(helix);
  world::Element loop = world::usual_element(ElementKind::loop);
  loop.values = {3, 0, 30};
  EXPECT_NE(line(loop).find("Reduced shift from 30 m to the limit"), std::string::npos) << line(loop);
  world::Element curve = world::usual_element(ElementKind::curve);
  curve.values = {3, 1};
  EXPECT_NE(line(curve).find("Raised radius from 3 m to the limit"), std::string::npos) << line(curve);
}

TEST(elements, the_open_end_is_the_last_knot_with_the_curvature_that_leads_there) {
  world::Document document;
  EXPECT_EQ(open_end(document), TrackEnd{});
  // A quarter of a circle of radius 10, in the usual approximation: its curvature at the end is (2/3) (10 - h) / h^2.
  const float handle = 5.5228475f;
  world::append_knot(document, {{10, 3, 0}, {0, 0, 1}, {0, 1, 0}, handle, handle});
  world::append_knot(document, {{0, 3, 10}, {-1, 0, 0}, {0, 1, 0}, handle, handle});
  const std::optional<TrackEnd> end = open_end(document);
  ASSERT_TRUE(end);
  EXPECT_EQ(end->position, glm::dvec3(0, 3, 10));
  EXPECT_EQ(end->forward, glm::dvec3(-1, 0, 0));
  EXPECT_NEAR(end->curvature.z, -2.0 / 3 * (10 - 5.5228475) / (5.5228475 * 5.5228475), 1e-6);
  EXPECT_NEAR(end->curvature.x, 0, 1e-12);
  world::set_closed(document, true);
  EXPECT_FALSE(open_end(document));
  EXPECT_NE(plan_element(world::usual_element(ElementKind::loop), document).refusal.find("closed"), std::string::npos);
}

TEST(elements, the_memo_plans_anew_when_the_element_or_the_end_changes) {
  ElementCache cache;
  world::Document document;
  const world::Element loop = world::usual_element(ElementKind::loop), curve = world::usual_element(ElementKind::curve);
  const ElementPlan* const first = &cache.plan(loop, document);
  EXPECT_EQ(first->element, loop);
  const void* const points = first->ideal.points.data();
  EXPECT_EQ(cache.plan(loop, document).ideal.points.data(), points) << "kept";
  EXPECT_EQ(cache.plan(curve, document).element, curve);
  EXPECT_NEAR(cache.plan(loop, document).lowest, 2, 1e-9);
  world::append_knot(document, {{0, 30, 0}, {0, 0, 1}, {0, 1, 0}, 5, 5});
  EXPECT_NEAR(cache.plan(loop, document).lowest, 30, 1e-9);
}

TEST(elements, far_from_the_origin_rounding_to_float_is_allowed_for) {
  TrackEnd far;
  far.position = {99'000, 5, -99'000};
  const ElementPlan near_limit = plan_element(world::usual_element(ElementKind::loop), far);
  EXPECT_TRUE(near_limit.refusal.empty()) << near_limit.refusal;
  EXPECT_LT(near_limit.fit.error, 0.05);
  EXPECT_LT(near_limit.spans(), 100u);
  far.position = {99'990, 5, 0};
  EXPECT_NE(plan_element(world::usual_element(ElementKind::straight), far).refusal.find("limit"), std::string::npos);
}

}  // namespace element_plan_test
}  // namespace coaster::sim
