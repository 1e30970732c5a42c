#include "query/challenge_rules.h"

#include "base/scratch_folder.h"
#include "curve/continuity.h"
#include "edit/commands/commands_ride.h"
#include "edit/session_fixture.h"
#include "exchange/own/track_file.h"
#include "query/context.h"
#include "world/evaluation_settings.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

namespace coaster::query {
namespace challenge_rules_test {

namespace fs = std::filesystem;

class ChallengeTest : public test::SessionTest {
 protected:
  void SetUp() override { session.game.referee = referee(); }

  // A challenge file on a shipped track, with these members besides name and track.
  std::string file(const std::string& members, const std::string& track = "tracks/gentle.json") {
    const fs::path path = folder / "c.json";
    std::ofstream(path)
        << "{\"format\": \"coaster-challenge\", \"version\": 1, \"name\": \"N\", \"teaches\": \"T\", \"track\": \""
        << COASTER_SOURCE_DIR << "/" << track << "\", " << members << "}";
    return path.string();
  }
  base::Status begin(const std::string& members, const std::string& track = "tracks/gentle.json") {
    return apply(edit::StartChallenge{file(members, track)});
  }
  void refuse(const std::string& members, std::string_view part) {
    good("new");
    const world::Document before = session.document;
    const base::Status status = begin(members);
    EXPECT_EQ(status.code, base::Code::bad_file);
    EXPECT_NE(status.message.find(part), std::string::npos) << status.message;
    EXPECT_EQ(status.message.rfind(folder.string(), 0), 0u) << "the file comes first: " << status.message;
    EXPECT_FALSE(session.game.challenge);
    EXPECT_TRUE(session.document == before) << "nothing is opened";
  }
  double number(std::string_view name, std::string_view argument = {}) {
    return std::get<double>(*find_query(name)->evaluate({session, stats, "", ""}, argument));
  }

  test::ScratchFolder scratch;
  fs::path folder = scratch.path();
  FrameStats stats;
};

TEST_F(ChallengeTest, expressions_that_cannot_be_judged_are_refused_with_their_place) {
  refuse(R"("judged": "lap", "goals": [{"expect": "knotz <= 3", "text": "x"}])",
         "goals[0].expect:1: no query \"knotz\"");
  refuse(
      R"("judged": "lap", "goals": [{"expect": "knots <= 3", "text": "x"}], "gold": [{"expect": "knots =< 3", "text": "x"}])",
      "gold[0].expect:7: expected == !=");
  refuse(R"("judged": "lap", "goals": [{"expect": "knots <= many", "text": "x"}])",
         "goals[0].expect:10: expected a number, found \"many\"");
  refuse(R"("judged": "lap", "goals": [{"expect": "name < 3", "text": "x"}])", "goals[0].expect:6:");
  refuse(R"("judged": "lap", "goals": [{"expect": "fps >= 30", "text": "x"}])", "cannot be used in a rule");
  refuse(R"("judged": "lap", "goals": [{"expect": "challenge.met == 3", "text": "x"}])", "cannot be used in a rule");
  refuse(R"("judged": "lap", "goals": [{"expect": "\"knots", "text": "x"}])", "goals[0].expect");
  refuse(R"("judged": "lap", "goals": [{"expect": "", "text": "x"}])", "goals[0].expect: expected a text");
}

