// The train of openFVD moves on the rails, a heartline below the hearts. Here its law is integrated by another method,
// in other variables and far finer steps.

#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "exchange/fvd/fvd.h"
#include "exchange/fvd/fvd_writer.h"

namespace coaster::exchange {
namespace fvd_path_test {

using glm::dvec3;
using Real = long double;
using Vec = std::array<Real, 3>;

constexpr Real kDegree = 3.14159265358979323846264338327950288L / 180, kThere = 9.80665L;

Vec operator+(const Vec& a, const Vec& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vec operator*(Real k, const Vec& a) { return {k * a[0], k * a[1], k * a[2]}; }
Real dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec of(dvec3 v) { return {v.x, v.y, v.z}; }
Real apart(const Vec& a, dvec3 b) { return std::sqrt(dot(a + -1 * of(b), a + -1 * of(b))); }

// The state by time: hearts, direction, up, speed squared, metres of the rails, argument of the functions, heading and
// elevation (geometric sections) or angle turned (curved ones), metres of the hearts.
struct State {
  Vec hearts{}, forward{}, up{};
  Real square = 0, rails = 0, at = 0, heading = 0, elevation = 0, turned = 0, hearts_m = 0;
};
State moved(const State& a, const State& d, Real by) {
  return {a.hearts + by * d.hearts,    a.forward + by * d.forward,     a.up + by * d.up,
          a.square + by * d.square,    a.rails + by * d.rails,         a.at + by * d.at,
          a.heading + by * d.heading,  a.elevation + by * d.elevation, a.turned + by * d.turned,
          a.hearts_m + by * d.hearts_m};
}

// The law, by time.
class Law {
 public:
  Law(const FvdTrack& track, const FvdSection& section, const FvdStart& start)
      : t_(track), s_(section), from_{of(start.forward)}, up_{of(start.up)} {
    now.hearts = of(start.position), now.forward = from_, now.up = up_;
    now.square = s_.free_speed ? Real(start.speed) * start.speed : Real(s_.speed) * s_.speed;
    now.heading = std::atan2(-from_[0], -from_[2]), now.elevation = std::asin(from_[1]);
    join_pieces(s_.roll, s_.roll.front().start, 0);
    if (!s_.vertical.empty()) join_pieces(s_.vertical, s_.vertical.front().start, 0);
    if (!s_.lateral.empty()) join_pieces(s_.lateral, s_.lateral.front().start, 0);
  }

  State now;

  // Goes on to that many metres of the hearts.
  void go(Real hearts_m) {
    const int steps = 1 + static_cast<int>((hearts_m - now.hearts_m) / 0.01L);
    for (int i = 0; i < steps; ++i) {
      const Real by = (hearts_m - now.hearts_m) / (steps - i);
      const State a = rate(now), b = rate(moved(now, a, by / 2)), c = rate(moved(now, b, by / 2)),
                  d = rate(moved(now, c, by));
      now = moved(moved(moved(moved(now, a, by / 6), b, by / 3), c, by / 3), d, by / 6);
      if (s_.kind == FvdKind::curved && out_ < 0 && s_.lead_out > 0 &&
          now.turned >= (s_.angle - s_.lead_out) * kDegree - 1e-9L)
        out_ = now.rails, out_angle_ = s_.angle * kDegree - now.turned;
    }
  }

 private:
  Real value(const FvdFunction& f, const State& s) const { return value_of(piece_at(f, double(s.at)), double(s.at)); }

  // By metre of the hearts: the rates by time over their speed.
  State rate(const State& s) const {
    const Real v = std::sqrt(s.square), h = t_.heart;
    const Vec left = cross(s.up, s.forward);
    State d;
    Real upwards = 0, leftwards = 0, yaw = 0;  // rad/s of the direction
    const Real unit = s_.by_distance ? v : 1;
    if (s_.kind == FvdKind::forced) {
      const Real pull = (value(s_.vertical, s) - s.up[1]) * kThere;
      for (int i = 0; i < 60; ++i) upwards = pull / (v - h * upwards);
      leftwards = (value(s_.lateral, s) - left[1]) * kThere / v;
    } else if (s_.kind == FvdKind::geometric) {
      const Real pitch = value(s_.vertical, s) * unit * kDegree, turn = value(s_.lateral, s) * unit * kDegree;
      const Real sh = std::sin(s.heading), ch = std::cos(s.heading), se = std::sin(s.elevation),
                 ce = std::cos(s.elevation);
      const Vec by_time = pitch * Vec{sh * se, ce, ch * se} + turn * ce * Vec{-ch, 0, sh};
      upwards = dot(by_time, s.up), leftwards = dot(by_time, left);
      d.heading = turn, d.elevation = pitch;
    } else if (s_.kind == FvdKind::curved) {
      Real share = s_.lead_in > 0 ? std::min<Real>(s.rails / (1.997L * s_.radius * s_.lead_in * kDegree), 1) : 1;
      if (out_ >= 0) share = std::min(share, 1 - (s.rails - out_) / (1.997L * s_.radius * out_angle_));
      share = std::clamp<Real>(share, 0, 1);
      d.turned = v / s_.radius * share * share * (3 - 2 * share);
      const Real to = s_.direction * kDegree, bend = d.turned;
      const Vec side = std::cos(to) * up_ + std::sin(to) * cross(up_, from_);
      const Vec by_time = bend * (std::cos(s.turned) * side + -std::sin(s.turned) * from_);
      upwards = dot(by_time, s.up), leftwards = dot(by_time, left);
    }
    d.forward = upwards * s.up + leftwards * left;
    const Real level = s.forward[0] * s.forward[0] + s.forward[2] * s.forward[2];
    yaw = level > 1e-9L ? (s.forward[2] * d.forward[0] - s.forward[0] * d.forward[2]) / level : 0;
    Real roll = value(s_.roll, s) * kDegree;  // to the left
    if (s_.kind == FvdKind::forced || s_.kind == FvdKind::geometric) roll *= unit;
    if (s_.upright) roll -= s.forward[1] * yaw;
    d.up = -upwards * s.forward + roll * left;
    const Real hearts = v - h * upwards;
    d.hearts = hearts * s.forward, d.hearts_m = hearts;
    d.rails = std::sqrt(v * v + h * h * roll * roll);
    d.square =
        s_.free_speed
            ? -2 * (kThere * (d.hearts[1] - 0.9L * h * d.up[1] + t_.friction * d.rails) + t_.resistance * v * v * v)
            : 0;
    d.at = s_.kind == FvdKind::straight ? v
           : s_.kind == FvdKind::curved ? d.turned / kDegree
           : s_.by_distance             ? d.rails
                                        : 1;
    return moved(State{}, d, 1 / hearts);
  }

  FvdTrack t_;
  FvdSection s_;
  Vec from_, up_;
  Real out_ = -1, out_angle_ = 0;  // m of the rails and rad to go, where the lead-out begins
};

// Compares every point of the path.
void expect_law(const FvdTrack& track, const FvdSection& section, const FvdStart& start, double least_m) {
  FvdSection copy = section;
  const FvdPath path = fvd_path(track, copy, start);
  ASSERT_EQ(path.stopped, "");
  ASSERT_GT(path.curve.length(), least_m);
  Law law(track, section, start);
  for (std::size_t i = 0; i < path.curve.points.size(); ++i) {
    const sim::ElementPoint& p = path.curve.points[i];
    law.go(p.s);
    ASSERT_LT(apart(law.now.hearts, p.position), 0.004) << "at " << p.s;
    ASSERT_LT(apart(law.now.forward, p.tangent), 4e-4) << "at " << p.s;
    ASSERT_LT(apart(law.now.up, p.up), 4e-4) << "at " << p.s;
    ASSERT_NEAR(double(law.now.at), path.at[i], 1e-3 * std::max(1.0, path.at[i] / 10)) << "at " << p.s;
  }
  EXPECT_NEAR(double(std::sqrt(law.now.square)), path.speed, 1e-3);
}

class Chance {
 public:
  explicit Chance(unsigned seed) : engine_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_()) / static_cast<double>(std::mt19937::max()));
  }
  // Two or three smooth pieces over a length, between limits.
  FvdFunction function(double length, double low, double high, double first) {
    static constexpr FvdShape kShapes[] = {FvdShape::linear, FvdShape::cubic, FvdShape::sinusoidal, FvdShape::quintic};
    FvdFunction f;
    double at = 0, value = first;
    const int pieces = (*this)(0, 1) < 0.5 ? 2 : 3;
    for (int i = 0; i < pieces; ++i) {
      FvdPiece piece;
      piece.shape = kShapes[static_cast<int>((*this)(0, 3.999))];
      const double next = (*this)(low, high);
      piece.from = at, piece.to = length * (i + 1) / pieces, piece.start = value, piece.change = next - value;
      at = piece.to, value = next;
      f.push_back(piece);
    }
    return f;
  }

