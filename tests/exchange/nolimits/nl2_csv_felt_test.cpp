// What riders feel on tracks imported from rows, against the curves that the rows were taken from, at equal speeds.
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <iostream>
#include <random>
#include <sstream>
#include <tuple>

#include <fmt/format.h>

#include "base/tries.h"
#include "exchange/nolimits/nl2_csv.h"
#include "exchange/nolimits/nl2_header.h"
#include "exchange/nolimits/nl2_spline.h"
#include "sim/shape/rail_tables.h"
#include "sim/study/force_limits.h"
#include "sim/study/jolt.h"
#include "world/motion.h"

namespace coaster::exchange {
namespace nl2_csv_felt_test {

using glm::dvec3;

constexpr double kRate = 100;  // samples per second of a ride
constexpr double kTop = 4;     // m/s over the highest place, without losses

// A moment of a ride: the rails, squared speed over g (m), and felt g upwards and to the left.
struct Moment {
  dvec3 place{0}, forward{0};
  double v2 = 0;
  glm::vec2 felt{0};
};

// A document's rails, and what riders `heart` m above them feel there.
struct RiddenTrain {
  RiddenTrain(const world::Document& document, double heart) : derived(sim::shapes_of(document)) {
    tables.update(derived, heart);
  }
  glm::vec2 felt(double s, double slope, double v2) {
    const double at = tables.locate(s, hint);
    const glm::vec3 g = sim::felt_at(tables.segment(hint), at, static_cast<float>(-slope), static_cast<float>(v2));
    return {g.z, g.y};
  }
  sim::DerivedTrack derived;
  sim::RailTables tables;
  std::size_t hint = 0;
};

double v2_at(double top, double height) { return kTop * kTop / world::kGravity + 2 * (top - height); }

std::vector<Moment> ride_on(const world::Document& document, double heart) {
  RiddenTrain track(document, heart);
  double top = -1e9;
  for (double s = 0; s < track.derived.length; s += 0.5) top = std::max(top, place_on(track.derived, s).position.y);
  std::vector<Moment> ride;
  for (double s = 0; s < track.derived.length;) {
    const PlaceOnTrack at = place_on(track.derived, s);
    const double v2 = v2_at(top + 0.1, at.position.y);
    ride.push_back({at.position, at.frame.forward, v2, track.felt(s, at.frame.forward.y, v2)});
    s += std::sqrt(v2 * world::kGravity) / kRate;
  }
  return ride;
}

struct Wrong {
  double rms = 0, most = 0;  // g, of both axes, after a low-pass of 5 Hz
};

// Rides on the document with the speeds of the known ride at the corresponding positions.
Wrong wrong_on(const world::Document& document, double heart, const std::vector<Moment>& ride) {
  RiddenTrain track(document, heart);
  std::array<std::vector<float>, 4> g;
  double s = 0;
  for (const Moment& known : ride) {
    for (int i = 0; i < 3; ++i) {
      const PlaceOnTrack at = place_on(track.derived, s);
      s = std::clamp(s + glm::dot(known.place - at.position, at.frame.forward), 0.0, track.derived.length);
    }
    const glm::vec2 felt = track.felt(s, known.forward.y, known.v2);
    for (int axis = 0; axis < 2; ++axis) g[axis].push_back(known.felt[axis]), g[axis + 2].push_back(felt[axis]);
  }
  Wrong wrong;
  for (std::vector<float>& values : g) sim::low_pass(values, kRate, 5);
  for (int axis = 0; axis < 2; ++axis) {
    double sum = 0;
    for (std::size_t i = 0; i < ride.size(); ++i) {
      const double off = g[axis + 2][i] - g[axis][i];
      sum += off * off, wrong.most = std::max(wrong.most, std::abs(off));
    }
    wrong.rms = std::max(wrong.rms, std::sqrt(sum / static_cast<double>(ride.size())));
  }
  return wrong;
}

// Returns rows about `spacing` m apart from rows 0.05 m apart, each step up to a fifth longer or shorter, renumbered.
std::string thinned(const std::string& text, double spacing, std::uint32_t seed) {
  std::istringstream in(text);
  std::string kept, line;
  std::getline(in, line);
  kept = line + "\n";
  std::mt19937 bits(seed);
  std::size_t row = 0, next = 0, number = 0;
  for (; std::getline(in, line); ++row) {
    if (row < next) continue;
    kept += std::to_string(++number) + line.substr(line.find('\t')) + "\n";
    const double share = 0.8 + 0.4 * (bits() / 4294967296.0);
    next = row + std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(share * spacing / kNl2Spacing)));
  }
  return kept;
}

