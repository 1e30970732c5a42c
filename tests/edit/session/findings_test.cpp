#include "edit/session/findings.h"

#include <algorithm>
#include <string>

#include "edit/session/ride_report.h"
#include "edit/session_fixture.h"
#include "sim/plan/element_plan.h"
#include "sim/shape/frame_methods.h"
#include "sim/solids/conflict_types.h"
#include "sim/solids/supports.h"
#include "sim/study/colour_values.h"
#include "sim/study/jolt.h"

namespace coaster::edit {
namespace findings_test {

class FindingsOfASession : public test::SessionTest {
 protected:
  // A session that has never found anything, in the same state: what it finds is computed afresh.
  Session fresh() const {
    Session other = make_session({});
    other.document = session.document;
    other.settings = session.settings;
    other.limits = session.limits;
    sim::derive(other.document, other.settings, {}, other.derived);
    sim::reset(other.document, other.derived, other.motion);
    return other;
  }
  void expect_the_same(const std::string& after) {
    Session other = fresh();
    const SessionFindings found(session), expected(other);
    EXPECT_EQ(found.document_hash(), world::hash(session.document)) << after;
    ASSERT_EQ(found.ride() == nullptr, expected.ride() == nullptr) << after;
    if (found.ride()) {
      EXPECT_EQ(found.ride()->samples.size(), expected.ride()->samples.size()) << after;
      EXPECT_EQ(found.ride()->samples.back().speed, expected.ride()->samples.back().speed) << after;
    }
    EXPECT_EQ(found.ratings().up_most.value, expected.ratings().up_most.value) << after;
    EXPECT_EQ(found.ratings().highest_drop, expected.ratings().highest_drop) << after;
    ASSERT_EQ(found.overloads().size(), expected.overloads().size()) << after;
    for (std::size_t i = 0; i < found.overloads().size(); ++i)
      EXPECT_EQ(found.overloads()[i].worst, expected.overloads()[i].worst) << after;
    ASSERT_EQ(found.jolts().size(), expected.jolts().size()) << after;
    for (std::size_t i = 0; i < found.jolts().size(); ++i)
      EXPECT_EQ(found.jolts()[i].total, expected.jolts()[i].total) << after;
    EXPECT_TRUE(std::equal(found.conflicts().begin(), found.conflicts().end(), expected.conflicts().begin(),
                           expected.conflicts().end()))
        << after;
    EXPECT_EQ(found.element().refusal, expected.element().refusal) << after;
    EXPECT_EQ(found.room().size(), expected.room().size()) << after;
    EXPECT_EQ(found.breaks().size(), expected.breaks().size()) << after;
    EXPECT_EQ(found.values().values, expected.values().values) << after;
    EXPECT_EQ(found.supports().count(), expected.supports().count()) << after;
  }
};

TEST_F(FindingsOfASession, are_those_of_a_fresh_session_after_every_change) {
  for (const char* const line : {"datum 2.5", "move @k2 to 3.7 19.3 -8.1", "undo", "redo", "split @s2 at 0.37",
                                 "colour speed", "start_speed 17.3", "colour curvature", "remove @k2", "undo"}) {
    good(line);
    expect_the_same(line);
  }
}

TEST_F(FindingsOfASession, a_ride_is_simulated_when_it_is_wanted_and_changed_alone) {
  good("start_speed 9.1");
  const SessionFindings found(session);
  ASSERT_NE(found.ride(), nullptr);
  const std::uint64_t first = found.ride()->serial;
  (void)found.ride();
  EXPECT_EQ(found.ride()->serial, first);
  for (const char* const line : {"start_speed 10.3", "start_speed 11.7", "start_speed 12.9"}) {
    good(line);
    (void)found.document_hash(), (void)found.conflicts(), (void)found.breaks(), (void)found.supports();
  }
  (void)found.ride();
  EXPECT_EQ(found.ride()->serial, first + 1);  // the edits between were never simulated
  EXPECT_EQ(found.ride()->start.speed, 12.9);
}

TEST_F(FindingsOfASession, without_a_cart_there_is_no_ride_and_nothing_of_one) {
  for (world::Entity cart; (cart = chosen_cart(session)).valid();)
    good("remove @" + world::label_of(session.document, cart));
  const SessionFindings found(session);
  EXPECT_EQ(found.ride(), nullptr);
  EXPECT_EQ(found.ratings().up_most.value, 0);
  EXPECT_TRUE(found.overloads().empty());
  EXPECT_TRUE(found.jolts().empty());
}

TEST_F(FindingsOfASession, the_report_of_an_imported_track_has_its_deviations) {
  good("add_cart @s1 at 0");
  EXPECT_EQ(ride_report(session)->find("deviation"), std::string::npos);
  session.file.import = exchange::ImportReport{0.00653, 0.339, 9, 2.08, 0.00297, 0.185};
  const std::string report = *ride_report(session);
  EXPECT_NE(
      report.find("largest deviation          6.53 mm, 0.339 deg, of the file's rows; at their jumps 2.080 deg\n"),
      std::string::npos)
      << report;
  EXPECT_NE(report.find("RMS deviation              2.97 mm, 0.185 deg\n"), std::string::npos) << report;
}

}  // namespace findings_test
}  // namespace coaster::edit
