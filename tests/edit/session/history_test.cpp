// History: src/edit/session/session.
#include "edit/session/session.h"

#include "base/tries.h"
#include "edit/session/findings_memory.h"
#include "edit/session_fixture.h"
#include "sim/tracks.h"
#include "world/evaluation_settings.h"

namespace coaster::edit {
namespace history_test {

class HistoryOfEdits : public test::SessionTest {};

TEST_F(HistoryOfEdits, undo_restores_the_document_exactly_and_redo_too) {
  const world::Document before = session.document;
  good("split @s2 at 0.3");
  const world::Document after = session.document;
  good("undo");
  EXPECT_TRUE(session.document == before);
  good("redo");
  EXPECT_TRUE(session.document == after);
  good("undo");
  good("split @s2 at 0.3");  // the same names come back
  EXPECT_TRUE(session.document == after);
}

TEST_F(HistoryOfEdits, a_new_edit_empties_the_redo_stack) {
  good("datum 3.5");
  good("undo");
  good("datum 4.5");
  refused("redo", "nothing to redo");
}

TEST_F(HistoryOfEdits, nothing_to_undo_is_refused) { refused("undo", "nothing to undo"); }

TEST_F(HistoryOfEdits, a_command_that_changes_nothing_is_no_step) {
  good("datum -1.7");
  good("closed off");
  good("joint @k1 to smooth");
  EXPECT_TRUE(session.history.undo.empty());
}

TEST_F(HistoryOfEdits, a_gesture_is_one_step) {
  const world::Document before = session.document;
  good("gesture.begin");
  for (int i = 0; i < 20; ++i) good("move @k3 to " + std::to_string(150 + i) + " 7.7 -11.3");
  good("gesture.end");
  const world::Document after = session.document;
  ASSERT_EQ(session.history.undo.size(), 1u);
  EXPECT_EQ(session.history.undo.back().text.command, "move @k3 to 169 7.7 -11.3");
  good("undo");
  EXPECT_TRUE(session.document == before);
  good("redo");
  EXPECT_TRUE(session.document == after);
}

TEST_F(HistoryOfEdits, a_cancelled_gesture_leaves_no_trace) {
  const world::Document before = session.document;
  const world::Motion motion = session.motion;
  for (const char* end : {"gesture.cancel", "undo"}) {
    good("gesture.begin");
    good("move @k3 to 151 9 -10");
    good("split @s1 at 0.4");
    good("remove @k5");
    good(end);
    EXPECT_EQ(session.notices.list.back().text, "Cancelled: Deleted k5.");
    EXPECT_TRUE(session.document == before);
    EXPECT_TRUE(session.motion == motion);
    EXPECT_TRUE(session.history.undo.empty());
    EXPECT_FALSE(session.history.in_gesture);
  }
}

TEST_F(HistoryOfEdits, a_gesture_that_changed_nothing_is_no_step) {
  good("gesture.begin");
  good("datum 9");
  good("datum -1.7");
  good("gesture.end");
  EXPECT_TRUE(session.history.undo.empty());
}

TEST_F(HistoryOfEdits, a_gesture_that_moved_anything_counts_as_unsaved_until_its_end) {
  good("gesture.begin");
  EXPECT_FALSE(dirty(session));
  good("datum 9");
  good("datum -1.7");  // as it is saved
  EXPECT_TRUE(dirty(session));
  EXPECT_NE(session.findings->document_hash.key, session.edits) << "a hash was made";
  good("gesture.end");
  EXPECT_FALSE(dirty(session));
  good("datum 9");
  EXPECT_TRUE(dirty(session));
}

TEST_F(HistoryOfEdits, gestures_open_and_close_in_pairs) {
  refused("gesture.end", "no gesture");
  refused("gesture.cancel", "no gesture");
  good("gesture.begin");
  refused("gesture.begin", "open already");
  refused("redo", "a gesture is open");
  good("gesture.end");
}

TEST_F(HistoryOfEdits, undo_does_not_touch_settings) {
  good("datum 5");
  good("resolution 17");
  good("undo");
  EXPECT_EQ(session.settings.evaluation->steps, 17);
}

TEST(history, the_oldest_steps_are_dropped_beyond_the_limit_but_never_the_newest) {
  constexpr std::size_t kLimit = 1u << 20;
  History history;
  history.limit = kLimit;
  world::Document large;
  large.name.assign(kLimit / 4, 'x');
  for (int i = 0; i < 10; ++i) record(history, {std::to_string(i), {}}, large, large);
  EXPECT_EQ(history.undo.size(), 3u);
  EXPECT_EQ(history.undo.back().text.command, "9");
  EXPECT_LE(history.bytes, kLimit);
  EXPECT_EQ(history.dropped, 7u);
  large.name.assign(kLimit * 2, 'x');
  record(history, {"huge", {}}, large, large);
  ASSERT_EQ(history.undo.size(), 1u);
  EXPECT_EQ(history.undo.back().text.command, "huge");
  ASSERT_TRUE(undo(history, large));
  EXPECT_EQ(history.bytes, bytes_of(history.redo.back()));
  record(history, {"small", {}}, {}, {});
  EXPECT_EQ(history.bytes, bytes_of(history.undo.back())) << "a new step ends the redo stack";
}

TEST_F(HistoryOfEdits, a_full_history_says_so_once) {
  session.history.limit = 100'000;
  const auto told = [&] {
    int times = 0;
    for (const Notice& notice : session.notices.list) times += notice.text.find("oldest") != std::string::npos;
    return times;
  };
  good("datum 7.5");
  EXPECT_EQ(told(), 0);
  for (int i = 0; i < 200; ++i) good("datum " + std::to_string(i)), good("name \"" + std::to_string(i) + "\"");
  EXPECT_GT(session.history.dropped, 0u);
  EXPECT_EQ(told(), 1);
  EXPECT_LE(session.history.bytes, session.history.limit);
}

// A step takes what it changes, however long the track is.
TEST_F(HistoryOfEdits, a_step_takes_the_memory_of_what_it_changes) {
  constexpr int kKnots = test::kSanitized ? 10'000 : 20'000;
  start_on(test::ring_document(kKnots, 9000));
  const std::uint64_t start = world::hash(session.document);
  const std::size_t knots = kKnots * sizeof(world::Knot);
  for (const char* const few : {"move @k777 to 1 2 3", "split @s5000 at 0.4", "remove @k9000", "equip @s3 as lift",
                                "roll @k12 to 30", "name \"Another\""}) {
    const std::size_t before = session.history.bytes;
    good(few);
    EXPECT_LT(session.history.bytes - before, 65'536u) << few;
  }
  const std::size_t before = session.history.bytes;
  good("gesture.begin");
  for (int i = 1; i <= 10; ++i) good("move @k" + std::to_string(kKnots / 11 * i) + " to 5 6 7");
  good("gesture.end");
  EXPECT_LT(session.history.bytes - before, 65'536u);
  const std::size_t few = session.history.bytes;
  good("reverse");
  // Knots, and the segments' two ends, and both orders.
  const std::size_t all = knots + kKnots * (sizeof(world::Segment) + 2 * sizeof(world::Entity));
  EXPECT_LT(session.history.bytes - few, all + 65'536u);
  EXPECT_GT(session.history.bytes - few, knots / 2) << "it changes all knots";
  const std::uint64_t end = world::hash(session.document);
  while (!session.history.undo.empty()) good("undo");
  EXPECT_EQ(world::hash(session.document), start);
  while (!session.history.redo.empty()) good("redo");
  EXPECT_EQ(world::hash(session.document), end);
}

}  // namespace history_test
}  // namespace coaster::edit
