// Also tests fvd_file.h and fvd_path.h, which it uses. Only tracks without a heartline get force sections: those here
// have none unless a test gives them one.
#include "exchange/fvd/fvd.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/portable_math.h"
#include "exchange/formats.h"
#include "exchange/fvd/fvd_writer.h"
#include "world/sections.h"

namespace coaster::exchange {
namespace fvd_test {

using glm::dvec3;

constexpr double kDegree = M_PI / 180;

FvdFunction steady(double length, double value = 0) { return {{FvdShape::linear, 0, length, value, 0}}; }

FvdTrack track_of(std::vector<FvdSection> sections) {
  FvdTrack track;
  track.name = "Wild one", track.position = {3, 60, -4}, track.pitch = -20, track.yaw = 30, track.speed = 22;
  track.friction = 0.03, track.resistance = 2e-5, track.sections = std::move(sections);
  return track;
}

FvdSection forced(double seconds, FvdFunction vertical, FvdFunction lateral, FvdFunction roll) {
  FvdSection s;
  s.kind = FvdKind::forced, s.name = "Forces";
  s.vertical = std::move(vertical), s.lateral = std::move(lateral), s.roll = std::move(roll);
  for (FvdFunction* const f : {&s.vertical, &s.lateral, &s.roll})
    if (f->empty()) *f = steady(seconds);
  return s;
}

// What openFVD does a thousand times a second, with its own axes: the seat's right, and down. Turns by first order.
struct Thousandth {
  dvec3 position, forward, right;
  double speed, travelled = 0, lost = 0, height;

