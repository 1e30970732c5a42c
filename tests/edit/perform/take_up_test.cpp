// Circuits that stay closed while their sections change. Joints are checked on the finished document by other means
// than the planner's.
#include "edit/perform/replan.h"

#include <cstdio>
#include <map>

#include <gtest/gtest.h>

#include "base/tries.h"
#include "curve/continuity.h"
#include "edit/random_tracks.h"
#include "sim/shape/rails.h"
#include "world/element_rows.h"
#include "world/sections.h"

namespace coaster::edit {
namespace take_up_test {

using glm::dvec3;

// The rate of the frame's roll, by differences of frames carried by the least rotation.
double roll_rate(const sim::SegmentShape& shape, double s) {
  constexpr double kStep = 1e-3;
  const curve::Frame a = sim::frame_at(shape, s), b = sim::frame_at(shape, s + kStep);
  const dvec3 carried = curve::least_rotation(a.forward, b.forward, a.up, a.up);
  return curve::signed_angle(carried, b.up, b.forward) / kStep;
}

class TakeUp : public test::RandomTracks {
 protected:
  world::SectionRun completing() const { return *world::completing(session.document, 0); }
  const world::Section& value() const { return world::section(session.document, completing().section); }
  const world::Knot& knot_at(std::size_t i) const {
    const auto& knots = session.document.track.knots;
    return world::knot(session.document, knots[i % knots.size()]);
  }
  dvec3 at(double share) const {
    const world::SectionRun run = completing();
    const sim::DerivedTrack& d = session.derived;
    const double from = d.starts[run.first], to = d.starts[run.end()];
    const sim::TrackPlace place = sim::place_at(d, from + share * (to - from));
    return sim::rails_at(d.shape_at(place.index), place.s);
  }
  using Names = std::map<world::Entity, std::vector<std::string>>;
  // By section: the names of its knots, but the last.
  Names names() const {
    Names all;
    for (const world::SectionRun& run : world::sections_of(session.document))
      for (std::size_t i = run.first; i < run.end(); ++i)
        all[run.section].push_back(world::label_of(session.document, session.document.track.knots[i]));
    return all;
  }
  std::string random_change();
  void expect_closed_smoothly() const;
  void expect_same_names(const Names& before, const std::string& line) const;
};

// Changes parameters a little or much, or the order, of the sections before the one that completes the circuit.
std::string TakeUp::random_change() {
  const std::vector<world::SectionRun> runs = world::sections_of(session.document);
  const world::SectionRun& run = runs[below(static_cast<std::uint32_t>(runs.size()) - 1)];
  const std::string name = "@" + world::label_of(session.document, run.section);
  const world::Section& section = world::section(session.document, run.section);
  const std::uint32_t choice = below(10);
  if (choice == 0) return "section.mirror " + name;
  if (choice == 1) return "section.delete " + name;
  if (choice == 2) return "section.move " + name + (below(2) ? " before" : " after");
  if (section.kind != world::SectionKind::element)
    return fmt::format("section.change {} to straight length {:.1f}", name, uniform(5, 60));
  const world::ElementRow& row = base::row_of(section.element.kind);
  std::string line = fmt::format("section.change {} to {}", name, row.name);
  if (row.sided) line += section.element.right ? " right" : " left";
  const double much = below(3) == 0 ? 0.4 : 0.05;
  for (std::size_t i = 0; i < row.parameters.size(); ++i) {
    if (!row.parameters[i].names.empty()) continue;
    const double was = section.element.values[i];
    const double now = std::clamp(was * uniform(1 - much, 1 + much), row.parameters[i].low, row.parameters[i].high);
    if (now != 0) line += fmt::format(" {} {:.3f}", row.parameters[i].name, now);
  }
  return line;
}

void TakeUp::expect_closed_smoothly() const {
  ASSERT_TRUE(session.document.track.closed);
  const sim::DerivedTrack& d = session.derived;
  const std::size_t all = d.order.size();
  for (std::size_t i = 0; i < all; ++i) {
    const sim::SegmentShape &in = d.shape_at((i + all - 1) % all), &out = d.shape_at(i);
    const curve::JointContinuity joint = curve::joint(in.key.cubic, out.key.cubic);
    EXPECT_EQ(joint.geometric, curve::GeometricContinuity::g2)
        << "segment " << i << " jumps by " << joint.curvature_jump;
    EXPECT_NEAR(roll_rate(in, in.arc.length() - 1.5e-3), roll_rate(out, 5e-4), 2e-3) << "segment " << i;
  }
}

void TakeUp::expect_same_names(const Names& before, const std::string& line) const {
  for (const auto& [section, now] : names()) {
    const auto was = before.find(section);
    // The first knot of a section that was put elsewhere belongs to its new place.
    if (was == before.end() || was->second.size() != now.size() || line.starts_with("section.move")) continue;
    if (line.starts_with("section.delete")) continue;
    EXPECT_EQ(was->second, now) << line;
  }
}

TEST_F(TakeUp, random_changes_are_refused_or_keep_random_circuits_closed) {
  int changes = 0, taken = 0, circuits = 0;
  std::map<std::string, int> reasons;
  for (std::uint32_t seed = 101; changes < test::tries(200); ++seed) {
    random_track(seed);
    if (!apply("complete 1")) continue;
    ++circuits;
    for (int i = 0; i < 20 && changes < test::tries(200); ++i) {
      const std::string line = random_change();
      SCOPED_TRACE(fmt::format("track {}, {}", seed, line));
      const std::uint64_t before = hash();
      const Names were = names();
      const base::Status status = apply(line);
      ++changes;
      if (!status) {
        ++reasons[status.message.substr(0, 60)];
        ASSERT_EQ(hash(), before);
        continue;
      }
      ++taken;
      ASSERT_EQ(world::broken_invariant(session.document), std::nullopt);
      ASSERT_TRUE(world::completing(session.document, 0)) << session.notices.list.back().text;
      expect_closed_smoothly();
      expect_same_names(were, line);
      const std::uint64_t after = hash();
      if (after == before) continue;
      good("undo");
      ASSERT_EQ(hash(), before);
      good("redo");
      ASSERT_EQ(hash(), after);
    }
  }
  for (const auto& [reason, count] : reasons) std::printf("%3d: %s\n", count, reason.c_str());
  std::printf("%d of %d changes taken up, on %d circuits\n", taken, changes, circuits);
  EXPECT_GE(taken * 2, changes);
}

TEST_F(TakeUp, a_higher_lift_moves_what_follows_and_keeps_the_first_knot) {
  circuit();
  const world::SectionRun before = completing();
  const world::ClosingPlan was_closing = value().closing;
  const world::Knot start = knot_at(before.first), home = knot_at(before.end());
  good("section.change @q2 to climb height 30 equipment lift");
  const world::SectionRun now = completing();
  EXPECT_EQ(now.section, before.section);
  EXPECT_NEAR(knot_at(now.first).position.y, start.position.y + 5, 1e-3);
  EXPECT_EQ(knot_at(now.first).up, start.up);
  world::Knot kept = knot_at(now.end());
  kept.in_length = home.in_length;
  EXPECT_EQ(kept, home) << "to the bit";
  EXPECT_EQ(value().closing.speed, was_closing.speed) << "the brakes give it";
  EXPECT_NEAR(value().closing.first, was_closing.first, 15);
  expect_closed_smoothly();
  const auto again = exchange::parse_track(exchange::print_track(session.document), "t");
  ASSERT_TRUE(again) << again.status().message;
  EXPECT_EQ(world::hash(again->document), hash());
}

TEST_F(TakeUp, where_it_coasts_it_is_planned_for_the_speed_that_the_height_gives) {
  circuit();
  good("section.delete @q7");
  const double was = value().closing.speed;
  good("section.change @q3 to dive height 20");
  const double now = value().closing.speed;
  EXPECT_NEAR(was * was - now * now, 2 * 9.81 * 2, 0.01);
}

TEST_F(TakeUp, a_small_change_is_a_small_change) {
  circuit();
  const world::Document before = session.document;
  good("gesture.begin");
  std::vector<dvec3> last;
  for (int i = 0; i <= 40; ++i) {
    good(fmt::format("section.change @q2 from_start on to climb height {} equipment lift", 25 + 0.1 * i));
    std::vector<dvec3> now;
    for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9}) now.push_back(at(share));
    for (std::size_t k = 0; k < last.size(); ++k) EXPECT_LT(glm::distance(now[k], last[k]), 1.0) << i;
    last = now;
  }
  good("gesture.end");
  const std::uint64_t dragged = hash();
  good("undo");
  EXPECT_TRUE(session.document == before);
  good("section.change @q2 to climb height 29 equipment lift");
  EXPECT_EQ(hash(), dragged) << "as if it had been set at once";
}