 private:
  std::mt19937 engine_;
};

FvdTrack track_with(double heart) {
  FvdTrack track;
  track.heart = heart, track.friction = 0.03, track.resistance = 2e-5;
  return track;
}

FvdStart start_of(Chance& chance) {
  FvdStart start;
  const double heading = chance(-3, 3), slope = chance(-0.5, 0.3), roll = chance(-0.6, 0.6);
  start.position = {3, 60, -4}, start.speed = chance(23, 27);
  start.forward = {-std::sin(heading) * std::cos(slope), std::sin(slope), -std::cos(heading) * std::cos(slope)};
  const dvec3 right = glm::normalize(glm::cross(start.forward, dvec3(0, 1, 0)));
  start.up = std::cos(roll) * glm::cross(right, start.forward) + std::sin(roll) * right;
  return start;
}

constexpr double kHearts[] = {-0.8, 0.3, 1.1, 1.5};

TEST(FvdPath, forced_sections_move_the_train_on_the_rails) {
  unsigned seed = 1;
  for (const double heart : kHearts)
    for (const bool by_distance : {false, true})
      for (const bool upright : {false, true}) {
        SCOPED_TRACE(testing::Message() << heart << (by_distance ? " by distance" : " by time") << upright);
        Chance chance(seed++);
        const double length = by_distance ? 60 : 2.8;
        FvdSection s;
        s.kind = FvdKind::forced, s.by_distance = by_distance, s.upright = upright;
        s.vertical = chance.function(length, 0.3, 2.2, 1), s.lateral = chance.function(length, -0.6, 0.6, 0);
        s.roll = by_distance ? chance.function(length, -3, 3, 1) : chance.function(length, -70, 70, 20);
        expect_law(track_with(heart), s, start_of(chance), 40);
      }
}