// A place on a curve in closed form, and the metres of track per unit of its parameter.
struct Place {
  dvec3 place{0}, forward{0}, up{0};
  double metres = 1;
};

// Rows about `spacing` m apart, each step by up to a fifth longer or shorter, to just beyond x = length.
template <class Curve>
std::string rows_on(Curve curve, double length, double spacing, std::uint32_t seed) {
  std::string rows(test::kNl2Header);
  std::mt19937 bits(seed);
  int number = 0;
  for (double x = 0; x < length + spacing;) {
    const Place at = curve(x);
    rows += std::to_string(++number);
    for (const dvec3 v : {at.place, at.forward, glm::cross(at.up, at.forward), at.up})
      rows += fmt::format("\t{:.6f}\t{:.6f}\t{:.6f}", v.x, v.y, v.z);
    rows += "\n";
    x += spacing * (0.8 + 0.4 * (bits() / 4294967296.0)) / at.metres;
  }
  return rows;
}

void expect_felt(const std::string& rows, const std::vector<Moment>& ride, double heart, double most_knots = 1e9) {
  const auto loaded = parse_nl2_csv(rows, "t.csv");
  ASSERT_TRUE(loaded.ok()) << loaded.status().message;
  EXPECT_LE(loaded->import->max_error, 0.01);
  EXPECT_LE(loaded->import->frame_error, 0.5);
  EXPECT_LE(loaded->import->knots, most_knots);
  const Wrong wrong = wrong_on(loaded->document, heart, ride);
  EXPECT_LE(wrong.rms, 0.1);
  EXPECT_LE(wrong.most, 0.4);
}

world::Document sample_track(const std::string& name) {
  std::ifstream in(std::string(COASTER_SOURCE_DIR) + "/tracks/" + name + ".json");
  std::ostringstream file;
  file << in.rdbuf();
  return parse_track(file.str(), name)->document;
}
constexpr const char* kSamples[] = {"gentle", "helix", "kingfisher", "loop", "old_timber"};

TEST(nl2_csv_felt, imported_samples_are_felt_as_the_originals_at_any_spacing_of_rows) {
  int number = 0;
  for (const char* name : kSamples) {
    const world::Document sample = sample_track(name);
    const std::string text = print_nl2_csv(sample, kNl2Spacing);
    const double heart = sample.heartline;
    const std::vector<Moment> ride = ride_on(sample, heart);
    for (const auto& [spacing, seed] :
         {std::pair(0.05, 7u), {0.5, 7u}, {1.0, 7u}, {2.0, 7u}, {3.0, 7u}, {5.0, 2u}, {5.0, 7u}, {5.0, 12u}}) {
      if (test::kSanitized && ++number % 4 != 0) continue;
      SCOPED_TRACE(fmt::format("{}, rows every {} m, seed {}", name, spacing, seed));
      expect_felt(thinned(text, spacing, seed), ride, heart);
    }
  }
}

// Prints the table of docs/track-format.md.
TEST(nl2_csv_felt, DISABLED_table_of_the_samples) {
  for (const double spacing : {0.05, 0.5, 1.0, 2.0, 3.0, 4.0, 5.0}) {
    int knots = 0;
    Wrong rails, riders;
    for (const char* name : kSamples) {
      const world::Document sample = sample_track(name);
      const std::string text = print_nl2_csv(sample, kNl2Spacing);
      const std::vector<Moment> on_rails = ride_on(sample, 0), above = ride_on(sample, sample.heartline);
      for (std::uint32_t seed = 1; seed <= (spacing < 0.1 ? 1 : 5); ++seed) {
        const auto loaded = parse_nl2_csv(thinned(text, spacing, seed), name);
        ASSERT_TRUE(loaded.ok()) << loaded.status().message;
        if (seed == 1) knots += loaded->import->knots;
        const auto worst = [&](Wrong& of, double heart, const std::vector<Moment>& ride) {
          const Wrong wrong = wrong_on(loaded->document, heart, ride);
          of = {std::max(of.rms, wrong.rms), std::max(of.most, wrong.most)};
        };
        worst(rails, 0, on_rails), worst(riders, sample.heartline, above);
      }
    }
    std::cout << fmt::format("| {} m | {} | {:.3f} g | {:.2f} g | {:.2f} g |\n", spacing, knots,
                             std::max(rails.rms, riders.rms), rails.most, riders.most);
  }
}

