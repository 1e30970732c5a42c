// Searches on a copy of the session (edit/perform/seek.h), with a referee that measures one height. Searches for real
// queries: tests/query/goal_test.cpp.
#include "edit/perform/seek.h"

#include <cmath>

#include "base/as_job.h"
#include "edit/session_fixture.h"

namespace coaster::edit {
namespace perform_seek_test {

// "N": the height of k3 shall be N m.
base::Result<GoalState> height_of_k3(Session& session, const std::string& goal) {
  const world::Entity k3 = world::find(session.document, {world::EntityKind::knot, 3});
  if (!k3.valid()) return base::Status{base::Code::refused, "no k3"};
  const double wanted = *base::parse_double(goal), found = world::knot(session.document, k3).position.y;
  return GoalState{found, wanted, 1e-3, std::abs(found - wanted) <= 1e-3, "Height", "m"};
}

class Searches : public test::SessionTest {
 protected:
  Searches() { session.game.referee.measure = height_of_k3; }
  float height() { return world::knot(session.document, entity("k3")).position.y; }
  static SeekGoal seek(const Command& command) { return *command.as<SeekGoal>(); }
};

TEST_F(Searches, leave_the_session_as_it_is_until_the_command_takes_the_result) {
  const Command line = command("seek 20 by height of @k3");
  const world::Document before = session.document;
  const auto search = search_for(session, seek(line));
  good("remove @k3");  // the copy was made before
  good("undo");
  base::JobProgress progress;
  const auto found = test::as_job(progress, search);
  ASSERT_TRUE(found) << found.status().message;
  EXPECT_TRUE(session.document == before);
  EXPECT_EQ(found->note, "Height is 20 m, was 7.7 m. Height: from 7.7 to 20 m.");

  ClosingSearch answer{.found = *found};
  EXPECT_TRUE(apply(line, &answer).ok());
  EXPECT_NEAR(height(), 20, 1e-3);
  good("undo");
  answer.found = SeekResult{{21}, "as found"};
  EXPECT_TRUE(apply(line, &answer).ok());
  EXPECT_NEAR(height(), 21, 1e-3) << "it does not search again";
}

TEST_F(Searches, end_when_they_are_cancelled) {
  base::JobProgress progress;
  progress.cancelled = true;
  const auto found = test::as_job(progress, search_for(session, seek(command("seek 20 by height of @k3"))));
  ASSERT_FALSE(found);
  EXPECT_EQ(found.status().code, base::Code::refused);
}

TEST_F(Searches, change_several_numbers_alike_or_by_themselves) {
  good("seek 20 by height of @k2..@k4 together on");
  const float k2 = world::knot(session.document, entity("k2")).position.y;
  EXPECT_NEAR(k2 - 19.7f, height() - 7.7f, 1e-4) << "by the same amount";
  good("seek 10 by height of @k2..@k4");
  EXPECT_EQ(world::knot(session.document, entity("k2")).position.y, k2) << "it has no effect, so it stays";
}

TEST_F(Searches, need_somebody_who_measures) {
  session.game.referee = {};
  refused(command("seek 20 by height of @k3"), "cannot measure goals");
}

}  // namespace perform_seek_test
}  // namespace coaster::edit
