// The command that makes force sections of others: what stays, what is told, and what is refused. No header of its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "edit/force_fixture.h"
#include "sim/plan/element_plan.h"

namespace coaster::edit {
namespace force_reading_test {

class ReadingForces : public test::Forces {
 protected:
  void build(const char* speed, const char* lift) {
    start_on(world::Document{});
    good(std::string("start_speed ") + speed);
    good(std::string("element climb height 20") + lift);
    good("element straight length 8");
    good("element dive height 18");
    good("element curve left radius 30 angle 60");
    good("element straight length 12");
  }
  const world::Section& section_of(const char* name) { return world::section(session.document, entity(name)); }
  std::string note() const { return session.notices.list.back().text; }
  bool told(const std::string& words) const {
    const auto& all = session.notices.list;
    return std::any_of(all.begin(), all.end(),
                       [&](const Notice& n) { return n.text.find(words) != std::string::npos; });
  }
};

TEST_F(ReadingForces, the_shape_and_both_ends_stay_and_the_note_counts_keys_and_spans) {
  build("5", " equipment lift speed 5");
  const double length = session.derived.length;
  const world::Knot end = world::knot(session.document, session.document.track.knots.back());
  good("force.read @q4 tolerance 0.03");
  const world::Section& made = section_of("q4");
  EXPECT_EQ(made.kind, world::SectionKind::force);
  EXPECT_EQ(made.force.tolerance, 0.03);
  EXPECT_NEAR(session.derived.length, length, 0.05);
  EXPECT_EQ(world::knot(session.document, session.document.track.knots.back()), end);
  EXPECT_EQ(session.settings.selected, entity("q4"));
  std::size_t keys = 0;
  for (const auto& channel : made.force.channels) keys += channel.size();
  const std::size_t spans = world::run_of(session.document, entity("q4")).count;
  EXPECT_EQ(note().find(std::to_string(keys) + " keys keep the shape within "), 0u) << note();
  EXPECT_NE(note().find(" mm, in " + std::to_string(spans) + " spans."), std::string::npos) << note();
  EXPECT_FALSE(told(sim::assumed_text())) << "a train comes here";
  good("undo");
  EXPECT_EQ(section_of("q4").kind, world::SectionKind::element);
}

// Without a lift the train does not come over the climb.
TEST_F(ReadingForces, where_no_train_comes_a_speed_is_assumed_and_told) {
  build("5", "");
  good("force.read @q4");
  EXPECT_EQ(section_of("q4").force.speed, sim::kAssumedSpeed);
  EXPECT_TRUE(told(sim::assumed_text())) << note();
  build("5", " equipment lift speed 5");
  good("force.read @q4");
  EXPECT_GT(section_of("q4").force.speed, sim::kAssumedSpeed);
}

TEST_F(ReadingForces, neighbours_become_one_and_others_are_refused) {
  build("5", " equipment lift speed 5");
  const std::size_t sections = world::sections_of(session.document).size();
  refused(command("force.read @q1..@q2"), "part of it has equipment that the rest lacks");
  refused(command("force.read @q2,@q4"), "expected neighbouring sections");
  good("force.read @q4..@q5");
  EXPECT_EQ(world::sections_of(session.document).size(), sections - 1);
  refused(command("force.read @q4"), "@q4 is a force section");
}

}  // namespace force_reading_test
}  // namespace coaster::edit