// A drop of 60 m and a rise in bends, at up to 34 m/s, with ripples that the bounds of place and direction would let
// vanish, but that are felt with 0.4 g: the curve and its derivatives by x.
constexpr double kDrop = 60, kHalf = 250, kRipple = 0.008, kRipples = 2 * M_PI / 9, kBend = 4, kBends = 2 * M_PI / 120;
dvec3 place(double x) {
  const double u = x / kHalf - 1;
  return {x, kDrop * u * u + kRipple * std::cos(kRipples * x), kBend * std::sin(kBends * x)};
}
dvec3 first(double x) {
  return {1, 2 * kDrop / kHalf * (x / kHalf - 1) - kRipple * kRipples * std::sin(kRipples * x),
          kBend * kBends * std::cos(kBends * x)};
}
dvec3 second(double x) {
  return {0, 2 * kDrop / (kHalf * kHalf) - kRipple * kRipples * kRipples * std::cos(kRipples * x),
          -kBend * kBends * kBends * std::sin(kBends * x)};
}
dvec3 up_at(double x) {
  const dvec3 forward = glm::normalize(first(x)), wish(0, 1, 0);
  return glm::normalize(wish - glm::dot(wish, forward) * forward);
}

TEST(nl2_csv_felt, fast_ripples_are_felt_as_their_curvature_in_closed_form_says) {
  constexpr double kLength = 2 * kHalf;
  std::vector<Moment> ride;
  for (double x = 0; x < kLength;) {
    const dvec3 d = first(x), forward = glm::normalize(d), up = up_at(x), left = glm::cross(up, forward);
    const double v2 = v2_at(kDrop + 2 * kRipple, place(x).y), speed2 = glm::dot(d, d);
    const dvec3 bend = (second(x) - glm::dot(second(x), forward) * forward) / speed2;
    const dvec3 felt = v2 * bend + dvec3(0, 1, 0);
    ride.push_back({place(x), forward, v2, {glm::dot(felt, up), glm::dot(felt, left)}});
    x += std::sqrt(v2 * world::kGravity / speed2) / kRate;
  }
  for (const double spacing : {0.1, 0.5, 2.0, 5.0}) {
    if (test::kSanitized && spacing != 0.5) continue;
    SCOPED_TRACE(fmt::format("rows every {} m", spacing));
    const auto curve = [](double x) {
      return Place{place(x), glm::normalize(first(x)), up_at(x), glm::length(first(x))};
    };
    expect_felt(rows_on(curve, kLength, spacing, 11), ride, 0);
  }
}

// Bends to and fro in a tilted plane, of radii down to 8 m, at a constant 10 m/s.
struct Waves {
  double length, height;  // m, of a wave from crest to crest, and its amplitude
  Place operator()(double x) const {
    const double k = 2 * M_PI / length, slope = height * k * std::cos(k * x);
    const dvec3 side(0, 0.28, 0.96), normal = glm::cross(side, {1, 0, 0}), d = dvec3(1, 0, 0) + slope * side;
    return {dvec3(x - 3.3, 20, 7.1) + height * std::sin(k * x) * side, glm::normalize(d), normal, glm::length(d)};
  }
  dvec3 bend(double x) const {  // curvature, 1/m
    const double k = 2 * M_PI / length, slope = height * k * std::cos(k * x), metres2 = 1 + slope * slope;
    const dvec3 side(0, 0.28, 0.96);
    return -height * k * k * std::sin(k * x) / (metres2 * metres2) * (side - slope * dvec3(1, 0, 0));
  }
};

