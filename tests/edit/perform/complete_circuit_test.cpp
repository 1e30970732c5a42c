// Circuits completed from random open tracks: joints, clearance, g and bounds are checked on the finished document, by
// other means than the planner's.
#include <cmath>
#include <cstdio>
#include <span>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/hash.h"
#include "base/tries.h"
#include "curve/continuity.h"
#include "edit/commands/commands_sections.h"
#include "edit/random_tracks.h"
#include "sim/shape/rails.h"
#include "sim/solids/coaster_form.h"
#include "sim/study/complete_circuit.h"
#include "sim/study/jolt.h"
#include "world/aid_settings.h"

namespace coaster::edit {
namespace perform_complete_circuit_test {

const double kTrainRadius = sim::form_of(world::CoasterKind::steel).train.radius,
             kTrackRadius = sim::form_of(world::CoasterKind::steel).track.radius,
             kTrainLift = sim::form_of(world::CoasterKind::steel).train.lift,
             kTrackDrop = -sim::form_of(world::CoasterKind::steel).track.lift;

using glm::dvec3;

// A point of the rails, at a distance along the track.
struct Sample {
  double s;
  dvec3 rails, up;
};

class CompleteCircuitTest : public test::RandomTracks {
 protected:
  // Every metre.
  std::vector<Sample> samples() const {
    std::vector<Sample> out;
    const sim::DerivedTrack& d = session.derived;
    for (double s = 0; s < d.length; s += 1.0) {
      const sim::TrackPlace place = sim::place_at(d, s);
      const sim::SegmentShape& shape = d.shape_at(place.index);
      out.push_back({s, sim::rails_at(shape, place.s), sim::frame_at(shape, place.s).up});
    }
    return out;
  }