TEST_F(ChallengeTest, what_may_be_judged_depends_on_track_and_ride_alone) {
  // The same session with every number of the picture changed: no query that rules may ask has another value.
  ASSERT_TRUE(begin(R"("judged": "build", "goals": [{"expect": "knots <= 3", "text": "x"}])"));
  FrameStats other;
  other.frame = 77, other.uploads = 5, other.rebuilds = 3, other.upload_bytes = 1000, other.polyline_upload_bytes = 99,
  other.polyline_bytes = 12, other.drawn_by = curve::EvaluatedBy::geometry_shader;
  other.deviation = 3.25, other.deviation_pending = 2, other.recolours = 4, other.colour_low = -3,
  other.colour_high = 9, other.fps = 61, other.cpu_ms = 7, other.gl_ms = 8, other.gpu_ms = 9;
  other.evaluation_ms = 4.5, other.evaluated_vertices = 1200, other.draw_calls = 31, other.samples = 4,
  other.width = 640, other.height = 480;
  int judged = 0;
  for (const Query& query : queries()) {
    if (!may_judge(query)) continue;
    ++judged;
    const std::string usage = usage_of(query.argument);
    const std::string argument = usage == "@knot"      ? "@k2"
                                 : usage == "@segment" ? "@s3"
                                 : usage == "@cart"    ? "@c1"
                                                       : usage.substr(usage.rfind('|') + 1);
    const auto a = query.evaluate({session, stats, "", ""}, argument),
               b = query.evaluate({session, other, "a notice", "a title"}, argument);
    ASSERT_TRUE(a && b) << query.name;
    EXPECT_EQ(to_text(*a), to_text(*b)) << query.name;
    session.settings.evaluation->steps = 7;  // nor on how the curve is shown
    sim::derive(session.document, session.settings, {}, session.derived);
    EXPECT_EQ(to_text(*a), to_text(*query.evaluate({session, stats, "", ""}, argument))) << query.name;
    session.settings.evaluation->steps = 64;
    sim::derive(session.document, session.settings, {}, session.derived);
  }
  EXPECT_GT(judged, 50);
}

TEST_F(ChallengeTest, a_lap_is_judged_when_it_is_ridden_and_not_before) {
  ASSERT_TRUE(begin(
      R"("judged": "lap", "goals": [{"expect": "closed == on", "text": "x"}], "silver": [{"expect": "ride.speed_max > 5", "text": "x"}], "gold": [{"expect": "ride.speed_max > 500", "text": "x"}])"));
  EXPECT_EQ(session.game.challenge->judged, 0u);
  good("ride.start");
  edit::advance(session, 120);
  EXPECT_EQ(session.game.challenge->judged, 0u);
  edit::advance(session, 120 * 200);
  EXPECT_EQ(session.game.challenge->judged, 1u);
  EXPECT_EQ(session.game.challenge->medal, 2) << session.game.challenge->last.reason;
  // The lap ended at the tick after the train's return, for any number of ticks per call: the simulated ride's own lap
  // gives the time.
  ASSERT_TRUE(session.game.result);
  const double lap = edit::SessionFindings(session).ride()->lap_time;
  EXPECT_NEAR(session.game.result->seconds, lap, 2 * world::kTick);
  EXPECT_EQ(session.game.result->end, edit::RideEnd::lap);
  ASSERT_TRUE(exchange::find(session.game.earned, "c"));
  EXPECT_EQ(exchange::find(session.game.earned, "c")->medal, 2);
}

TEST_F(ChallengeTest, how_many_ticks_are_asked_for_at_once_changes_no_verdict) {
  const std::string members =
      R"("judged": "time", "seconds": 3.5, "goals": [{"expect": "ride.travelled > 0", "text": "x"}])";
  double at[2] = {};
  for (const int step : {1, 997}) {
    ASSERT_TRUE(begin(members));
    good("ride.start");
    for (int done = 0; done < 2000; done += step) edit::advance(session, step);
    ASSERT_EQ(session.game.challenge->medal, 3) << "without rules for silver and gold a pass is gold";
    ASSERT_EQ(session.game.result->end, edit::RideEnd::time);
    at[step == 1 ? 0 : 1] = session.game.challenge->last.values.at(0).value;
  }
  EXPECT_EQ(at[0], at[1]);
}