TEST(nl2_csv_felt, bends_to_and_fro_are_felt_as_closed_forms_say_though_rows_are_metres_apart) {
  constexpr double kLength = 150, kV2 = 100 / world::kGravity;
  for (const auto& [wave, height, spacing] : {std::tuple(18.0, 1.0, 2.0),
                                              {18.0, 1.0, 3.0},
                                              {18.0, 1.0, 4.0},
                                              {24.0, 1.8, 3.0},
                                              {24.0, 1.8, 4.0},
                                              {24.0, 1.8, 5.0},
                                              {36.0, 3.5, 5.0}})
    for (std::uint32_t seed = 0; seed < (test::kSanitized ? 1 : 4); ++seed) {
      SCOPED_TRACE(fmt::format("waves of {} m, rows every {} m, seed {}", wave, spacing, seed));
      const Waves curve{wave, height};
      std::vector<Moment> ride;
      for (double x = 0; x < kLength;) {
        const Place at = curve(x);
        const dvec3 felt = kV2 * curve.bend(x) + dvec3(0, 1, 0);
        ride.push_back(
            {at.place, at.forward, kV2, {glm::dot(felt, at.up), glm::dot(felt, glm::cross(at.up, at.forward))}});
        x += 10 / kRate / at.metres;
      }
      expect_felt(rows_on(curve, kLength, spacing, seed), ride, 0, 6 * kLength / wave);
    }
}

// A straight slope whose rails roll by 1.2 rad to the right and back within `width` m each, twice as far to the left,
// with continuous second derivatives. On straight rails riders h above them feel
//   up:   cos(slope) cos(roll) - h roll'^2 v^2 / g
//   left: cos(slope) sin(roll) - h (roll'' v^2 + roll' sin(slope) g) / g
constexpr double kSlope = 0.2, kRoll = 1.2;
struct CarRoll {
  double width;
  dvec3 roll(double s) const {  // the angle, and its derivatives by s
    dvec3 sum(0);
    for (const auto& [start, way] : {std::pair(30.0, 1.0), {75.0, -1.0}, {115.0, -1.0}, {160.0, 1.0}}) {
      const double u = std::clamp((s - start) / width, 0.0, 1.0);
      sum += way * kRoll *
             dvec3(u * u * u * (10 - 15 * u + 6 * u * u), 30 * u * u * (1 - u) * (1 - u) / width,
                   60 * u * (1 - u) * (1 - 2 * u) / (width * width));
    }
    return sum;
  }
  Place operator()(double s) const {
    const dvec3 forward(std::cos(kSlope), -std::sin(kSlope), 0), up(std::sin(kSlope), std::cos(kSlope), 0);
    return {dvec3(3.3, 57.7, -8.1) + s * forward, forward, curve::rotate(up, forward, roll(s).x)};
  }
};

TEST(nl2_csv_felt, quick_rolls_are_felt_as_closed_forms_say_though_rows_are_metres_apart) {
  constexpr double kLength = 200;
  const double heart = world::Document{}.heartline;
  for (const auto& [width, spacing] : {std::pair(14.0, 0.05), {14.0, 0.5}, {14.0, 2.0}, {18.0, 3.0}})
    for (std::uint32_t seed = 0; seed < (test::kSanitized ? 1 : 4); ++seed) {
      SCOPED_TRACE(fmt::format("rolls within {} m, rows every {} m, seed {}", width, spacing, seed));
      const CarRoll curve{width};
      std::vector<Moment> ride;
      for (double s = 0; s < kLength;) {
        const Place at = curve(s);
        const dvec3 roll = curve.roll(s);
        const double v2 = v2_at(57.7, at.place.y);
        ride.push_back({at.place,
                        at.forward,
                        v2,
                        {std::cos(kSlope) * std::cos(roll.x) - heart * roll.y * roll.y * v2,
                         std::cos(kSlope) * std::sin(roll.x) - heart * (roll.z * v2 + roll.y * std::sin(kSlope))}});
        s += std::sqrt(v2 * world::kGravity) / kRate;
      }
      // A knot every 2.5 m in the four rolls, every 20 m elsewhere.
      expect_felt(rows_on(curve, kLength, spacing, seed), ride, heart, 4 * width / 2.5 + kLength / 20);
    }
}