TEST_F(TakeUp, knots_moved_by_hand_free_it) {
  circuit();
  const world::SectionRun run = completing();
  ASSERT_GT(run.count, 2u);
  const std::string inside = world::label_of(session.document, session.document.track.knots[run.first + 1]);
  good("move @" + inside + " to 0 30 0");
  EXPECT_TRUE(world::is_free(session.document, run.section));
  EXPECT_EQ(world::section(session.document, run.section).closing, world::ClosingPlan{});
  EXPECT_NE(session.notices.list.back().text.find("The closing section is now hand-shaped."), std::string::npos);
  refused("section.change @q2 to climb height 30", "no closing section follows");
}

TEST_F(TakeUp, what_no_closing_section_can_take_up_is_refused) {
  circuit();
  good("section.change @q1 to straight length 2000 equipment station");
  refused("section.change @q5 to straight length 2000",
          "the closing section cannot take up the change: the first knot is too far away");
  refused("section.delete @q8", "no closing section follows");
  refused("section.mirror @q8", "no closing section follows");
  refused("section.move @q7 after", "no closing section follows");
  refused("section.move @q8 before", "no closing section follows");
  refused("section.change @q8 to loop", "no closing section follows");
  good("closed off");
  EXPECT_TRUE(world::is_free(session.document, entity("q8")));
}