TEST_F(ChallengeTest, a_ride_on_a_track_that_was_changed_meanwhile_does_not_count) {
  const std::string members = R"("judged": "lap", "goals": [{"expect": "closed == on", "text": "x"}])";
  ASSERT_TRUE(begin(members));
  good("ride.start");
  edit::advance(session, 240);
  good("start_speed 4.5");
  edit::advance(session, 120 * 200);
  EXPECT_EQ(session.game.challenge->judged, 1u);
  EXPECT_EQ(session.game.challenge->medal, 0);
  EXPECT_NE(session.game.challenge->last.reason.find("changed"), std::string::npos);
  good("undo");
  EXPECT_TRUE(session.game.challenge) << "undo does not end a challenge";
  good("ride.stop");
  good("ride.start");
  good("ride.seek 200");
  edit::advance(session, 120 * 200);
  EXPECT_EQ(session.game.challenge->medal, 0) << "a train that was put elsewhere has not ridden";
  good("ride.stop");
  good("ride.start");
  good("ride.pause");
  good("ride.start");
  edit::advance(session, 120 * 200);
  EXPECT_EQ(session.game.challenge->medal, 3) << "a pause is no cheat: " << session.game.challenge->last.reason;
  good("start_speed 4.25");
  good("undo");
  EXPECT_EQ(session.game.challenge->medal, 3) << "what is earned stays";
}

TEST_F(ChallengeTest, what_is_built_is_judged_at_once_but_not_within_a_gesture) {
  ASSERT_TRUE(begin(R"("judged": "build", "goals": [{"expect": "knots <= 23", "text": "Fewer knots"}])"));
  good("gesture.begin");
  good("remove @k3");
  EXPECT_EQ(session.game.challenge->medal, 0);
  good("gesture.end");
  EXPECT_EQ(session.game.challenge->medal, 3);
  ASSERT_TRUE(begin(R"("judged": "build", "goals": [{"expect": "knots <= 22", "text": "Fewer knots"}])"));
  good("remove @k3");
  EXPECT_EQ(session.game.challenge->last.reason, "Fewer knots: you have 23; you need at most 22");
  good("challenge.leave");
  EXPECT_FALSE(session.game.challenge);
  EXPECT_EQ(apply("challenge.leave").code, base::Code::refused);
}

TEST_F(ChallengeTest, a_rule_is_explained_without_operators) {
  const std::pair<const char*, const char*> cases[] = {
      {"knots >= 99", "you have 24; you need at least 99"},
      {"knots < 3", "you have 24; you need less than 3"},
      {"knots > 30", "you have 24; you need more than 30"},
      {"knots == 12", "you have 24; you need exactly 12"},
      {"knots == 12 +-2", "you have 24; you need exactly 12 \u00B1 2"},
      {"knots != 24", "you have 24; you need anything but 24"},
      {"not knots >= 24", "you have 24; you need less than 24"},
      {"start_speed >= 500 m/s", "you have 4.00 m/s; you need at least 500 m/s"},
      {"closed == off", "this does not hold"},
      {"not closed", "this does not hold"},
      {"geometric @k99 >= G1", "no knot @k99; did you mean \"@k9\"?"}};
  for (const auto& [expect, words] : cases) {
    ASSERT_TRUE(begin(fmt::format(R"("judged": "build", "goals": [{{"expect": "{}", "text": "Goal"}}])", expect)));
    const auto rules = query::read_rules(session.game.challenge->file, "");
    ASSERT_TRUE(rules) << expect;
    EXPECT_EQ(query::explain(rules->front(), query::look_at(session, rules->front())), words) << expect;
  }
}

TEST_F(ChallengeTest, a_failing_goal_is_told_with_its_value_place_and_unit) {
  ASSERT_TRUE(begin(R"("judged": "lap", "goals": [{"expect": "ride.g_side_max <= 0.01", "text": "Lateral"}])",
                    "tracks/helix.json"));
  good("ride.start");
  edit::advance(session, 120 * 300);
  ASSERT_EQ(session.game.challenge->judged, 1u);
  // Against the simulated ride's raw forces, low-passed and searched here.
  const sim::SimulatedRide* const simulated = edit::SessionFindings(session).ride();
  const std::vector<float> side = sim::pressed(*simulated, 0, sim::ForceAxis::side, edit::force_limits(session).cutoff);
  const auto most = std::max_element(side.begin(), side.end());
  const double place = simulated->distance(static_cast<std::size_t>(most - side.begin()) * sim::kForceEvery);
  ASSERT_TRUE(session.game.challenge->last.place);
  EXPECT_NEAR(*session.game.challenge->last.place, place, 1e-9);
  char wanted[128];
  std::snprintf(wanted, sizeof wanted, "Lateral: you have %.2f g at %.1f m; you need at most 0.01 g", *most, place);
  EXPECT_EQ(session.game.challenge->last.reason, wanted);
}