// A level straight whose roll, r s + a s^2 / 2, goes on beyond both of its ends, at a constant 10 m/s. The first moment
// of a ride is felt without a low-pass.
TEST(nl2_csv_felt, tracks_that_begin_and_end_within_a_roll_are_felt_as_closed_forms_say) {
  constexpr double kLength = 16, kStartRate = -0.35, kChange = 0.05, kV2 = 100 / world::kGravity;  // rad/m, rad/m^2
  const double heart = world::Document{}.heartline;
  const auto roll = [](double s) { return kStartRate * s + 0.5 * kChange * s * s; };
  const auto curve = [&](double s) {
    const dvec3 forward(0.8, 0, 0.6);
    return Place{dvec3(3.3, 20, -8.1) + s * forward, forward, curve::rotate({0, 1, 0}, forward, roll(s))};
  };
  std::vector<Moment> ride;
  for (double s = 0; s < kLength; s += 10 / kRate) {
    const double rate = kStartRate + kChange * s;
    ride.push_back({curve(s).place,
                    curve(s).forward,
                    kV2,
                    {std::cos(roll(s)) - heart * rate * rate * kV2, std::sin(roll(s)) - heart * kChange * kV2}});
  }
  for (const double spacing : {0.05, 0.3, 0.5, 1.0, 2.0, 4.0}) {
    SCOPED_TRACE(fmt::format("rows every {} m", spacing));
    expect_felt(rows_on(curve, kLength, spacing, 11), ride, heart, 3);
  }
}

// Smooth tracks of random bends and rolls, which their ends may cut through: sums of (1 - x^2)^3 over some metres for
// the curvatures upwards and to the right and for the spin against the rotation-minimising frame.
struct Hump {
  double middle, half, most;  // m, m, 1/m
};
double humps(const std::vector<Hump>& list, double s, bool derivative = false) {
  double sum = 0;
  for (const Hump& hump : list) {
    const double x = (s - hump.middle) / hump.half, q = std::max(0.0, 1 - x * x);
    sum += hump.most * (derivative ? -6 * x * q * q / hump.half : q * q * q);
  }
  return sum;
}

class RandomTrack {
 public:
  explicit RandomTrack(std::uint32_t seed) : bits_(seed) {
    length = uniform(50, 120);
    const auto random = [&](int count, double turn, double most) {
      std::vector<Hump> list;
      for (int i = 0; i < count; ++i) {
        const double half = uniform(6, 18);
        list.push_back({uniform(-10, length + 10), half, uniform(-1, 1) * std::min(turn / half, most)});
      }
      return list;
    };
    up_ = random(6, 1.2, 0.12), right_ = random(5, 0.8, 0.08), spin_ = random(5, 1.5, 0.35);
    Place at{{3.3, 40, -8.1}, glm::normalize(dvec3(0.8, uniform(-0.3, 0.3), 0.6)), {0, 1, 0}};
    at.up = curve::perpendicular(at.forward, at.up);
    while (static_cast<double>(fine_.size()) * kStep < length + 7) {
      fine_.push_back(at);
      const double s = (static_cast<double>(fine_.size()) - 0.5) * kStep;
      const Place middle = turned(at, at, s, kStep / 2), next = turned(at, middle, s, kStep);
      at = {at.place + kStep * middle.forward, next.forward, next.up};
    }
  }

  Place operator()(double s) const {
    const auto i = static_cast<std::size_t>(s / kStep);
    const double part = s / kStep - static_cast<double>(i);
    const dvec3 forward = glm::normalize(glm::mix(fine_[i].forward, fine_[i + 1].forward, part));
    return {glm::mix(fine_[i].place, fine_[i + 1].place, part), forward,
            curve::perpendicular(forward, glm::mix(fine_[i].up, fine_[i + 1].up, part))};
  }