  explicit Thousandth(const FvdTrack& t)
      : position(t.position),
        forward(-std::sin(t.yaw * kDegree) * std::cos(t.pitch * kDegree), std::sin(t.pitch * kDegree),
                -std::cos(t.yaw * kDegree) * std::cos(t.pitch * kDegree)),
        right(std::cos(t.yaw * kDegree), 0, -std::sin(t.yaw * kDegree)),
        speed(t.speed),
        height(t.position.y) {
    start = speed * speed / 2;
  }
  double start;
  dvec3 down() const { return glm::cross(forward, right); }
  void turn(dvec3 axis, double angle) {
    const auto about = [&](dvec3 v) {
      return v * std::cos(angle) + glm::cross(axis, v) * std::sin(angle) +
             axis * (glm::dot(axis, v) * (1 - std::cos(angle)));
    };
    forward = glm::normalize(about(forward)), right = about(right);
    right = glm::normalize(right - glm::dot(right, forward) * forward);
  }
  void go(const FvdTrack& t, double seconds) {
    position += forward * speed * seconds, travelled += speed * seconds;
    lost += t.resistance * speed * speed * speed * seconds;
    speed = std::sqrt(2 * (start - lost - 9.81 * (position.y - height + t.friction * travelled)));
  }
};

// The forces of a section's functions, step by step.
void ride_forces(Thousandth& train, const FvdTrack& t, const FvdSection& s, double end) {
  for (double x = 0; x < end;) {
    const double by = s.by_distance ? train.speed / 1000 : 0.001;
    x += by;
    const double n = value_of(piece_at(s.vertical, x), x), l = value_of(piece_at(s.lateral, x), x);
    const dvec3 down = train.down(), push = -n * down - l * train.right - dvec3(0, 1, 0);
    const double heading = std::atan2(-train.forward.x, -train.forward.z);
    const double up = -glm::dot(push, down) * 9.81, left = -glm::dot(push, train.right) * 9.81;
    const dvec3 right = train.right;
    train.turn(right, up / train.speed / 1000), train.turn(-down, left / train.speed / 1000);
    double roll = value_of(piece_at(s.roll, x), x) * by * kDegree;  // to the left
    if (s.upright)
      roll -= train.forward.y * std::remainder(std::atan2(-train.forward.x, -train.forward.z) - heading, 2 * M_PI);
    train.turn(train.forward, -roll);
    train.go(t, 0.001);
  }
}

const world::Knot& last_knot(const world::Document& document) {
  return world::knot(document, document.track.knots.back());
}

void expect_there(const world::Document& document, const Thousandth& train, double metres, double degrees) {
  const world::Knot& end = last_knot(document);
  EXPECT_LT(glm::distance(dvec3(end.position), train.position), metres);
  EXPECT_LT(std::acos(std::min(1.0, glm::dot(dvec3(end.tangent), train.forward))) / kDegree, degrees);
  EXPECT_LT(std::acos(std::min(1.0, glm::dot(dvec3(end.up), -train.down()))) / kDegree, degrees);
}

LoadedTrack opened(const FvdTrack& track) {
  auto loaded = parse_fvd(test::fvd_of(track), "folder/ride.fvd");
  EXPECT_TRUE(loaded) << loaded.status().message;
  return loaded ? std::move(*loaded) : LoadedTrack{};
}

TEST(Fvd, forces_over_time_lead_where_the_other_program_goes) {
  // At the start riders feel the cosine of the slope, without curvature.
  const double felt = std::cos(20 * kDegree);
  const FvdSection s = forced(3.5,
                              {{FvdShape::cubic, 0, 1, felt, 3 - felt},
                               {FvdShape::sinusoidal, 1, 2.5, 3, -2.6},
                               {FvdShape::quintic, 2.5, 3.5, 0.4, 1}},
                              {{FvdShape::quartic, 0, 3.5, 0, 0.3, -10}}, {{FvdShape::plateau, 0, 3.5, 0, 14, 1}});
  const FvdTrack track = track_of({s});
  const LoadedTrack loaded = opened(track);
  EXPECT_TRUE(loaded.warnings.empty()) << loaded.warnings.front();
  EXPECT_EQ(loaded.note, "Opened 1 force section and 0 hand-shaped ones.");
  const world::Document& d = loaded.document;
  EXPECT_FALSE(world::broken_invariant(d));
  EXPECT_EQ(d.name, "Wild one");
  EXPECT_EQ(d.curve, world::TrackCurve::heartline);
  EXPECT_EQ(d.heartline, 0);
  EXPECT_EQ(d.start_speed, 22);
  EXPECT_EQ(d.resistance.rolling, 0.03f);
  const std::vector<world::SectionRun> runs = world::sections_of(d);
  ASSERT_EQ(runs.size(), 1u);
  const world::Section& section = world::section(d, runs[0].section);
  EXPECT_EQ(section.kind, world::SectionKind::force);
  EXPECT_EQ(section.title, "Forces");
  EXPECT_EQ(section.force.over, world::ForceDomain::time);
  EXPECT_EQ(section.force.keys(world::ForceChannel::vertical).front().value, static_cast<double>(float(felt)));
  Thousandth train(track);
  ride_forces(train, track, s, 3.5);
  EXPECT_GT(train.travelled, 60);
  expect_there(d, train, 0.15, 0.4);
}

TEST(Fvd, forces_over_distance_may_keep_the_roll_to_the_horizon) {
  FvdSection s = forced(60, {{FvdShape::cubic, 0, 30, std::cos(20 * kDegree), 1.5}, {FvdShape::linear, 30, 60, 0, 0}},
                        {{FvdShape::cubic, 0, 60, 0, 0.8}}, {});
  s.upright = s.by_distance = true;
  const FvdTrack track = track_of({s});
  const LoadedTrack loaded = opened(track);
  EXPECT_TRUE(loaded.warnings.empty()) << loaded.warnings.front();
  FvdSection joined = s;
  join_pieces(joined.vertical, joined.vertical.front().start, 60);
  Thousandth train(track);
  ride_forces(train, track, joined, 60);
  expect_there(loaded.document, train, 0.15, 0.4);
  const dvec3 right = glm::cross(dvec3(last_knot(loaded.document).tangent), dvec3(last_knot(loaded.document).up));
  EXPECT_NEAR(right.y, 0, 0.01) << "level, though the track turned while it sloped";
}

TEST(Fvd, straights_turns_and_pitch_become_hand_shaped_track) {
  FvdSection straight, turn, crest;
  straight.name = "Run", straight.roll = {{FvdShape::cubic, 0, 10, 0, 20}, {FvdShape::cubic, 10, 20, 20, -20}};
  turn.kind = FvdKind::curved, turn.roll = steady(90);
  turn.angle = 90, turn.radius = 25, turn.direction = 90, turn.lead_in = turn.lead_out = 20;
  crest.kind = FvdKind::geometric, crest.upright = true;
  crest.roll = steady(2), crest.lateral = steady(2), crest.vertical = {{FvdShape::quadratic, 0, 2, 0, 15}};
  FvdTrack track = track_of({straight, turn, crest});
  track.pitch = 0, track.yaw = 0;
  const LoadedTrack loaded = opened(track);
  EXPECT_TRUE(loaded.warnings.empty()) << loaded.warnings.front();
  const world::Document& d = loaded.document;
  const std::vector<world::SectionRun> runs = world::sections_of(d);
  ASSERT_EQ(runs.size(), 3u);
  const auto end_of = [&](std::size_t i) { return world::knot(d, d.track.knots[runs[i].end()]); };
  EXPECT_LT(glm::distance(dvec3(end_of(0).position), dvec3(3, 60, -24)), 0.01);
  EXPECT_EQ(world::section(d, runs[0].section).title, "Run");
  // Its roll: the area of 20 degrees per second and one 20 m at a speed that losses lower.
  const double angle = std::atan2(-end_of(0).up.x, end_of(0).up.y) / kDegree;
  EXPECT_NEAR(angle, 20 * 10 / 21.9, 0.1) << "to the left";
  // The turn is in the plane of its start: as steep as it is rolled, by 90 degrees in all.
  EXPECT_NEAR(glm::dot(dvec3(end_of(1).tangent), dvec3(0, 0, -1)), 0, 0.002);
  const dvec3 up(end_of(0).up);
  EXPECT_NEAR(glm::dot(dvec3(end_of(1).tangent), up), 0, 0.002) << "up is the axis";
  // Two lead-ins of 20 degrees, each 1.997 radii long, and a circle.
  const double lead = 1.997 * 25 * 20 * kDegree, arc = 25 * 50 * kDegree;
  double length = 0;
  FvdSection again = turn;
  length = fvd_path(track, again, {}).curve.length();
  EXPECT_NEAR(length, 2 * lead + arc, 0.1);
  // Pitch: a parabola of 15 degrees per second over 2 s, its area 20 degrees.
  const double before = std::asin(end_of(1).tangent.y), after = std::asin(end_of(2).tangent.y);
  EXPECT_NEAR((after - before) / kDegree, 20, 0.1);
}

TEST(Fvd, directions_are_those_of_the_other_program) {
  FvdSection any;
  any.roll = steady(10);
  FvdTrack track = track_of({any});
  track.pitch = track.yaw = 0, track.roll = 30;
  const dvec3 up(world::knot(opened(track).document, opened(track).document.track.knots[0]).up);
  EXPECT_LT(glm::distance(up, dvec3(-0.5, std::sqrt(0.75), 0)), 1e-6) << "rolled to the left";

  FvdSection turn;
  turn.kind = FvdKind::curved, turn.roll = steady(60), turn.angle = 60, turn.radius = 20;
  turn.lead_in = turn.lead_out = 10;
  const double half = 0.5, most = std::sqrt(0.75);
  FvdStart start;
  start.speed = 40;
  for (const auto& [direction, towards] : {std::pair{90.0, dvec3(-most, 0, -half)},
                                           {-90.0, dvec3(most, 0, -half)},
                                           {0.0, dvec3(0, most, -half)},
                                           {180.0, dvec3(0, -most, -half)}}) {
    turn.direction = direction;
    FvdSection copy = turn;
    EXPECT_LT(glm::distance(fvd_path(track, copy, start).curve.points.back().tangent, towards), 0.003) << direction;
  }

  FvdSection yaw;
  yaw.kind = FvdKind::geometric, yaw.upright = true;
  yaw.roll = yaw.vertical = steady(2), yaw.lateral = steady(2, 15);
  EXPECT_LT(glm::distance(fvd_path(track, yaw, {}).curve.points.back().tangent, dvec3(-half, 0, -most)), 0.003);
}

// The other program turns by the angle whatever the lead-out is: one of 0 is none, and any other ends where the angle
// is reached. Here leads are 1 m at least, within the angle.
TEST(Fvd, turns_with_short_leads_turn_by_their_angle_too) {
  FvdTrack track = track_of({});
  FvdStart start;
  start.speed = 40;
  for (const auto& [angle, radius, lead] : {std::tuple{90.0, 10.0, 0.0},
                                            {90.0, 10.0, 2.0},
                                            {30.0, 4.0, 0.0},
                                            {5.0, 20.0, 0.0},
                                            {1.0, 10.0, 0.0},
                                            {360.0, 7.0, 0.1}}) {
    FvdSection turn;
    turn.kind = FvdKind::curved, turn.roll = steady(angle);
    turn.angle = angle, turn.radius = radius, turn.direction = 90, turn.lead_in = turn.lead_out = lead;
    const FvdPath path = fvd_path(track, turn, start);
    const dvec3 end = path.curve.points.back().tangent;
    EXPECT_NEAR(std::remainder(std::atan2(-end.x, -end.z) / kDegree - angle, 360), 0, 0.3) << angle << ", " << radius;
  }
  FvdSection none;
  none.kind = FvdKind::curved, none.roll = steady(0), none.radius = 10, none.direction = 90;
  EXPECT_EQ(fvd_path(track, none, start).curve.points.size(), 1u);
}

TEST(Fvd, short_sections_end_no_track) {
  FvdSection first, zero, tiny, small, force, rest;
  first.roll = steady(12), zero.roll = steady(0), tiny.roll = steady(0.03), small.roll = steady(0.3);
  rest.roll = steady(9);
  force.kind = FvdKind::forced, force.by_distance = true;
  force.roll = force.lateral = steady(1.7), force.vertical = steady(1.7, 1);  // 3 m at least as a force section
  FvdTrack track = track_of({first, zero, small, tiny, force, rest});
  track.pitch = track.yaw = track.roll = 0;
  const LoadedTrack loaded = opened(track);
  ASSERT_EQ(loaded.warnings.size(), 1u);
  EXPECT_NE(loaded.warnings[0].find("sections shorter than 0.05 m were left out: 1"), std::string::npos);
  const std::vector<world::SectionRun> runs = world::sections_of(loaded.document);
  ASSERT_EQ(runs.size(), 4u);
  for (const world::SectionRun& run : runs)
    EXPECT_EQ(world::section(loaded.document, run.section).kind, world::SectionKind::free);
  // 1 g on the level is a straight.
  EXPECT_LT(
      glm::distance(dvec3(last_knot(loaded.document).position), track.position + dvec3(0, 0, -12 - 0.3 - 1.7 - 9)),
      0.01);
}

// The other program lets only functions of forced and geometric sections be locked, and takes the length of straights
// and curves from the last piece.
TEST(Fvd, locked_functions_leave_straights_their_length_and_are_refused_without_any_end) {
  FvdSection straight;
  straight.roll = steady(20), straight.roll.back().follows = true;
  EXPECT_NEAR(fvd_path(track_of({}), straight, {}).curve.length(), 20, 1e-3);
  FvdSection force;
  force.kind = FvdKind::forced;
  force.roll = force.lateral = steady(2), force.vertical = steady(2, 1);
  force.roll.back().follows = force.lateral.back().follows = true;
  EXPECT_EQ(fvd_path(track_of({}), force, {}).stopped, "");
  force = {};
  force.kind = FvdKind::forced;
  force.roll = force.lateral = steady(2), force.vertical = steady(2, 1);
  for (FvdFunction* const f : {&force.roll, &force.lateral, &force.vertical}) f->back().follows = true;
  EXPECT_EQ(fvd_path(track_of({}), force, {}).stopped, "all of its functions are locked to the end of another");
}

TEST(Fvd, drag_slows_by_its_exponential) {
  FvdSection run;
  run.roll = steady(100);
  FvdTrack track = track_of({});
  track.friction = 0, track.resistance = 0.004;
  FvdStart start;
  start.speed = 20;
  EXPECT_NEAR(fvd_path(track, run, start).speed, 20 * std::exp(-0.4), 0.01);
}

// On a climbing turn the horizon itself turns about the track.
TEST(Fvd, a_levelling_piece_ends_level) {
  for (const bool upright : {false, true}) {
    FvdSection s = forced(2.5, steady(2.5, 1.3), steady(2.5, 0.7),
                          {{FvdShape::cubic, 0, 0.5, 0, 25}, {FvdShape::to_zero, 0.5, 2.5, 25}});
    s.upright = upright;
    FvdStart start;
    start.speed = 25, start.forward = glm::normalize(dvec3(0, 0.6, -1)), start.up = glm::normalize(dvec3(0, 1, 0.6));
    const FvdPath path = fvd_path(track_of({}), s, start);
    ASSERT_EQ(path.stopped, "");
    const sim::ElementPoint &end = path.curve.points.back(), &middle = path.curve.points[path.curve.points.size() / 3];
    EXPECT_GT(std::abs(glm::cross(middle.tangent, middle.up).y), 0.1) << "it leans before";
    EXPECT_NEAR(glm::cross(end.tangent, end.up).y, 0, 0.01) << upright;
    for (std::size_t i = 1; path.at[i] < 0.7; ++i)
      EXPECT_NEAR(path.twist[i], path.twist[i - 1], 3) << path.at[i] << ": no jump of the roll's rate";
  }
}

TEST(Fvd, a_section_that_keeps_its_speed_gets_a_lift_or_a_brake) {
  FvdSection lift, brake;
  lift.roll = brake.roll = steady(30);
  lift.free_speed = brake.free_speed = false, lift.speed = 25, brake.speed = 4;
  const LoadedTrack loaded = opened(track_of({lift, brake}));
  const world::Document& d = loaded.document;
  const auto kind = [&](std::size_t section) {
    return d.entities.get<world::Equipment>(d.track.segments[world::sections_of(d)[section].first]);
  };
  EXPECT_EQ(kind(0).kind, world::EquipmentKind::lift);
  EXPECT_EQ(kind(0).speed, 25);
  EXPECT_EQ(kind(1).kind, world::EquipmentKind::brake);
  EXPECT_EQ(kind(1).speed, 4);
}

TEST(Fvd, what_cannot_be_read_ends_the_track_with_a_reason) {
  FvdSection straight, bezier, free_form;
  straight.roll = steady(20), bezier.kind = FvdKind::bezier, bezier.name = "Fitted";
  free_form = straight, free_form.roll[0].shape = FvdShape::free_form;
  const LoadedTrack first = opened(track_of({straight, bezier, straight}));
  ASSERT_EQ(first.warnings.size(), 1u);
  EXPECT_EQ(first.warnings[0],
            "folder/ride.fvd: warning: section 2 of 3 (Fitted): Bezier sections are not read; the track ends there");
  EXPECT_EQ(world::sections_of(first.document).size(), 1u);
  EXPECT_NE(opened(track_of({straight, free_form})).warnings.at(0).find("free-form"), std::string::npos);
  // A climb that no train gets over.
  FvdTrack steep = track_of({straight});
  steep.pitch = 80, steep.speed = 5, steep.sections[0].roll = steady(100);
  const LoadedTrack stopped = opened(steep);
  EXPECT_NE(stopped.warnings.at(0).find("falls below 1 m/s"), std::string::npos) << stopped.warnings[0];
  EXPECT_FALSE(stopped.document.track.segments.empty()) << "up to there";
  test::FvdWriter two;
  two.track(track_of({straight})), two.track(track_of({}));
  const auto both = parse_fvd(two.done(), "a.fvd");
  ASSERT_TRUE(both);
  EXPECT_EQ(both->warnings.at(0), "a.fvd: warning: only the first of the 2 tracks is read");
}

TEST(Fvd, a_file_without_any_track_is_refused_with_the_reason) {
  FvdSection slow, tiny, straight, bezier;
  slow.roll = straight.roll = steady(20), slow.name = "Crawl", slow.free_speed = false, slow.speed = 0.5;
  tiny.roll = steady(0.02), bezier.kind = FvdKind::bezier, bezier.name = "Fitted";
  const auto refusal = [](const FvdTrack& track) {
    const auto loaded = parse_fvd(test::fvd_of(track), "a.fvd");
    EXPECT_FALSE(loaded);
    EXPECT_EQ(loaded.status().code, base::Code::bad_file);
    return loaded.status().message;
  };
  EXPECT_EQ(refusal(track_of({slow, straight})), "a.fvd: error: section 1 of 2 (Crawl): it keeps a speed of 0.5 m/s");
  EXPECT_EQ(refusal(track_of({tiny, bezier})), "a.fvd: error: section 2 of 2 (Fitted): Bezier sections are not read");
  EXPECT_EQ(refusal(track_of({})), "a.fvd: error: track 1 (Wild one) has no section");
  EXPECT_EQ(refusal(track_of({tiny, tiny})), "a.fvd: error: track 1 (Wild one) has no section of 0.05 m or more");
  FvdTrack stands = track_of({straight});
  stands.speed = 0;
  EXPECT_EQ(refusal(stands), "a.fvd: error: section 1 of 1 (): the train falls below 1 m/s");
}

// What openFVD shows, a heartline above rails on which its train moves: what the knots keep, through a file of ours.
TEST(Fvd, with_a_heartline_sections_keep_their_place) {
  const auto pull = [](bool by_distance) {
    const double length = by_distance ? 45 : 2.2;
    FvdSection s = forced(
        length, {{FvdShape::cubic, 0, length / 2, 1, 1.6}, {FvdShape::cubic, length / 2, length, 2.6, -2}},
        {{FvdShape::quartic, 0, length, 0, 0.4, -10}}, {{FvdShape::plateau, 0, length, 0, by_distance ? 1.5 : 35, 1}});
    s.by_distance = by_distance;
    return s;
  };
  FvdSection straight, turn;
  straight.roll = steady(8), turn.kind = FvdKind::curved, turn.roll = steady(60);
  turn.angle = 60, turn.radius = 20, turn.direction = 60, turn.lead_in = turn.lead_out = 10;
  FvdTrack track = track_of({pull(false), straight, turn, pull(true)});
  track.heart = 1.2;
  const LoadedTrack loaded = opened(track);
  EXPECT_TRUE(loaded.warnings.empty()) << loaded.warnings.front();
  EXPECT_EQ(
      loaded.note,
      "Opened 0 force sections and 4 hand-shaped ones. Forced sections keep their shape: with a heartline openFVD "
      "moves the train on the rails. Read forces makes force sections of them.");
  const world::Document& d = loaded.document;
  EXPECT_EQ(d.heartline, 1.2f);
  const std::vector<world::SectionRun> runs = world::sections_of(d);
  ASSERT_EQ(runs.size(), 4u);
  FvdStart start;
  const world::Knot& first = world::knot(d, d.track.knots[0]);
  start.position = first.position, start.forward = first.tangent, start.up = first.up, start.speed = track.speed;
  for (std::size_t i = 0; i < 4; ++i) {
    FvdSection section = track.sections[i];
    for (FvdFunction* const f : {&section.roll, &section.vertical, &section.lateral})
      for (FvdPiece& piece : *f)
        piece.change = float(piece.change), piece.from = float(piece.from), piece.to = float(piece.to),
        piece.form = float(piece.form);
    FvdTrack there = track;
    there.heart = float(1.2), there.friction = float(0.03), there.resistance = float(2e-5);
    const FvdPath path = fvd_path(there, section, start);
    const sim::ElementPoint& end = path.curve.points.back();
    const world::Knot& knot = world::knot(d, d.track.knots[runs[i].end()]);
    EXPECT_LT(glm::distance(dvec3(knot.position), end.position), 0.003 * double(i + 1)) << i;
    EXPECT_LT(glm::distance(dvec3(knot.up), end.up), 0.002) << i;
    start = {end.position, end.tangent, end.up, path.speed};
  }
}

TEST(Fvd, a_broken_file_is_refused_at_its_byte) {
  const std::string good = test::fvd_of(track_of({forced(2, {}, {}, {})}));
  for (std::size_t size = 0; size < good.size(); ++size) {
    const auto loaded = parse_fvd(std::string_view(good).substr(0, size), "a.fvd");
    ASSERT_FALSE(loaded) << size;
    EXPECT_EQ(loaded.status().code, base::Code::bad_file);
    EXPECT_NE(loaded.status().message.find("a.fvd: error: at byte "), std::string::npos) << loaded.status().message;
  }
  const auto refused = [](std::string bytes, const std::string& part) {
    const auto loaded = parse_fvd(bytes, "a.fvd");
    ASSERT_FALSE(loaded);
    EXPECT_NE(loaded.status().message.find(part), std::string::npos) << loaded.status().message;
  };
  refused(test::FvdWriter("v9.99").done(), "expected version v0.77 or v0.30, found \"v9.99\"");
  refused(test::FvdWriter().done(), "the project has no track");
  FvdTrack odd = track_of({forced(2, {}, {}, {})});
  odd.speed = NAN;
  refused(test::fvd_of(odd), "expected the start speed from -1000 to 1000, found no finite number");
  FvdSection backwards = forced(2, {{FvdShape::linear, 2, 1, 1, 0}}, {}, {});
  refused(test::fvd_of(track_of({backwards})), "a piece ends at 1, before its start at 2");
  std::string many = good;
  const std::size_t count = many.find("FUNC") + 4;
  many.replace(count, 4, "\x7f\xff\xff\xff");
  refused(many, "expected at most 500 pieces, found 2147483647");
}

TEST(Fvd, the_older_version_has_no_speed_in_forced_sections) {
  std::string older = test::fvd_of(track_of({forced(2, steady(2, 1), {}, {})}));
  older.replace(3, 5, "v0.30");
  const std::size_t tag = older.find("FRC");
  older.erase(tag + 3 + 1 + 4 + 6, 4);  // flag, the name "Forces"
  const auto loaded = parse_fvd(older, "a.fvd");
  ASSERT_TRUE(loaded) << loaded.status().message;
  EXPECT_EQ(world::sections_of(loaded->document).size(), 1u);
}

}  // namespace fvd_test
}  // namespace coaster::exchange