  void check(std::size_t number);
};

// The rate of the frame's roll just before and after a joint, by differences of frames carried by the least rotation.
double roll_rate(const sim::SegmentShape& shape, double s) {
  constexpr double kStep = 1e-3;
  const curve::Frame a = sim::frame_at(shape, s), b = sim::frame_at(shape, s + kStep);
  const dvec3 carried = curve::least_rotation(a.forward, b.forward, a.up, a.up);
  return curve::signed_angle(carried, b.up, b.forward) / kStep;
}

// Every joint of the part from segment `old` on, both its ends included.
void expect_smooth(const sim::DerivedTrack& d, std::size_t old) {
  const std::size_t all = d.order.size();
  for (std::size_t i = old; i <= all; ++i) {
    const sim::SegmentShape &in = d.shape_at(i - 1), &out = d.shape_at(i % all);
    const curve::JointContinuity joint = curve::joint(in.key.cubic, out.key.cubic);
    EXPECT_EQ(joint.geometric, curve::GeometricContinuity::g2)
        << "segment " << i << " jumps by " << joint.curvature_jump;
    EXPECT_NEAR(roll_rate(in, in.arc.length() - 1.5e-3), roll_rate(out, 5e-4), 2e-3) << "segment " << i;
  }
}

// Its bends are no sharper than those of either end and of the planner.
void expect_gentle(const sim::DerivedTrack& d, std::size_t old) {
  double most = 1 / 6.5;
  for (const auto& [index, t] : {std::pair{old - 1, 1.0}, {std::size_t{0}, 0.0}})
    most = std::max(most, glm::length(curve::curvature_vector(d.shape_at(index).key.cubic, t)));
  for (std::size_t i = old; i < d.order.size(); ++i)
    for (int k = 0; k <= 32; ++k)
      EXPECT_LT(glm::length(curve::curvature_vector(d.shape_at(i).key.cubic, k / 32.0)), most + 2e-3);
}

// Brute force: the train's tube against the track's, of all pairs with a place behind `from`.
void expect_clear(const std::vector<Sample>& line, double from, double length) {
  const auto lift = [](const Sample& p, double by) { return p.rails + by * p.up; };
  for (const Sample& a : line) {
    if (a.s < from) continue;
    EXPECT_GT(a.rails.y, 0.9) << a.s;
    for (const Sample& b : line) {
      const double apart = std::abs(a.s - b.s);
      if (std::min(apart, length - apart) < sim::kSameStretch + 1 || glm::distance(a.rails, b.rails) > 4) continue;
      const double room = std::min(glm::distance(lift(a, kTrainLift), lift(b, -kTrackDrop)),
                                   glm::distance(lift(b, kTrainLift), lift(a, -kTrackDrop)));
      ASSERT_GT(room, kTrainRadius + kTrackRadius) << a.s << " and " << b.s;
    }
  }
}

// The simulated ride of the whole ride feels what was promised, on the new part alone.
void expect_felt(const sim::SimulatedRide& ride, double from, const sim::FeltRange& promised) {
  double most = 0, side = 0;
  for (std::size_t i = 0; i * sim::kForceEvery < ride.samples.size(); ++i) {
    const sim::RideSample& sample = ride.samples[i * sim::kForceEvery];
    if (ride.distance(i * sim::kForceEvery) < from + 1 || sample.travelled > ride.track_length - ride.start.front)
      continue;
    const sim::FeltAcceleration& f = ride.forces[i * static_cast<std::size_t>(ride.start.cars)];
    most = std::max(most, double{f.up}), side = std::max(side, std::abs(double{f.left}));
  }
  EXPECT_NEAR(most, promised.most, 0.25);
  EXPECT_LT(side, sim::kMostSide + 0.4);
}

// What jolts along the rails where the way begins is the element before it, if that bends too tightly for its speed.
void expect_no_jolts(std::span<const sim::Jolt> jolts, std::size_t old) {
  EXPECT_LT(jolts[old].left, 0.3) << "where the way begins";
  for (std::size_t i = old + 1; i <= jolts.size(); ++i)
    EXPECT_LT(jolts[i % jolts.size()].total, 0.5) << "knot " << i - old << " of the way";
}

// Places the proposal, checks the finished circuit, and undoes it.
void CompleteCircuitTest::check(std::size_t number) {
  const sim::CircuitProposal proposal = proposals().list[number - 1];
  const bool arrives = !proposals().assumed;
  const world::Document before = session.document;
  const std::size_t old = before.track.segments.size(), steps = session.history.undo.size();
  const double jolt = SessionFindings(session).closing_jolt(number - 1);
  const double from = session.derived.length,
               gap = static_cast<double>(glm::distance(world::knot(before, before.track.knots.back()).position,
                                                       world::knot(before, before.track.knots.front()).position));
  good(fmt::format("complete {}", number));
  ASSERT_TRUE(session.document.track.closed);
  EXPECT_EQ(session.history.undo.size(), steps + 1);
  const double length = session.derived.length;
  EXPECT_NEAR(length - from, proposal.plan.length, 0.05);
  EXPECT_GE(length - from, gap - 1e-3);
  EXPECT_LT(length - from, gap + 1200);
  expect_smooth(session.derived, old);
  expect_gentle(session.derived, old);
  expect_clear(samples(), from, length);
  EXPECT_TRUE(SessionFindings(session).conflicts().empty());
  const SessionFindings find(session);
  ASSERT_NE(find.ride(), nullptr);
  const std::span<const sim::Jolt> jolts = find.jolts();
  if (arrives) expect_felt(*find.ride(), from, proposal.felt);
  if (arrives) expect_no_jolts(jolts, old);
  double most = jolts.front().total;
  for (const sim::Jolt& at : jolts.subspan(std::min(old, jolts.size()))) most = std::max(most, at.total);
  EXPECT_DOUBLE_EQ(jolt, most) << "the proposal promises the jolt that the completed ride has";
  good("undo");
  ASSERT_TRUE(session.document == before);
}

TEST_F(CompleteCircuitTest, random_tracks_are_closed_smoothly_clear_and_within_what_riders_bear) {
  int tracks = 0, completed = 0, offers = 0, arrived = 0, gentle = 0;
  for (int seed = 1; seed <= test::tries(8); ++seed) {
    random_track(static_cast<std::uint32_t>(seed));
    ++tracks;
    const std::size_t count = proposals().list.size();
    if (count == 0) std::printf("track %d: %s\n", seed, proposals().refusal.c_str());
    completed += count > 0, offers += static_cast<int>(count), arrived += !proposals().assumed;
    for (const sim::CircuitProposal& closing : proposals().list) gentle += closing.felt.side <= sim::kGentleSide;
    for (std::size_t n = 1; n <= count; ++n) {
      SCOPED_TRACE(fmt::format("track {}, proposal {}", seed, n));
      check(n);
    }
  }
  std::printf("%d of %d tracks completed, %d proposals\n", completed, tracks, offers);
  EXPECT_GE(completed * 10, tracks * 8);
  EXPECT_GE(gentle * 10, offers * 9) << "rougher ones only where there are no others";
  EXPECT_GE(arrived, test::tries(3));  // the others are planned for the assumed speed
}

TEST_F(CompleteCircuitTest, proposals_differ_and_the_better_comes_first) {
  good("element straight length 30"), good("element curve right radius 25 angle 90");
  good("start_speed 14");
  const sim::CircuitProposals& found = proposals();
  ASSERT_EQ(found.list.size(), sim::kMostProposals);
  const auto cost = [](const sim::CircuitProposal& p) { return sim::cost_of(p.plan.length, p.felt); };
  EXPECT_LE(cost(found.list[0]), cost(found.list[1]));
  EXPECT_LE(cost(found.list[1]), cost(found.list[2]));
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = a + 1; b < 3; ++b) {
      double apart = 0;
      for (const sim::ElementPoint& p : found.list[a].plan.ideal.points) {
        double nearest = 1e9;
        for (const sim::ElementPoint& q : found.list[b].plan.ideal.points)
          nearest = std::min(nearest, glm::distance(p.position, q.position));
        apart = std::max(apart, nearest);
      }
      EXPECT_GT(apart, 3) << a << " and " << b;
    }
  good("complete 2");
  EXPECT_NE(session.notices.list.back().text.find("Completed the circuit: "), std::string::npos);
  // Portable to the bit: gcc and clang, debug and release.
  EXPECT_EQ(base::hex16(hash()), "07dea167adb3ff03");
}

TEST_F(CompleteCircuitTest, says_what_is_in_the_way) {
  refused("complete 1", "the track has no segment yet");
  good("append at 0 3 0"), good("append at 20 3 0");
  refused("complete 4", "expected a proposal from 1 to 3");
  refused("complete 0", "expected a proposal from 1 to 3");
  good("start_speed 0");
  // Without a speed no train reaches the open end; from 1 m/s it would come home with 1 m/s again.
  good("move @k1 to 0 33 0"), good("move @k2 to 20 33 0"), good("direct @k1,@k2 to 1 0 0"),
      good("element dive height 20");
  EXPECT_TRUE(proposals().assumed);
  good("start_speed 1");
  EXPECT_FALSE(proposals().assumed);
  refused("complete 1",
          "the train would reach the first knot, 20 m higher, at less than 2 m/s: climb by a lift, or add a launch");
  // Four metres before a straight that the train must not come near.
  start_on(world::Document{});
  for (const char* const at : {"0 5 0", "60 5 0", "90 5 60", "60 5 95", "30 5 70", "30 5 40", "30 5 4"})
    good(std::string("append at ") + at);
  refused("complete 1", "other track is in the way: closing sections come too close to it, most often at 30 m");
  good("closed on");
  refused("complete 1", "the track is closed");
}

}  // namespace perform_complete_circuit_test
}  // namespace coaster::edit