  // A ride of a train without losses, as in closed form: the second derivative of the path `heart` m above the rails.
  std::vector<Moment> ride(double heart) const {
    double top = -1e9;
    for (double s = 0; s < length; s += 0.5) top = std::max(top, (*this)(s).place.y);
    std::vector<Moment> moments;
    for (double s = 0; s < length;) {
      const Place at = (*this)(s);
      const double v2 = v2_at(top, at.place.y), up = humps(up_, s), right = humps(right_, s), spin = humps(spin_, s);
      const double near = 1 - heart * up, change = humps(spin_, s, true);
      const double rightwards = (near * right + heart * change) * v2 - heart * spin * at.forward.y;
      moments.push_back(
          {at.place,
           at.forward,
           v2,
           {(near * up - heart * spin * spin) * v2 + at.up.y, -rightwards - glm::cross(at.forward, at.up).y}});
      s += std::sqrt(v2 * world::kGravity) / kRate;
    }
    return moments;
  }

  double length = 0;  // m

 private:
  static constexpr double kStep = 0.005;  // m
  double uniform(double low, double high) { return low + (high - low) * (bits_() / 4294967296.0); }
  // Returns `from` turned as at place s over a distance, about the axes of `by`.
  Place turned(const Place& from, const Place& by, double s, double distance) const {
    const dvec3 right = glm::cross(by.forward, by.up);
    const double up = humps(up_, s);
    const dvec3 forward = glm::normalize(from.forward + distance * (up * by.up + humps(right_, s) * right));
    return {from.place, forward,
            curve::perpendicular(forward, from.up + distance * (humps(spin_, s) * right - up * by.forward))};
  }

  std::mt19937 bits_;
  std::vector<Hump> up_, right_, spin_;
  std::vector<Place> fine_;
};

TEST(nl2_csv_felt, random_tracks_are_felt_as_closed_forms_say_from_their_first_row_to_the_last) {
  for (std::uint32_t seed = 1; seed <= 12; ++seed) {
    if (!test::tried(static_cast<int>(seed))) continue;
    const RandomTrack track(seed);
    for (const double heart : {0.0, world::Document{}.heartline}) {
      const std::vector<Moment> ride = track.ride(heart);
      for (const double spacing : {0.05, 0.3, 1.0}) {
        SCOPED_TRACE(fmt::format("seed {}, {} m above the rails, rows every {} m", seed, heart, spacing));
        expect_felt(rows_on(track, track.length, spacing, seed), ride, heart);
      }
    }
  }
}

// Rolls to and fro all along a straight slope, at 38 degrees/m at most: every span would use up its bound, which alone
// allows 0.14 g on average.
TEST(nl2_csv_felt, rolls_without_end_are_felt_as_closed_forms_say_on_average_too) {
  constexpr double kLength = 200, kSwing = 1.2, kWave = 2 * M_PI / 12;
  const double heart = world::Document{}.heartline;
  const dvec3 forward(std::cos(kSlope), -std::sin(kSlope), 0), upright(std::sin(kSlope), std::cos(kSlope), 0);
  const auto curve = [&](double s) {
    return Place{dvec3(3.3, 57.7, -8.1) + s * forward, forward,
                 curve::rotate(upright, forward, kSwing * std::sin(kWave * s))};
  };
  std::vector<Moment> ride;
  for (double s = 0; s < kLength;) {
    const double roll = kSwing * std::sin(kWave * s), rate = kSwing * kWave * std::cos(kWave * s),
                 change = -kWave * kWave * roll, v2 = v2_at(57.7, curve(s).place.y);
    ride.push_back({curve(s).place,
                    forward,
                    v2,
                    {std::cos(kSlope) * std::cos(roll) - heart * rate * rate * v2,
                     std::cos(kSlope) * std::sin(roll) - heart * (change * v2 + rate * std::sin(kSlope))}});
    s += std::sqrt(v2 * world::kGravity) / kRate;
  }
  expect_felt(rows_on(curve, kLength, 0.1, 11), ride, heart);
}

