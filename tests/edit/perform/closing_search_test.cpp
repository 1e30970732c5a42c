// Changes of a circuit whose closing section is searched beside the frames (edit/perform/job_result.h: Search).
#include <cstdio>
#include <ctime>
#include <utility>

#include <gtest/gtest.h>

#include "edit/perform/job_result.h"
#include "edit/session_fixture.h"

namespace coaster::edit {
namespace closing_search_test {

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
    ClosingSearch search{.leaves = true};
    EXPECT_FALSE(apply(line, &search).ok());
    EXPECT_TRUE(session.document == before) << "until the way is found";
    EXPECT_EQ(session.edits, edits);
    EXPECT_EQ(session.notices.serial, silent) << "nothing to tell yet";
    ASSERT_TRUE(search.wanted);
    sim::OpenedTrack opened;
    ClosingSearch answer{.found = sim::changed_closing(*search.wanted, opened), .asked = search.wanted};
    EXPECT_EQ(apply(line, &answer).ok(), can);
    EXPECT_EQ(hash(), wanted);
    EXPECT_EQ(session.notices.list.back().text, notice);
    if (!can) continue;
    EXPECT_FALSE(answer.found) << "taken";
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
  const auto took = [&](ClosingSearch* search) {
    const double began = thread_seconds();
    (void)apply(line, search);
    return thread_seconds() - began;
  };
  circuit();
  const double whole = took(nullptr);
  const std::uint64_t after = hash();
  circuit();
  ClosingSearch search{.leaves = true};
  const double asked = took(&search);
  ASSERT_TRUE(search.wanted);
  ClosingSearch answer{.found = sim::changed_closing(*search.wanted, edit::opened_track_of(session)),
                       .asked = search.wanted};
  const double taken = took(&answer);
  EXPECT_EQ(hash(), after);
  std::printf("at once %.1f ms; beside the frames %.1f and %.1f ms\n", 1e3 * whole, 1e3 * asked, 1e3 * taken);
  EXPECT_LT(asked, 0.3 * whole);
  EXPECT_LT(taken, 0.5 * whole);
}

TEST_F(WaySearches, an_answer_to_another_change_is_not_taken) {
  circuit();
  ClosingSearch search{.leaves = true};
  EXPECT_FALSE(apply("section.change @q2 to climb height 30 equipment lift", &search).ok());
  ASSERT_TRUE(search.wanted);
  ClosingSearch answer{.found = sim::ClosingReplanResult{.refusal = "an answer to another question"},
                       .asked = search.wanted};
  EXPECT_TRUE(apply("section.change @q2 to climb height 31 equipment lift", &answer).ok());
  EXPECT_TRUE(answer.found);
  const std::uint64_t after = hash();
  circuit();
  good("section.change @q2 to climb height 31 equipment lift");
  EXPECT_EQ(after, hash());
}

}  // namespace closing_search_test
}  // namespace coaster::edit
