// The track's curve: rails or heartline, by command, in files and exports, and under moving trains.
#include <gtest/gtest.h>

#include "base/scratch_folder.h"
#include "edit/commands/commands_operation.h"
#include "edit/session_fixture.h"
#include "exchange/formats.h"
#include "sim/shape/folds.h"
#include "sim/shape/rails.h"

namespace coaster::edit {
namespace perform_curve_test {

using world::TrackCurve;

struct Curve : test::SessionTest {
  glm::dvec3 train(std::size_t i) const {
    return sim::pose(session.derived, session.motion.carts.items()[i], world::FrameMethod::knots).position;
  }
};

TEST_F(Curve, keeping_numbers_changes_nothing_but_the_choice) {
  world::Document wanted = session.document;
  const glm::dvec3 before = train(0);
  good("curve heartline keep numbers");
  wanted.curve = TrackCurve::heartline;
  EXPECT_EQ(session.document, wanted);
  EXPECT_NEAR(glm::distance(train(0), before), 1.1, 1e-9);
  good("curve rails keep numbers");
  EXPECT_EQ(train(0), before);
  good("undo"), good("undo");
  EXPECT_EQ(train(0), before);
  EXPECT_EQ(session.document.curve, TrackCurve::rails);
}

TEST_F(Curve, keeping_rails_is_one_step_of_undo) {
  const world::Document before = session.document;
  const glm::dvec3 at = train(0);
  good("curve heartline keep rails");
  EXPECT_EQ(session.document.curve, TrackCurve::heartline);
  EXPECT_LT(glm::distance(train(0), at), 0.02);
  EXPECT_NE(session.notices.list.back().text.find("The rails moved by at most"), std::string::npos);
  good("undo");
  EXPECT_EQ(session.document, before);
  good("redo");
  EXPECT_EQ(session.document.curve, TrackCurve::heartline);
  const std::uint64_t edited = hash();
  good("curve heartline keep rails");  // is so already
  EXPECT_EQ(hash(), edited);
}

TEST_F(Curve, moving_trains_stay_on_their_rails) {
  good("ride.start");
  advance(session, 150);
  std::vector<glm::dvec3> before;
  for (std::size_t i = 0; i < session.motion.carts.size(); ++i) before.push_back(train(i));
  const double speed = session.motion.carts.items()[0].speed;
  good("curve heartline keep rails");
  ASSERT_EQ(session.motion.carts.size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_LT(glm::distance(train(i), before[i]), 0.02) << i;
  EXPECT_EQ(session.motion.carts.items()[0].speed, speed);
}

TEST_F(Curve, is_a_member_of_the_file_only_where_it_is_the_heartline) {
  const std::uint64_t before = hash();
  EXPECT_EQ(exchange::print_track(session.document).find("\"curve\""), std::string::npos);
  good("curve heartline keep numbers");
  EXPECT_NE(hash(), before);
  const std::string text = exchange::print_track(session.document);
  EXPECT_NE(text.find("\"curve\": \"heartline\""), std::string::npos);
  const auto loaded = exchange::parse_track(text, "a.json");
  ASSERT_TRUE(loaded) << loaded.status().message;
  EXPECT_EQ(loaded->document.curve, TrackCurve::heartline);
  EXPECT_EQ(world::hash(loaded->document), hash());
  std::string wrong = text;
  wrong.replace(wrong.find("\"heartline\""), 11, "\"spine\"");
  EXPECT_FALSE(exchange::parse_track(wrong, "a.json").ok());
}

// The exports of a heartline track are those of the same track made of rails.
TEST_F(Curve, exports_are_of_the_rails) {
  const test::ScratchFolder folder;
  good("curve heartline keep rails");
  const world::Document heart = session.document;
  const sim::DerivedTrack derived = sim::shapes_of(heart);
  for (const char* name : {"a.csv", "a.nl2elem"}) {
    const std::string path = folder.path() / name;
    ASSERT_TRUE(exchange::save_track(files, path, heart));
    const auto loaded = exchange::load_track(files, path);
    ASSERT_TRUE(loaded) << loaded.status().message;
    EXPECT_EQ(loaded->document.curve, TrackCurve::rails);
    const sim::DerivedTrack rails = sim::shapes_of(loaded->document);
    const glm::dvec3 start = sim::rails_at(derived.shape_at(0), 0), first = sim::rails_at(rails.shape_at(0), 0);
    EXPECT_LT(glm::distance(start, first), 0.011) << name;
    EXPECT_GT(glm::distance(first, curve::point(derived.shape_at(0).key.cubic, 0)), 1.0) << name;
  }
  for (const char* name : {"a.obj", "a.gltf", "a.svg"}) {
    EXPECT_TRUE(exchange::save_track(files, (folder.path() / name).string(), heart)) << name;
  }
}

TEST_F(Curve, exports_are_refused_where_rails_fold) {
  const test::ScratchFolder folder;
  session.document.heartline = 5;
  good("curve heartline keep numbers");
  good("move @k3 to 131.5 20 -35");  // a crest
  const auto folds = SessionFindings(session).folds();
  ASSERT_GT(folds.size(), 0u);
  for (const char* name : {"a.csv", "a.nl2elem", "a.obj", "a.gltf", "a.svg"}) {
    const std::string path = (folder.path() / name).string();
    const base::Status status = exchange::save_track(files, path, session.document);
    EXPECT_EQ(status.code, base::Code::refused) << name;
    EXPECT_NE(status.message.find("the rails fold " + sim::fold_text(folds[0], 5)), std::string::npos)
        << status.message;
    EXPECT_FALSE(std::filesystem::exists(path)) << name;
  }
  EXPECT_TRUE(exchange::save_track(files, (folder.path() / "a.json").string(), session.document));
  refused("curve rails keep rails", "the rails fold at");
}

}  // namespace perform_curve_test
}  // namespace coaster::edit