// A level straight that rolls by 90 degrees in 20 m and back, at an even rate that starts and stops at once: each time
// the velocity of riders h above the rails changes by v h roll', which they feel as one impulse.
TEST(nl2_csv_felt, rolls_that_start_at_once_throw_riders_as_hard_as_in_closed_form) {
  constexpr double kRate90 = M_PI / 2 / 20, kLength = 120, kSpeed = 10;
  const auto roll = [](double s) { return kRate90 * (std::clamp(s - 30, 0.0, 20.0) - std::clamp(s - 70, 0.0, 20.0)); };
  const auto curve = [&](double s) {
    const dvec3 forward(0.8, 0, 0.6);
    return Place{dvec3(3.3, 20.7, -8.1) + s * forward, forward, curve::rotate({0, 1, 0}, forward, roll(s))};
  };
  const double heart = world::Document{}.heartline, v2 = kSpeed * kSpeed / world::kGravity;
  std::vector<Moment> ride;
  for (double s = 0; s < kLength; s += kSpeed / kRate) {
    const double next = s + kSpeed / kRate, rate = (roll(s + 1e-6) - roll(s)) / 1e-6;
    double impulse = 0;  // of the rate, within this sample's time, seen as one sample
    for (const auto& [place, way] : {std::pair(30.0, 1.0), {50.0, -1.0}, {70.0, -1.0}, {90.0, 1.0}})
      if (place >= s && place < next) impulse += way * kRate90 / (next - s);
    ride.push_back({curve(s).place,
                    curve(s).forward,
                    v2,
                    {std::cos(roll(s)) - heart * rate * rate * v2, std::sin(roll(s)) - heart * impulse * v2}});
  }
  for (const double spacing : {0.05, 0.25, 0.5}) {
    SCOPED_TRACE(fmt::format("rows every {} m", spacing));
    const std::string rows = rows_on(curve, kLength, spacing, 5);
    expect_felt(rows, ride, heart);
    // An impulse is felt as a peak of 2.40 f dv / g. Joints between rows far apart report at most three times that as
    // their jolt.
    world::Document document = parse_nl2_csv(rows, "t.csv")->document;
    document.start_speed = kSpeed;
    const sim::DerivedTrack derived = sim::shapes_of(document);
    sim::RideCache cache;
    const sim::SimulatedRide* const simulated = cache.ride(document, derived, world::first_cart(document));
    double most = 0;
    for (const sim::Jolt& jolt : sim::jolts(*simulated, 5)) most = std::max(most, jolt.total);
    EXPECT_LT(most, (spacing < 0.1 ? 1.2 : 3) * 2.40 * 5 * heart * kRate90 * kSpeed / world::kGravity);
  }
}

// A level bend by 100 degrees, a hyperbola whose radius is 1.6 m at x = 0, at a constant 10 m/s.
struct Corner {
  static constexpr double kAside = 1.2, kNear = kAside * kAside * 1.6;
  Place operator()(double x) const {
    const double y = std::hypot(kNear, kAside * x), slope = kAside * kAside * x / y;
    const dvec3 d(1, 0, slope);
    return {dvec3(x - 3.3, 20, y + 7.1), glm::normalize(d), {0, 1, 0}, glm::length(d)};
  }
  double bend(double x) const {  // 1/m, to the right
    const double y = std::hypot(kNear, kAside * x), slope = kAside * kAside * x / y;
    return kAside * kAside * kNear * kNear / (y * y * y) / std::pow(1 + slope * slope, 1.5);
  }
};

TEST(nl2_csv_felt, rows_too_far_apart_for_a_bend_are_warned_of_with_their_line_and_about_how_much) {
  constexpr double kHalfway = 30, kV2 = 100 / world::kGravity;
  const Corner curve;
  const auto moved = [&](double x) { return curve(x - kHalfway); };
  std::vector<Moment> ride;
  for (double x = 0; x < 2 * kHalfway;) {
    const Place at = moved(x);
    ride.push_back({at.place, at.forward, kV2, {1, -kV2 * curve.bend(x - kHalfway)}});
    x += 10 / kRate / at.metres;
  }
  const std::string what = "the rows are too far apart for the bends here: riders may feel ";
  int over = 0;
  for (const double spacing : {0.5, 1.0, 4.0, 5.0})
    for (std::uint32_t seed = 0; seed < 4; ++seed) {
      SCOPED_TRACE(fmt::format("rows every {} m, seed {}", spacing, seed));
      const auto loaded = parse_nl2_csv(rows_on(moved, 2 * kHalfway, spacing, seed), "t.csv");
      ASSERT_TRUE(loaded.ok()) << loaded.status().message;
      const double most = wrong_on(loaded->document, 0, ride).most;
      if (spacing <= 1) {
        EXPECT_TRUE(loaded->warnings.empty()) << loaded->warnings[0];
        EXPECT_LE(most, 0.4);
        continue;
      }
      over += most > 0.4 ? 1 : 0;
      ASSERT_EQ(loaded->warnings.size(), 1u);
      const std::string& told = loaded->warnings[0];
      ASSERT_NE(told.find(what), std::string::npos) << told;
      EXPECT_GT(std::stod(told.substr(told.find(what) + what.size())), most / 3) << told;
      // The bend is at 43 of 86 m of rows, whose first line is 2.
      EXPECT_NEAR((std::stoi(told.substr(6)) - 2) * spacing, 43, 1.6 * spacing) << told;
    }
  EXPECT_GE(over, 4) << "files whose forces are off";
}