TEST_F(ChallengeTest, a_weak_joint_is_told_with_its_place_and_the_step_that_riders_feel_there) {
  for (const char* expect : {"geometric_min >= G2", "geometric @k5 >= G2", "geometric k5 >= G2"}) {
    ASSERT_TRUE(begin(fmt::format(R"("judged": "build", "goals": [{{"expect": "{}", "text": "Smooth"}}])", expect)));
    good("lengths @k5 in 5 out 3");
    const std::vector<world::Entity>& segments = session.document.track.segments;
    std::vector<double> jumps;  // of curvature, at each knot
    std::size_t weakest = 0;    // the first one that is more than rounding
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const glm::dvec3 before = curve::curvature_vector(
                           world::cubic_of(session.document, segments[(i + segments.size() - 1) % segments.size()]), 1),
                       after = curve::curvature_vector(world::cubic_of(session.document, segments[i]), 0);
      jumps.push_back(glm::length(after - before));
      if (weakest == 0 && jumps.back() > 0.002 * glm::length(before)) weakest = i;
    }
    const std::size_t knot = std::string_view(expect).starts_with("geometric_min") ? weakest : 4;
    double fastest = 0;
    for (const sim::JointPassage& passage : edit::SessionFindings(session).ride()->passages)
      if (passage.knot == knot) fastest = std::max(fastest, std::abs(passage.speed));
    ASSERT_GT(jumps[knot], 1e-4);
    EXPECT_EQ(session.game.challenge->last.reason,
              fmt::format("Smooth: you have G1 (g-step {:.3f} g) at {:.1f} m; you need at least G2",
                          fastest * fastest * jumps[knot] / 9.81, session.derived.starts[knot]));
  }
}

TEST_F(ChallengeTest, overloads_are_told_with_the_sign_of_the_plots) {
  const auto told = [](sim::ForceAxis axis) {
    return fmt::format("{} {:.2f}", base::row_of(axis).label, sim::signed_g(axis, 1.5));
  };
  EXPECT_EQ(told(sim::ForceAxis::down), "Vertical 1.50");
  EXPECT_EQ(told(sim::ForceAxis::lift), "Vertical -1.50");
  EXPECT_EQ(told(sim::ForceAxis::side), "Lateral 1.50");
  EXPECT_EQ(told(sim::ForceAxis::forward), "Longitudinal 1.50");
  EXPECT_EQ(told(sim::ForceAxis::back), "Longitudinal -1.50");
}

TEST_F(ChallengeTest, a_train_that_is_too_slow_is_told_how_much_is_missing) {
  // Up a straight slope of 20 m from y = 4 with 12 m/s: it turns round at a height of v^2 / 2g over the start.
  good("new");
  good("append at 0 4 0"), good("append at 40 4 0"), good("append at 80 4 0"), good("append at 120 24 0"),
      good("append at 160 24 0");
  if (session.document.entities.pool<world::Train>().size() == 0) good("add_cart @s1 at 0");
  good("start_speed 12");
  good("ride.start");
  edit::advance(session, 120 * 60);
  ASSERT_TRUE(session.game.result);
  EXPECT_EQ(session.game.result->end, edit::RideEnd::failed);
  double highest = 0;  // over the flat parts, the spline may sag or swell by a little
  for (double s = 0; s < session.derived.length; s += 0.05) {
    const sim::TrackPlace place = sim::place_at(session.derived, s);
    highest =
        std::max(highest, sim::rail_point(session.derived.shape(session.derived.order[place.index]), place.s).height);
  }
  const double reached = 4 + 144 / (2 * 9.81), missing = highest - reached;
  char part[64];
  std::snprintf(part, sizeof part, "%.1f m below the top", missing);
  EXPECT_NE(session.game.result->reason.find(part), std::string::npos) << session.game.result->reason << " / " << part;
  std::snprintf(part, sizeof part, ": %.1f m/s more", std::sqrt(2 * 9.81 * missing));
  EXPECT_NE(session.game.result->reason.find(part), std::string::npos) << session.game.result->reason << " / " << part;
  EXPECT_EQ(session.notices.list.back().text, "Train c1 " + session.game.result->reason + ".") << "one distance";
  ASSERT_TRUE(session.game.result->place);
  const sim::TrackPlace turned = sim::place_at(session.derived, *session.game.result->place);
  EXPECT_NEAR(sim::rail_point(session.derived.shape(session.derived.order[turned.index]), turned.s).height, reached,
              0.02);
}