TEST(FvdPath, geometric_sections_move_the_train_on_the_rails) {
  unsigned seed = 100;
  for (const double heart : kHearts)
    for (const bool by_distance : {false, true})
      for (const bool keeps : {false, true}) {
        SCOPED_TRACE(testing::Message() << heart << (by_distance ? " by distance" : " by time") << keeps);
        Chance chance(seed++);
        const double length = by_distance ? 60 : 2.8, most = by_distance ? 2.2 : 45;
        FvdSection s;
        s.kind = FvdKind::geometric, s.by_distance = by_distance, s.free_speed = !keeps, s.speed = 22;
        s.upright = chance(0, 1) < 0.5;
        s.vertical = chance.function(length, -most / 3, most / 2, 5 / (by_distance ? 20.0 : 1));
        s.lateral = chance.function(length, -most, most, 0), s.roll = chance.function(length, -most, most, 0);
        expect_law(track_with(heart), s, start_of(chance), 40);
      }
}

// Through the vertical the elevation counts on, beyond 90 degrees, and so on around.
TEST(FvdPath, a_pitch_of_full_turns_makes_loops) {
  for (const double heart : {0.0, 1.1}) {
    FvdSection s;
    s.kind = FvdKind::geometric, s.free_speed = false, s.speed = 15;
    s.roll = {{FvdShape::linear, 0, 8, 0, 0}}, s.vertical = {{FvdShape::linear, 0, 8, 100, 0}},
    s.lateral = {{FvdShape::linear, 0, 8, 6, 0}};
    SCOPED_TRACE(heart);
    expect_law(track_with(heart), s, {}, 100);
  }
}