// A level straight that rolls by 1.5 rad within 1.8 m, at 10 m/s.
TEST(nl2_csv_felt, rows_too_far_apart_for_a_very_quick_roll_are_warned_of_with_about_how_much) {
  constexpr double kTurn = 1.5, kWidth = 1.8, kLength = 60, kV2 = 100 / world::kGravity;
  const double heart = world::Document{}.heartline;
  const auto roll = [](double s) {  // and its derivatives
    const double u = std::clamp((s - 30.07) / kWidth, 0.0, 1.0);
    return kTurn * dvec3(u * u * u * (10 - 15 * u + 6 * u * u), 30 * u * u * (1 - u) * (1 - u) / kWidth,
                         60 * u * (1 - u) * (1 - 2 * u) / (kWidth * kWidth));
  };
  const auto curve = [&](double s) {
    const dvec3 forward(0.8, 0, 0.6);
    return Place{dvec3(3.3, 20, -8.1) + s * forward, forward, curve::rotate({0, 1, 0}, forward, roll(s).x)};
  };
  std::vector<Moment> ride;
  for (double s = 0; s < kLength; s += 10 / kRate) {
    const dvec3 r = roll(s);
    ride.push_back({curve(s).place,
                    curve(s).forward,
                    kV2,
                    {std::cos(r.x) - heart * r.y * r.y * kV2, std::sin(r.x) - heart * r.z * kV2}});
  }
  const std::string what = "the rows are too far apart for the roll here: riders may feel ";
  for (const double spacing : {0.05, 0.4, 0.55})
    for (std::uint32_t seed = 0; seed < 3; ++seed) {
      SCOPED_TRACE(fmt::format("rows every {} m, seed {}", spacing, seed));
      const auto loaded = parse_nl2_csv(rows_on(curve, kLength, spacing, seed), "t.csv");
      ASSERT_TRUE(loaded.ok()) << loaded.status().message;
      const double most = wrong_on(loaded->document, heart, ride).most;
      if (spacing < 0.1) {
        EXPECT_TRUE(loaded->warnings.empty()) << loaded->warnings[0];
        continue;
      }
      EXPECT_GT(most, 0.4);
      ASSERT_EQ(loaded->warnings.size(), 1u);
      ASSERT_NE(loaded->warnings[0].find(what), std::string::npos) << loaded->warnings[0];
      EXPECT_GT(std::stod(loaded->warnings[0].substr(loaded->warnings[0].find(what) + what.size())), most / 2)
          << most << loaded->warnings[0];
    }
}

TEST(nl2_csv_felt, rows_too_far_apart_for_a_roll_are_warned_of_with_their_line) {
  const auto warnings = [](double width, double spacing) {
    return parse_nl2_csv(rows_on(CarRoll{width}, 200, spacing, 3), "t.csv")->warnings;
  };
  const std::vector<std::string> told = warnings(14, 5);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_TRUE(told[0].starts_with("t.csv:")) << told[0];
  EXPECT_NE(told[0].find("the rows are too far apart for the roll here: riders may feel "), std::string::npos);
  const int line = std::stoi(told[0].substr(6));  // within a roll: 30 to 44, 75 to 89, 115 to 129, 160 to 174 m
  EXPECT_TRUE(line >= 6 && line <= 38) << told[0];
  EXPECT_TRUE(warnings(14, 1).empty());
  EXPECT_TRUE(warnings(30, 3).empty());
}

}  // namespace nl2_csv_felt_test
}  // namespace coaster::exchange