TEST_F(ChallengeTest, every_challenge_that_comes_with_the_program_can_be_judged) {
  for (const auto& entry : fs::directory_iterator(fs::path(COASTER_SOURCE_DIR) / "challenges")) {
    if (entry.path().extension() != ".json") continue;
    const base::Status begun = apply(edit::StartChallenge{entry.path().string()});
    ASSERT_TRUE(begun) << begun.message;
    const auto rules = read_rules(session.game.challenge->file, "");
    ASSERT_TRUE(rules) << rules.status().message;
    EXPECT_LT(number("challenge.met"), number("challenge.goals")) << entry.path() << " must fail on its start track";
  }
}

TEST_F(ChallengeTest, no_challenge_that_comes_with_the_program_is_passed_by_one_button) {
  for (const auto& entry : fs::directory_iterator(fs::path(COASTER_SOURCE_DIR) / "challenges")) {
    if (entry.path().extension() != ".json") continue;
    for (const char* button : {"auto_bank", "make_all_g2", "smooth all", "smooth all by uniform", "equalise all",
                               "straighten all", "drop all", "reverse", "auto_spin all", "joint all to smooth",
                               "joint all to automatic", "complete 1", "close"}) {
      ASSERT_TRUE(apply(edit::StartChallenge{entry.path().string()}).ok());
      (void)apply(button);  // some are refused on a closed track
      EXPECT_LT(number("challenge.met"), number("challenge.goals")) << entry.path().filename() << ": " << button;
    }
  }
}

TEST_F(ChallengeTest, a_locked_command_is_refused_until_the_challenge_is_left) {
  ASSERT_TRUE(begin(R"("judged": "build", "goals": [{"expect": "knots <= 3", "text": "x"}], "locks": ["equalise"])"));
  const world::Document before = session.document;
  const base::Status locked = apply("equalise all");
  EXPECT_EQ(locked.code, base::Code::refused);
  EXPECT_NE(locked.message.find("Locked in this challenge: Equalise handles"), std::string::npos) << locked.message;
  EXPECT_TRUE(session.document == before);
  EXPECT_TRUE(session.history.undo.empty());
  good("smooth all");
  good("challenge.leave");
  good("equalise all");
  refuse(R"("judged": "build", "goals": [{"expect": "knots <= 3", "text": "x"}], "locks": ["smooth", "equalize"])",
         "locks[1]: there is no command \"equalize\"");
}

TEST_F(ChallengeTest, another_track_ends_the_challenge_and_hints_come_one_by_one) {
  ASSERT_TRUE(begin(R"("judged": "build", "goals": [{"expect": "knots <= 3", "text": "x"}], "hints": ["a", "b"])"));
  good("challenge.hint");
  good("challenge.hint");
  EXPECT_EQ(number("challenge.hints"), 2);
  EXPECT_EQ(apply("challenge.hint").code, base::Code::refused);
  good("new");
  EXPECT_FALSE(session.game.challenge);
}

}  // namespace challenge_rules_test
}  // namespace coaster::query
