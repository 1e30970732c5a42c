// Spins of knots: set by command, derived after edits, and in files of both versions.
#include <cmath>

#include "base/scratch_folder.h"
#include "base/text.h"
#include "edit/commands/commands_document.h"
#include "edit/session_fixture.h"
#include "world/topology.h"

namespace coaster::edit {
namespace perform_spin_test {

using glm::dvec3;
using world::Entity;
using world::SpinKind;

// Rolls of 0 to 150 degrees over 8 knots of an open, winding track; all spins are automatic.
world::Document rolling() {
  world::Document d;
  for (int i = 0; i < 8; ++i) {
    const float x = 11.3f * static_cast<float>(i);
    world::Knot knot = test::skew_knot({x, 9 + 2 * std::sin(x), 3 * std::cos(0.7f * x)}, {1, 0.1f, 0.2f}, 3, 4);
    world::set_roll(knot, i * i * 3.0);
    world::append_knot(d, knot);
  }
  sim::set_automatic_spins(d);
  return d;
}

class Spins : public test::SessionTest {
 protected:
  Spins() : SessionTest(rolling()) {}
  float spin(std::size_t place) const {
    return world::knot(session.document, session.document.track.knots[place]).spin;
  }
  // The track's frames at `count` places.
  std::vector<curve::Frame> frames(int count) const {
    std::vector<curve::Frame> all;
    for (int i = 0; i <= count; ++i) {
      const sim::TrackPlace at = sim::place_at(session.derived, session.derived.length * i / count);
      all.push_back(sim::frame_at(session.derived.shape_at(at.index), at.s));
    }
    return all;
  }
  // How many segments have another shape than in `before`.
  int reshaped(const sim::DerivedTrack& before) const {
    int count = 0;
    for (const Entity e : session.derived.order) {
      const sim::SegmentShape* const old = before.segments.find(e);
      if (old == nullptr || !(old->key == session.derived.shape(e).key)) ++count;
    }
    return count;
  }
};

TEST_F(Spins, spin_sets_the_rate_in_degrees_per_metre) {
  good("spin @k3 to 12.5");
  EXPECT_NEAR(spin(2), 12.5 * M_PI / 180, 1e-7);
  EXPECT_EQ(knot(3).spin_kind, SpinKind::set);
  clamped("spin @k3 to 1e9", "limit");
  EXPECT_EQ(spin(2), world::kMaxSpin);
  refused(SetSpin{{{world::EntityKind::knot, 3}}, NAN}, "finite");
  good("undo");
  good("undo");
  EXPECT_EQ(session.document, rolling());
}

TEST_F(Spins, auto_spin_takes_a_set_rate_back) {
  const world::Document before = session.document;
  good("spin @k3 to -4");
  good("auto_spin @k3");
  EXPECT_EQ(session.document, before);
}

TEST_F(Spins, a_move_keeps_all_spins_and_changes_two_segments) {
  const sim::DerivedTrack before = session.derived;
  good("move @k4 to 35.2 14.3 4.4");
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(spin(i), world::knot(rolling(), rolling().track.knots[i]).spin) << i;
  EXPECT_EQ(reshaped(before), 2);
}

TEST_F(Spins, a_roll_changes_the_spins_beside_it_and_at_most_four_segments) {
  const sim::DerivedTrack before = session.derived;
  good("roll @k4 to 44");
  EXPECT_EQ(reshaped(before), 4);
  for (const std::size_t still : {0u, 1u, 5u, 6u, 7u})
    EXPECT_EQ(spin(still), world::knot(rolling(), rolling().track.knots[still]).spin) << still;
  world::Document again = session.document;
  sim::set_automatic_spins(again);
  EXPECT_EQ(again, session.document);
}

TEST_F(Spins, set_spins_stay_when_the_roll_beside_them_changes) {
  good("spin @k4 to 3");
  const float set = spin(3);
  good("roll @k4 to 80");
  good("roll @k5 to 10");
  EXPECT_EQ(spin(3), set);
}

TEST_F(Spins, whole_turns_change_the_spins_at_both_ends) {
  const float before = spin(3);
  good("turns @s4 to 1");
  EXPECT_NE(spin(3), before);
  world::Document again = session.document;
  sim::set_automatic_spins(again);
  EXPECT_EQ(again, session.document);
}

TEST_F(Spins, a_split_keeps_every_frame) {
  good("turns @s4 to 1");
  const std::vector<curve::Frame> before = frames(200);
  for (const char* line : {"split @s4 at 0.3", "split @s2 at 0.71", "split @s6 at 0.05"}) {
    good(line);
    const std::vector<curve::Frame> after = frames(200);
    for (std::size_t i = 0; i < after.size(); ++i)
      EXPECT_LT(glm::distance(after[i].up, before[i].up), 2e-3) << line << " " << i;
  }
}

TEST_F(Spins, reversing_keeps_every_frame) {
  const std::vector<curve::Frame> before = frames(120);
  good("reverse");
  const std::vector<curve::Frame> after = frames(120);
  for (std::size_t i = 0; i < after.size(); ++i) EXPECT_LT(glm::distance(after[i].up, before[120 - i].up), 1e-3) << i;
}

TEST_F(Spins, a_mirror_reflects_every_frame) {
  const std::vector<curve::Frame> before = frames(120);
  good("mirror all across 0 0 1 about 0 0 0");
  const std::vector<curve::Frame> after = frames(120);
  for (std::size_t i = 0; i < after.size(); ++i)
    EXPECT_LT(glm::distance(after[i].up, before[i].up * dvec3(1, 1, -1)), 1e-3) << i;
}

TEST_F(Spins, scaling_divides_spins_so_that_frames_stay) {
  const std::vector<curve::Frame> before = frames(120);
  good("scale_knots all by 3 3 3 about 0 0 0");
  const std::vector<curve::Frame> after = frames(120);
  for (std::size_t i = 0; i < after.size(); ++i) EXPECT_LT(glm::distance(after[i].up, before[i].up), 1e-3) << i;
}

TEST_F(Spins, appending_removing_and_closing_compute_the_spins_beside_them) {
  for (const char* line : {"append at 95 12 3", "remove @k4", "remove @k1", "closed on", "closed off"}) {
    good(line);
    world::Document again = session.document;
    sim::set_automatic_spins(again);
    EXPECT_EQ(again, session.document) << line;
  }
}

TEST_F(Spins, files_keep_spins_and_their_kinds) {
  good("spin @k3 to 12.5");
  const auto again = exchange::parse_track(exchange::print_track(session.document), "t");
  ASSERT_TRUE(again) << again.status().message;
  EXPECT_EQ(world::hash(again->document), world::hash(session.document));
  EXPECT_EQ(again->version, exchange::version_of(session.document));
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_EQ(world::knot(again->document, again->document.track.knots[i]).spin, spin(i)) << i;
}

TEST_F(Spins, files_of_version_1_open_with_automatic_spins_and_saving_tells_of_the_newest) {
  std::string text = exchange::print_track(rolling());
  text.replace(text.find("\"version\": 3"), 12, "\"version\": 1");
  for (std::size_t at; (at = text.find(", \"spin\": ")) != std::string::npos;)
    text.erase(at, text.find_first_of(",}", at + 10) - at);
  const auto old = exchange::parse_track(text, "t");
  ASSERT_TRUE(old) << old.status().message;
  EXPECT_EQ(world::hash(old->document), world::hash(rolling()));
  const test::ScratchFolder folder;
  const std::string from = base::quoted((folder.path() / "old.json").string()),
                    to = base::quoted((folder.path() / "new.json").string());
  ASSERT_TRUE(files.write_atomic(folder.path() / "old.json", text));
  good("load " + from);
  good("save " + to);
  EXPECT_NE(session.notices.list.back().text.find("version 3"), std::string::npos);
  good("save " + to);
  EXPECT_EQ(session.notices.list.back().text.find("version 3"), std::string::npos);
}

}  // namespace perform_spin_test
}  // namespace coaster::edit
