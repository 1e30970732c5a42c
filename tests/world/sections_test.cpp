#include "world/sections.h"

#include <gtest/gtest.h>

#include "world/element_rows.h"
#include "world/sample_documents.h"

namespace coaster::world {
namespace sections_test {

// Writes the sections as "q1:2 q2:1".
std::string runs_of(const Document& d) {
  std::string text;
  for (const SectionRun& run : sections_of(d))
    text += (text.empty() ? "" : " ") + label_of(d, run.section) + ":" + std::to_string(run.count);
  EXPECT_EQ(broken_invariant(d), std::nullopt);
  return text;
}

Entity named(const Document& d, const char* name) { return find(d, *parse_name(name)); }
const Section kLoop{{}, SectionKind::element, usual_element(ElementKind::loop)};

TEST(sections, appended_segments_extend_a_free_section_and_no_other) {
  Document d = test::sample_document();
  EXPECT_EQ(runs_of(d), "q1:4");
  make_section(d, 3, 1, kLoop);
  EXPECT_EQ(runs_of(d), "q1:3 q2:1");
  append_knot(d, test::skew_knot({1, 2, 3}, {1, 0, 0}, 4, 4));
  EXPECT_EQ(runs_of(d), "q1:3 q2:1 q3:1");
  append_knot(d, test::skew_knot({11, 2, 3}, {1, 0, 0}, 4, 4));
  EXPECT_EQ(runs_of(d), "q1:3 q2:1 q3:2");
  set_closed(d, true);
  EXPECT_EQ(runs_of(d), "q1:3 q2:1 q3:3");
  set_closed(d, false);
  EXPECT_EQ(runs_of(d), "q1:3 q2:1 q3:2");
}

TEST(sections, a_shorter_section_is_what_is_left_when_its_last_knots_are_removed_one_by_one) {
  int tried = 0;
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    Document d = test::random_document(seed);
    const std::size_t all = d.track.segments.size();
    if (all < 2) continue;
    const std::size_t first = seed % all;
    const Entity section = make_section(d, first, seed % 3 == 0 ? all - first : 1 + seed % (all - first), kLoop);
    for (const Entity e : d.track.segments) d.entities.get<Segment>(e).turns = 0;
    const SectionRun run = run_of(d, section);
    for (std::size_t count = 1; count <= run.count; ++count) {
      Document bulk = d, single = d;
      resize_section(bulk, section, count);
      for (std::size_t left = run.count; left > count; --left)
        remove_knot(single, single.track.knots[run.first + left - 1]);
      for (Document* const each : {&bulk, &single})  // which the caller sets
        for (Train& cart : each->entities.pool<Train>().items()) cart.fraction = 0;
      EXPECT_TRUE(bulk == single) << seed << ": " << run.first << " " << run.count << " to " << count;
      EXPECT_EQ(broken_invariant(bulk), std::nullopt);
      EXPECT_EQ(bulk.entities.create(), single.entities.create());
      ++tried;
    }
  }
  EXPECT_GT(tried, 60);
}

TEST(sections, halves_stay_together_and_the_last_segment_takes_its_section_along) {
  Document d = test::sample_document();
  make_section(d, 1, 1, kLoop);
  EXPECT_EQ(runs_of(d), "q1:1 q3:1 q2:2") << "what lies after a cut is a new section";
  const Entity knot = split_segment(d, d.track.segments[1], 0.4, {0, 1, 0}).knot;
  EXPECT_EQ(runs_of(d), "q1:1 q3:2 q2:2");
  remove_knot(d, knot);
  EXPECT_EQ(runs_of(d), "q1:1 q3:1 q2:2");
  remove_knot(d, d.track.knots[2]);
  EXPECT_EQ(runs_of(d), "q1:1 q3:1 q2:1") << "the earlier segment survives";
  reverse(d);
  EXPECT_EQ(runs_of(d), "q2:1 q3:1 q1:1");
  remove_knot(d, d.track.knots[0]);
  EXPECT_EQ(runs_of(d), "q3:1 q1:1");
  remove_knot(d, d.track.knots[1]);
  EXPECT_EQ(runs_of(d), "q3:1");
}

TEST(sections, on_a_closed_track_none_crosses_the_first_knot) {
  Document d = test::sample_document();
  make_section(d, 3, 1, kLoop);
  set_closed(d, true);
  EXPECT_EQ(runs_of(d), "q1:3 q2:1 q3:1");
  remove_knot(d, d.track.knots[0]);
  EXPECT_EQ(runs_of(d), "q1:2 q2:1 q3:1");
  reverse(d);
  EXPECT_EQ(runs_of(d), "q3:1 q2:1 q1:2");
  while (d.track.knots.size() > 2) remove_knot(d, d.track.knots[1]);
  EXPECT_EQ(sections_of(d).size(), d.entities.pool<Section>().size());
  remove_knot(d, d.track.knots[0]);
  EXPECT_EQ(runs_of(d), "");
}

TEST(sections, making_one_keeps_the_first_name_that_lies_wholly_in_it) {
  Document d = test::sample_document();
  make_section(d, 1, 1, kLoop), make_section(d, 2, 1, {});
  EXPECT_EQ(runs_of(d), "q1:1 q3:1 q4:1 q2:1");
  make_section(d, 1, 3, {"Both", {}, {}});
  EXPECT_EQ(runs_of(d), "q1:1 q3:3");
  EXPECT_EQ(title_of(section(d, named(d, "q3"))), "Both");
  EXPECT_TRUE(is_free(d, named(d, "q3")));
  make_section(d, 0, 2, kLoop);
  EXPECT_EQ(runs_of(d), "q1:2 q3:2");
  EXPECT_EQ(run_of(d, named(d, "q3")), (SectionRun{named(d, "q3"), 2, 2}));
  EXPECT_EQ(section_of_knot(d, d.track.knots[0]), named(d, "q1"));
  EXPECT_EQ(section_of_knot(d, d.track.knots[2]), named(d, "q1"));
  EXPECT_EQ(section_of_knot(d, d.track.knots[3]), named(d, "q3"));
}

TEST(sections, without_a_title_they_are_shown_by_their_kind) {
  EXPECT_EQ(title_of({}), "Hand-shaped");
  EXPECT_EQ(title_of(kLoop), "Loop");
  EXPECT_EQ(kind_name({}), "free");
  EXPECT_EQ(kind_name(kLoop), "loop");
}

}  // namespace sections_test
}  // namespace coaster::world
