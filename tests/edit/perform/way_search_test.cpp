// Changes of a circuit whose way home is searched beside the frames (edit/session/session.h: WaySearch).
#include <cstdio>
#include <ctime>
#include <utility>

#include <gtest/gtest.h>

#include "edit/session/found_way.h"
#include "edit/session_fixture.h"

namespace coaster::edit {
namespace way_search_test {

class WaySearches : public test::SessionTest {
 protected:
  WaySearches() : SessionTest(world::Document{}) {}
};

// As a window does, which must not wait for the search in a frame.
TEST_F(WaySearches, a_search_beside_the_frames_comes_to_the_same) {
  for (const char* const line : {"section.change @q2 to climb height 30 equipment lift", "section.mirror @q6",
                                 "section.change @q5 to straight length 2000", "section.delete @q4"}) {
    SCOPED_TRACE(line);
    circuit();
    const world::Document before = session.document;
    const bool can = apply(line).ok();
    const std::uint64_t wanted = hash();
    const std::string notice = session.notices.list.back().text;
    circuit();
    ASSERT_TRUE(session.document == before);
    const std::uint64_t edits = session.edits, silent = session.notices.serial;
    session.way_search.beside = true;
    EXPECT_FALSE(apply(line).ok());
    EXPECT_TRUE(session.document == before) << "until the way is found";
    EXPECT_EQ(session.edits, edits);
    EXPECT_EQ(session.notices.serial, silent) << "nothing to tell yet";
    ASSERT_TRUE(session.way_search.wanted);
    const sim::WayChange change = *std::exchange(session.way_search.wanted, nullptr);
    sim::OpenedTrack opened;
    session.way_search.found = std::make_shared<FoundWay>(FoundWay{change, sim::changed_way(change, opened)});
    EXPECT_EQ(apply(line).ok(), can);
    EXPECT_EQ(hash(), wanted);
    EXPECT_EQ(session.notices.list.back().text, notice);
    if (!can) continue;
    EXPECT_FALSE(session.way_search.found) << "taken";
    good("undo");
    EXPECT_TRUE(session.document == before) << "one step";
  }
}

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// What the frames do: prepare the search, and take its answer. Times of the thread, which other programs do not change.
TEST_F(WaySearches, neither_frame_of_a_change_does_the_search) {
  const std::string line = "section.change @q1 to straight length 2000 equipment station";
  const auto took = [&] {
    const double began = thread_seconds();
    (void)apply(line);
    return thread_seconds() - began;
  };
  circuit();
  const double whole = took();
  const std::uint64_t after = hash();
  circuit();
  session.way_search.beside = true;
  const double asked = took();
  const sim::WayChange change = *std::exchange(session.way_search.wanted, nullptr);
  session.way_search.found =
      std::make_shared<FoundWay>(FoundWay{change, sim::changed_way(change, edit::opened_track_of(session))});
  const double taken = took();
  EXPECT_EQ(hash(), after);
  std::printf("at once %.1f ms; beside the frames %.1f and %.1f ms\n", 1e3 * whole, 1e3 * asked, 1e3 * taken);
  EXPECT_LT(asked, 0.3 * whole);
  EXPECT_LT(taken, 0.5 * whole);
}

TEST_F(WaySearches, an_answer_to_another_change_is_not_taken) {
  circuit();
  session.way_search.beside = true;
  EXPECT_FALSE(apply("section.change @q2 to climb height 30 equipment lift").ok());
  const sim::WayChange change = *std::exchange(session.way_search.wanted, nullptr);
  session.way_search.found = std::make_shared<FoundWay>(FoundWay{change, {.refusal = "an answer to another question"}});
  session.way_search.beside = false;
  good("section.change @q2 to climb height 31 equipment lift");
  const std::uint64_t after = hash();
  circuit();
  good("section.change @q2 to climb height 31 equipment lift");
  EXPECT_EQ(after, hash());
}

}  // namespace way_search_test
}  // namespace coaster::edit