TEST_F(TakeUp, what_is_pasted_comes_before_it) {
  circuit();
  const world::SectionRun before = completing();
  const Names were = names();
  const world::Knot home = knot_at(before.end());
  good("section.copy @q6"), good("section.change @q6 to straight length 10"), good("section.paste");
  EXPECT_EQ(completing().section, before.section);
  EXPECT_EQ(knot_at(completing().end()).position, home.position);
  const std::vector<world::SectionRun> runs = world::sections_of(session.document);
  ASSERT_EQ(runs.size(), 9u);
  EXPECT_EQ(world::kind_name(world::section(session.document, runs[7].section)), "curve");
  EXPECT_EQ(session.settings.selected, runs[7].section);
  EXPECT_FALSE(session.document.entities.find<world::Equipment>(session.document.track.segments[runs[7].first]));
  EXPECT_EQ(names()[entity("q7")], were.at(entity("q7"))) << "the brakes";
  expect_closed_smoothly();
  good("undo"), good("undo");
  EXPECT_EQ(names(), were);
  good("closed off"), good("closed on");
  refused("section.paste", "no closing section follows");
}

TEST_F(TakeUp, its_copy_is_hand_shaped) {
  circuit();
  good("section.copy @q8"), good("new"), good("section.paste");
  EXPECT_EQ(world::kind_name(world::section(session.document, entity("q1"))), "free");
  EXPECT_EQ(world::title_of(world::section(session.document, entity("q1"))), "Closing section");
}

// The circuit begins with the lift: its former start is after the section that completes it.
TEST_F(TakeUp, sections_behind_it_stay) {
  circuit();
  world::Document turned = session.document;
  const std::size_t station = world::run_of(turned, entity("q1")).count;
  for (std::vector<world::Entity>* const order : {&turned.track.knots, &turned.track.segments})
    std::rotate(order->begin(), order->begin() + static_cast<std::ptrdiff_t>(station), order->end());
  ASSERT_EQ(world::broken_invariant(turned), std::nullopt);
  start_on(turned);
  const world::SectionRun before = completing();
  const world::Knot start = knot_at(before.end() + 1), home = knot_at(before.end());
  refused("section.change @q1 to straight length 35", "no closing section follows");
  good("section.change @q3 to dive height 20");
  const world::SectionRun now = completing();
  EXPECT_EQ(now.section, before.section);
  EXPECT_EQ(knot_at(now.end() + 1), start);
  EXPECT_EQ(knot_at(now.end()).position, home.position);
  EXPECT_EQ(knot_at(now.end()).out_length, home.out_length);
  EXPECT_EQ(world::section(session.document, entity("q1")).kind, world::SectionKind::element);
  expect_closed_smoothly();
}

}  // namespace take_up_test
}  // namespace coaster::edit
