// Invariants: src/world/document.
#include <limits>

#include <gtest/gtest.h>

#include "world/element_rows.h"
#include "world/sample_documents.h"

namespace coaster::world {
namespace invariants_test {

TEST(invariants, good_documents_break_none) {
  EXPECT_EQ(broken_invariant(Document{}), std::nullopt);
  for (std::uint32_t seed = 0; seed < 200; ++seed)
    EXPECT_EQ(broken_invariant(test::random_document(seed)), std::nullopt) << seed;
}

// `spoil` breaks one promise: that must be noticed.
template <class Spoil>
void expect_broken(Spoil spoil, const char* part) {
  Document d = test::sample_document();
  spoil(d);
  const auto broken = broken_invariant(d);
  ASSERT_TRUE(broken) << part;
  EXPECT_NE(broken->find(part), std::string::npos) << *broken;
}

TEST(invariants, every_broken_promise_is_noticed) {
  const auto knot_of = [](Document& d) -> Knot& { return d.entities.get<Knot>(d.track.knots[1]); };
  expect_broken([&](Document& d) { knot_of(d).position.y = 100'001.0f; }, "k2: position");
  expect_broken([&](Document& d) { knot_of(d).position.x = std::numeric_limits<float>::quiet_NaN(); }, "k2: position");
  expect_broken([&](Document& d) { knot_of(d).tangent *= 1.01f; }, "k2: tangent");
  expect_broken([&](Document& d) { knot_of(d).up *= 0.99f; }, "k2: up is not unit");
  expect_broken([&](Document& d) { knot_of(d).up = knot_of(d).tangent; }, "perpendicular");
  expect_broken([&](Document& d) { knot_of(d).in_length = 0.001f; }, "length");
  expect_broken([&](Document& d) { knot_of(d).joint = JointKind::smooth; }, "smooth");
  expect_broken([](Document& d) { d.start_speed = 151; }, "start speed");
  expect_broken([](Document& d) { d.datum = std::numeric_limits<double>::infinity(); }, "datum");
  expect_broken([](Document& d) { d.last_number[0] = 4; }, "k5: number");
  expect_broken([](Document& d) { d.entities.put(d.track.knots[0], EntityName{EntityKind::knot, 2}); }, "twice");
  expect_broken([](Document& d) { d.entities.put(d.track.knots[0], EntityName{EntityKind::cart, 1}); }, "");
  expect_broken([](Document& d) { d.entities.create(); }, "without a name");
  expect_broken([](Document& d) { d.track.closed = true; }, "number of segments");
  expect_broken([](Document& d) { d.track.segments.pop_back(); }, "number of segments");
  expect_broken([](Document& d) { std::swap(d.track.segments[0], d.track.segments[1]); }, "lead");
  expect_broken([](Document& d) { std::swap(d.track.knots[0], d.track.knots[1]); }, "lead");
  expect_broken([](Document& d) { d.entities.get<Segment>(d.track.segments[0]).turns = 17; }, "turns");
  expect_broken(
      [](Document& d) {
        d.entities.get<Train>(find(d, {EntityKind::cart, 1})).fraction = 1;
      },
      "c1: fraction");
  const auto section_of = [](Document& d) -> Section& { return d.entities.pool<Section>().items().front(); };
  expect_broken([](Document& d) { d.entities.get<Segment>(d.track.segments[1]).section = kNone; }, "s2: in no section");
  expect_broken(
      [](Document& d) {
        make_section(d, 1, 1, {}),
            d.entities.get<Segment>(d.track.segments[1]).section = segment(d, d.track.segments[0]).section;
      },
      "a section without segments");
  expect_broken(
      [](Document& d) {
        make_section(d, 1, 1, {});
        d.entities.get<Segment>(d.track.segments[3]).section = segment(d, d.track.segments[0]).section;
      },
      "q1: its segments are not neighbours");
  expect_broken([&](Document& d) { section_of(d).title.assign(kMaxNameBytes + 1, 'x'); }, "q1: title");
  expect_broken([&](Document& d) { section_of(d).title = "a\n"; }, "q1: title");
  expect_broken([&](Document& d) { section_of(d).element = usual_element(ElementKind::loop); }, "q1: title or param");
  expect_broken([&](Document& d) { section_of(d).kind = SectionKind::element; }, "q1: title or parameters");
  expect_broken([&](Document& d) { section_of(d).closing.radius = 2; }, "q1: title or parameters");
  for (double ClosingPlan::*const number :
       {&ClosingPlan::second, &ClosingPlan::radius, &ClosingPlan::height, &ClosingPlan::speed})
    for (const double value : {1e9, std::nan("")})
      expect_broken(
          [&](Document& d) {
            section_of(d).kind = SectionKind::complete;
            section_of(d).closing.*number = value;
          },
          "q1: title or parameters");
  expect_broken(
      [](Document& d) {
        d.entities.put(segment(d, d.track.segments[0]).section, EntityName{EntityKind::cart, 2});
      },
      "");
  expect_broken(
      [](Document& d) {
        d.entities.get<Train>(find(d, {EntityKind::cart, 1})).segment = kNone;
      },
      "c1: on no segment");
}

}  // namespace invariants_test
}  // namespace coaster::world