TEST(FvdPath, turns_and_straights_move_the_train_on_the_rails) {
  unsigned seed = 200;
  for (const double heart : kHearts)
    for (const double direction : {90.0, 0.0, 180.0, -40.0})
      for (const double lead : {0.0, 15.0}) {
        SCOPED_TRACE(testing::Message() << heart << " towards " << direction << ", lead " << lead);
        Chance chance(seed++);
        FvdSection s;
        s.kind = FvdKind::curved, s.angle = 70, s.radius = 22, s.direction = direction;
        s.lead_in = s.lead_out = lead, s.upright = chance(0, 1) < 0.3;
        s.roll = chance.function(70, -40, 40, 0);
        expect_law(track_with(heart), s, start_of(chance), 20);
        FvdSection run;
        run.roll = chance.function(60, -60, 60, 0);
        expect_law(track_with(heart), run, start_of(chance), 59.9);
      }
}

// 2 g at 20 m/s without losses, from golden data of another port of that program; the same without the rails would be
// 0.1, 0.7 and 1.4 m ahead.
TEST(FvdPath, a_turn_of_2_g_follows_the_other_programs_figures) {
  FvdTrack track = track_with(1.1);
  track.friction = track.resistance = 0;
  FvdSection s;
  s.kind = FvdKind::forced;
  s.roll = s.lateral = {{FvdShape::linear, 0, 2, 0, 0}}, s.vertical = {{FvdShape::linear, 0, 2, 2, 0}};
  FvdStart start;
  start.speed = 20;
  const FvdPath path = fvd_path(track, s, start);
  for (const auto& [seconds, x, y, speed] :
       {std::array{0.2, 3.8756, 0.1957, 19.9013}, std::array{1.0, 17.7253, 4.6665, 17.4802},
        std::array{1.6, 23.8861, 10.7671, 13.3559}}) {
    FvdSection part = s;
    for (FvdFunction* const f : {&part.roll, &part.vertical, &part.lateral}) f->back().to = seconds;
    const FvdPath to = fvd_path(track, part, start);
    const dvec3 end = to.curve.points.back().position;
    EXPECT_NEAR(-end.z, x, 0.01) << seconds;
    EXPECT_NEAR(end.y, y, 0.003) << seconds;
    EXPECT_NEAR(to.speed, speed, 0.002) << seconds;
  }
}

// Its own export has the hearts there; the train on the hearts would get to 14.898, 1.303.
TEST(FvdPath, a_second_of_growing_pitch_ends_where_the_other_program_exports_it) {
  FvdSection s;
  s.kind = FvdKind::geometric, s.free_speed = false, s.speed = 15;
  s.roll = s.lateral = {{FvdShape::linear, 0, 1, 0, 0}}, s.vertical = {{FvdShape::linear, 0, 1, 0, 30}};
  const FvdPath path = fvd_path(track_with(1.1), s, {});
  EXPECT_NEAR(-path.curve.points.back().position.z, 14.613, 0.003);
  EXPECT_NEAR(path.curve.points.back().position.y, 1.269, 0.005);
}

TEST(FvdPath, a_turn_tighter_than_the_heartline_ends_the_section) {
  FvdSection tight;
  tight.kind = FvdKind::curved, tight.roll = {{FvdShape::linear, 0, 90, 0, 0}};
  tight.angle = 90, tight.radius = 1.4, tight.lead_in = tight.lead_out = 20;
  FvdStart start;
  start.speed = 20;
  EXPECT_EQ(fvd_path(track_with(1.35), tight, start).stopped, "the turn is too tight for the heartline");
  EXPECT_EQ(fvd_path(track_with(0.5), tight, start).stopped, "");
  FvdSection pull;
  pull.kind = FvdKind::forced, pull.vertical = {{FvdShape::linear, 0, 2, 1, 9}};
  pull.roll = pull.lateral = {{FvdShape::linear, 0, 2, 0, 0}};
  start.speed = 9;
  EXPECT_EQ(fvd_path(track_with(1.1), pull, start).stopped, "the turn is too tight for the heartline");
}

}  // namespace fvd_path_test
}  // namespace coaster::exchange
