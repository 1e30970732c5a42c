// Commands of the park and of its ground.
#include "edit/commands/commands_park.h"
#include "edit/session/session.h"
#include "edit/session_fixture.h"
#include "exchange/own/share_link.h"
#include "sim/ground/brush.h"
#include "world/aid_settings.h"
#include "world/sections.h"

namespace coaster::edit {
namespace perform_park_test {

class ParkCommands : public test::SessionTest {
 protected:
  ParkCommands() : SessionTest(world::Document{}) {}
  const world::Park& park() const { return session.document.park; }
  double height(double x, double z) const { return sim::Land(park()).height(x, z); }
};

TEST_F(ParkCommands, a_land_comes_with_its_usual_water_and_woods_and_keeps_the_seed) {
  good("park hills");
  EXPECT_TRUE(park() == world::usual_park(world::Land::hills, 7));
  good("park.seed 42");
  good("park desert");
  EXPECT_TRUE(park() == world::usual_park(world::Land::desert, 42));
  good("park plain");
  EXPECT_TRUE(park() == world::Park()) << "without a land there is nothing else";
  good("undo"), good("undo"), good("undo");
  EXPECT_TRUE(park() == world::usual_park(world::Land::hills, 7));
}

TEST_F(ParkCommands, numbers_are_clamped_with_a_warning) {
  good("park hills");
  good("park.relief 1.5"), good("park.woods 0.25"), good("park.water 3");
  EXPECT_EQ(park().relief, 1.5);
  EXPECT_EQ(park().woods, 0.25);
  EXPECT_EQ(park().water, 3);
  good("park.water none");
  EXPECT_EQ(park().water, world::kNoWater);
  good("park.relief 9"), good("park.woods -1"), good("park.water 1000"), good("park.seed -3");
  EXPECT_EQ(park().relief, world::kMaxRelief);
  EXPECT_EQ(park().woods, 0);
  EXPECT_EQ(park().water, world::kHighestWater);
  EXPECT_EQ(park().seed, 0u);
  EXPECT_EQ(session.notices.list.back().kind, NoticeKind::warning);
  EXPECT_EQ(print(command("park.water none")), "park.water none");
  EXPECT_EQ(print(command("park.water -1.5")), "park.water -1.5");
}

// Ratings that a challenge asks for grow with tunnels.
TEST_F(ParkCommands, the_land_of_a_challenge_stays_as_it_is) {
  session.game.challenge.emplace();
  refused("park hills", "the land of a challenge stays as it is");
  EXPECT_TRUE(park().plain());
}

TEST_F(ParkCommands, strokes_need_a_land_and_a_place_in_it) {
  for (const char* const line :
       {"park.seed 3", "park.relief 2", "park.woods 1", "park.water 0", "park.reset", "ground.smooth at 0 0 radius 20",
        "ground.raise at 0 0 radius 20 by 3", "ground.flatten at 0 0 radius 20 to 3", "woods.reset at 0 0 radius 9",
        "ground.slope from 0 0 to 30 0 radius 5", "woods.paint at 0 0 radius 9 to 1"})
    refused(line, "there is no land: choose one first");
  good("park hills");
  refused("park.reset", "no brush has touched the land");
  refused("ground.raise at 769 0 radius 20 by 3", "up to 768 m from its middle");
  refused("ground.slope from 0 0 to 0 -800 radius 20", "up to 768 m from its middle");
  refused(Command{RaiseGround{{0, NAN}, 20, 3}}, "expected finite numbers");
  refused(Command{RaiseGround{{0, 0}, 20, INFINITY}}, "expected finite numbers");
  refused(Command{SetParkWater{{NAN}}}, "expected finite numbers");
}

TEST_F(ParkCommands, each_stroke_is_one_step_and_undo_takes_it_back) {
  good("park meadow");
  const double before = height(100, 100);
  const std::size_t steps = session.history.undo.size();
  good("ground.raise at 100 100 radius 20 by 5");
  EXPECT_NEAR(height(100, 100), before + 5, world::kHeightStep);
  good("ground.raise at 100 100 radius 20 by -2");
  EXPECT_NEAR(height(100, 100), before + 3, world::kHeightStep);
  good("ground.flatten at 100 100 radius 20 to 1.5");
  EXPECT_EQ(height(100, 100), 1.5);
  good("ground.smooth at 110 100 radius 20");
  good("ground.slope from 100 100 to 160 100 radius 8");
  good("woods.paint at 100 100 radius 20 to 0.5");
  EXPECT_EQ(park().tiles.find({1, 1})->woods[static_cast<std::size_t>(9 * 16 + 9)], 128);
  good("woods.reset at 100 100 radius 30");
  EXPECT_EQ(session.history.undo.size(), steps + 7);
  const world::Document all = session.document;
  for (int i = 0; i < 7; ++i) good("undo");
  EXPECT_EQ(height(100, 100), before);
  EXPECT_TRUE(park().tiles.empty());
  for (int i = 0; i < 7; ++i) good("redo");
  EXPECT_TRUE(session.document == all);
  good("park.reset");
  EXPECT_TRUE(park().tiles.empty());
}

TEST_F(ParkCommands, a_gesture_of_many_dabs_is_one_step_that_can_be_cancelled) {
  good("park meadow");
  const std::size_t steps = session.history.undo.size();
  good("gesture.begin");
  for (int i = 0; i < 9; ++i) good("ground.raise at 40 60 radius 20 by 0.3");
  good("gesture.end");
  EXPECT_EQ(session.history.undo.size(), steps + 1);
  const world::Document after = session.document;
  good("gesture.begin");
  good("ground.raise at 90 60 radius 20 by 0.3");
  good("gesture.cancel");
  EXPECT_TRUE(session.document == after);
  good("undo");
  EXPECT_TRUE(park().tiles.empty());
}

TEST_F(ParkCommands, a_brush_is_at_most_200_m_wide_and_moves_no_track) {
  good("element straight length 40");
  good("park meadow");
  const world::Knot knot = world::knot(session.document, session.document.track.knots[0]);
  good("ground.raise at 0 0 radius 1000 by 2");
  for (const auto& [place, tile] : park().tiles.map()) {
    EXPECT_LE(std::abs(place.x + 0.5), 4);
    EXPECT_LE(std::abs(place.z + 0.5), 4);
  }
  EXPECT_EQ(world::knot(session.document, session.document.track.knots[0]), knot);
}

TEST_F(ParkCommands, two_hundred_strokes_stay_within_the_memory_of_the_history) {
  good("park hills");
  for (int i = 0; i < 200; ++i)
    good("ground.raise at " + std::to_string(i % 20 * 60 - 580) + " " + std::to_string(i / 20 * 110 - 500) +
         " radius 200 by 1");
  EXPECT_EQ(session.history.undo.size(), 201u);
  EXPECT_LT(session.history.bytes, std::size_t{256} << 20);
  // Each step holds the tiles that it replaced, and the list of all: 50 tiles of 2.3 KB and 576 entries.
  EXPECT_GT(session.history.bytes, 200u * 20 * sizeof(world::GroundTile));
  std::size_t sum = 0;
  for (const HistoryStep& step : session.history.undo) sum += bytes_of(step);
  EXPECT_EQ(session.history.bytes, sum);
  for (int i = 0; i < 200; ++i) good("undo");
  EXPECT_TRUE(park().tiles.empty());
  sum = 0;
  for (const HistoryStep& step : session.history.redo) sum += bytes_of(step);
  for (const HistoryStep& step : session.history.undo) sum += bytes_of(step);
  EXPECT_EQ(session.history.bytes, sum);
}

TEST_F(ParkCommands, a_change_of_track_does_not_copy_the_land) {
  good("element straight length 40");
  good("park hills");
  good("ground.raise at 0 0 radius 200 by 1");
  const std::size_t before = session.history.bytes;
  good("move @k2 to 40 6 0");
  EXPECT_LT(session.history.bytes - before, 5000u);
}

TEST_F(ParkCommands, another_land_takes_strokes_away_and_says_so) {
  good("park hills");
  good("ground.raise at 0 0 radius 20 by 1");
  good("park.seed 9");
  EXPECT_FALSE(park().tiles.empty()) << "another seed keeps them";
  good("park snow");
  EXPECT_TRUE(park().tiles.empty());
  EXPECT_NE(session.notices.list.back().text.find("strokes"), std::string::npos);
}

TEST_F(ParkCommands, a_land_of_a_later_version_is_kept_until_another_is_chosen) {
  world::Document document;
  document.extra.json = R"({"park":{"land":"hills-9"},"more":1})";
  start_on(document);
  good("start_speed 3");
  EXPECT_NE(exchange::print_track(session.document).find("hills-9"), std::string::npos);
  good("park hills");
  const std::string text = exchange::print_track(session.document);
  EXPECT_EQ(text.find("hills-9"), std::string::npos);
  EXPECT_NE(text.find("\"more\": 1"), std::string::npos);
  const auto again = exchange::parse_track(text, "a.json");
  ASSERT_TRUE(again) << again.status().message;
  EXPECT_EQ(world::hash(again->document), world::hash(session.document));
}

TEST_F(ParkCommands, a_new_track_begins_plain_and_a_new_park_on_its_land) {
  good("new.park island seed 5");
  EXPECT_TRUE(park() == world::usual_park(world::Land::island, 5));
  EXPECT_TRUE(session.history.undo.empty());
  EXPECT_EQ(session.file.saved_hash, world::hash(session.document)) << "nothing to save yet";
  good("new.park snow");
  EXPECT_EQ(park().seed, 7u);
  good("new");
  EXPECT_TRUE(park() == world::Park());
}

TEST_F(ParkCommands, earthwork_is_set_for_sections_and_kept_in_files) {
  good("element straight length 40");
  good("element curve left radius 20 angle 90");
  EXPECT_EQ(exchange::version_of(session.document), 3);
  good("section.earthwork @q2 to tunnel");
  const auto earthwork = [&](const world::Document& document, std::uint32_t number) {
    return world::section(document, world::find(document, {world::EntityKind::section, number})).earthwork;
  };
  EXPECT_EQ(earthwork(session.document, 1), world::Earthwork::automatic);
  EXPECT_EQ(earthwork(session.document, 2), world::Earthwork::tunnel);
  good("section.change @q2 to curve left radius 30 angle 45");
  EXPECT_EQ(earthwork(session.document, 2), world::Earthwork::tunnel) << "planned again";
  const std::string text = exchange::print_track(session.document);
  EXPECT_NE(text.find("\"earthwork\": \"tunnel\""), std::string::npos);
  EXPECT_EQ(exchange::version_of(session.document), 4);
  const auto again = exchange::parse_track(text, "a.json");
  ASSERT_TRUE(again) << again.status().message;
  EXPECT_EQ(world::hash(again->document), world::hash(session.document));
  std::string wrong = text;
  wrong.replace(wrong.find("\"tunnel\""), 8, "\"bridge\"");
  const auto bad = exchange::parse_track(wrong, "a.json");
  ASSERT_FALSE(bad);
  EXPECT_NE(bad.status().message.find("sections[1].earthwork: expected \"automatic\", \"cut\", \"tunnel\" or \"none\""),
            std::string::npos)
      << bad.status().message;
  good("section.earthwork all to none");
  EXPECT_EQ(earthwork(session.document, 1), world::Earthwork::none);
}

TEST_F(ParkCommands, a_link_that_strokes_make_too_long_asks_for_a_file) {
  good("element straight length 40");
  good("park hills");
  good("share");
  for (int i = 0; i < 40; ++i)
    good("ground.raise at " + std::to_string(31 * i - 600) + " " + std::to_string(i * 7919 % 900 - 450) +
         " radius 60 by 7");
  refused("share", "Save the track and send the file");
}

}  // namespace perform_park_test
}  // namespace coaster::edit
