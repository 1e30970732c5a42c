#include "view/ride_sound.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "sim/lands.h"
#include "sim/ride/ride.h"
#include "sim/tracks.h"

namespace coaster::view {
namespace ride_sound_test {

constexpr int kRate = 44'100;

RideNoise at_speed(double speed, double rack = 0) { return {speed, rack, 1, 1}; }

// `seconds` of it, after half a second in which it settles.
std::vector<float> sound_of(const RideNoise& noise, double seconds, RideVoice* voice = nullptr) {
  RideVoice own;
  RideVoice& v = voice ? *voice : own;
  std::vector<float> start(kRate), out(2 * static_cast<std::size_t>(seconds * kRate));
  synthesise(v, noise, kRate, start);
  synthesise(v, noise, kRate, out);
  return out;
}

double rms(const std::vector<float>& samples) {
  double sum = 0;
  for (const float s : samples) sum += static_cast<double>(s) * s;
  return std::sqrt(sum / static_cast<double>(samples.size()));
}

// The power near a frequency, by Goertzel's recurrence over blocks of 4096 left samples: bins 10.8 Hz wide.
double power_at(const std::vector<float>& samples, double hertz) {
  constexpr std::size_t kBlock = 4096;
  const double c = 2 * std::cos(2 * M_PI * hertz / kRate);
  double power = 0;
  std::size_t blocks = 0;
  for (std::size_t from = 0; 2 * (from + kBlock) <= samples.size(); from += kBlock, ++blocks) {
    double before = 0, last = 0;
    for (std::size_t i = 0; i < kBlock; ++i) {
      const double now = samples[2 * (from + i)] + c * last - before;
      before = last, last = now;
    }
    power += before * before + last * last - c * before * last;
  }
  return power / static_cast<double>(blocks);
}

// Returns the frequency below which half of the power between 100 Hz and 4 kHz is.
double middle_frequency(const std::vector<float>& samples) {
  std::vector<double> powers;
  double all = 0;
  for (double hertz = 100; hertz <= 4000; hertz += 20) all += powers.emplace_back(power_at(samples, hertz));
  double below = 0;
  for (std::size_t i = 0; i < powers.size(); ++i)
    if ((below += powers[i]) >= all / 2) return 100 + 20 * static_cast<double>(i);
  return 4000;
}

TEST(ride_sound, is_louder_and_brighter_the_faster_the_train) {
  double louder = 0, brighter = 0;
  for (const double speed : {4.0, 9.3, 17.1, 26.4, 34.9}) {
    const std::vector<float> samples = sound_of(at_speed(speed), 1);
    const double loudness = rms(samples), middle = middle_frequency(samples);
    EXPECT_GT(loudness, 1.15 * louder) << speed;
    EXPECT_GT(middle, brighter) << speed;
    louder = loudness, brighter = middle;
  }
  EXPECT_GT(louder, 0.05) << "audible at full speed";
  EXPECT_LT(louder, 0.5) << "and not distorted";
}

// The wheels are loudest a quarter of a turn on and quietest half a turn later: 1 to 0.6 of their noise.
// Returns how much more power there is at the loud part of a wheel's turn than half a turn later.
double hum_of(const RideNoise& noise) {
  RideVoice voice;
  (void)sound_of(noise, 0.5, &voice);
  double loud = 0, quiet = 0;
  for (int i = 0; i < 3000; ++i) {
    const double turn = voice.turn;
    std::vector<float> part(2 * 220);
    synthesise(voice, noise, kRate, part);
    if (std::abs(turn - 0.225) < 0.1) loud += rms(part) * rms(part);
    if (std::abs(turn - 0.725) < 0.1) quiet += rms(part) * rms(part);
  }
  return loud / quiet;
}

TEST(ride_sound, wheels_hum_once_a_turn) {
  const double steel = hum_of(at_speed(11));
  EXPECT_GT(steel, 1.15);
  EXPECT_LT(steel, 3);
  RideNoise noise = at_speed(11);
  noise.rumble = 1;
  EXPECT_GT(hum_of(noise), 1.7 * steel) << "wheels knock on the ties of a wooden track";
}

TEST(ride_sound, clacks_at_the_speed_of_the_chain_over_the_pitch_of_its_rack) {
  for (const double speed : {1.3, 4.0, 7.9}) {
    RideVoice voice;
    (void)sound_of(at_speed(speed, speed), 3.5, &voice);
    EXPECT_NEAR(static_cast<double>(voice.clacks), 4.0 * speed / kRackPitch, 1) << speed;
  }
  RideVoice silent;
  (void)sound_of(at_speed(20), 1, &silent);
  EXPECT_EQ(silent.clacks, 0u);
}

TEST(ride_sound, a_clack_stands_out_of_the_noise_of_a_slow_train) {
  const std::vector<float> plain = sound_of(at_speed(3), 2), lifted = sound_of(at_speed(3, 3), 2);
  const auto peak = [](const std::vector<float>& samples) {
    float most = 0;
    for (const float s : samples) most = std::max(most, std::abs(s));
    return most;
  };
  EXPECT_GT(peak(lifted), 3 * peak(plain));
}

TEST(ride_sound, is_silent_without_volume_and_at_rest) {
  EXPECT_LT(rms(sound_of({25, 4, 1, 0}, 1)), 1e-4);
  EXPECT_LT(rms(sound_of(at_speed(0), 1)), 1e-3);
}

RC_GTEST_PROP(ride_sound, does_not_depend_on_how_it_is_cut_into_blocks, ()) {
  const RideNoise noise = at_speed(*rc::gen::inRange(0, 40), *rc::gen::inRange(0, 8));
  const std::size_t frames = *rc::gen::inRange<std::size_t>(1, 3000), cut = *rc::gen::inRange<std::size_t>(0, frames);
  RideVoice one, two;
  std::vector<float> whole(2 * frames), parts(2 * frames);
  synthesise(one, noise, kRate, whole);
  synthesise(two, noise, kRate, std::span(parts).first(2 * cut));
  synthesise(two, noise, kRate, std::span(parts).subspan(2 * cut));
  RC_ASSERT(whole == parts);
}

TEST(ride_sound, has_no_step_where_speed_leaps_or_sound_begins) {
  RideVoice voice;
  std::vector<float> block(2048);
  const RideNoise leaps[] = {at_speed(0), at_speed(40), at_speed(3, 3), {}, at_speed(31), {31, 0, 1, 0}};
  float last = 0, most = 0;
  for (const RideNoise& noise : leaps) {
    synthesise(voice, noise, kRate, block);
    for (std::size_t i = 0; i < block.size(); i += 2)
      most = std::max(most, std::abs(block[i] - std::exchange(last, block[i])));
  }
  // The largest step of steady sound at full speed, which is noise of up to some kHz.
  const std::vector<float> steady = sound_of(at_speed(40), 1);
  float usual = 0;
  for (std::size_t i = 2; i < steady.size(); i += 2) usual = std::max(usual, std::abs(steady[i] - steady[i - 2]));
  EXPECT_LE(most, 1.2f * usual);
}

RC_GTEST_PROP(ride_sound, is_finite_and_within_one_for_every_noise, ()) {
  const auto any = rc::gen::element(0.0, -3.0, 1.0, 50.0, 1e9, -1e300, std::numeric_limits<double>::infinity(),
                                    std::numeric_limits<double>::quiet_NaN());
  RideVoice voice;
  std::vector<float> block(300);
  for (int i = 0; i < 4; ++i) {
    synthesise(voice, {*any, *any, *any, *any}, *rc::gen::element(8'000, 44'100, 192'000), block);
    for (const float s : block) RC_ASSERT(std::abs(s) <= 1.0f);
  }
}

TEST(ride_sound, hears_the_first_train_and_whether_any_of_its_cars_is_on_a_lift) {
  world::Document d = test::straight_document({1.3f, 2.1f, -7.7f}, {121.3f, 32.1f, -7.7f}, 12);
  d.entities.put(d.track.segments.at(2), world::Equipment{world::EquipmentKind::lift, 4, 3, 0, 0});
  const world::Entity cart = world::add_cart(d, d.track.segments.at(0), 0.5);
  d.entities.get<world::Train>(cart).cars = 3;
  const sim::DerivedTrack derived = test::derived_of(d);
  world::Motion motion;
  sim::reset(d, derived, motion);
  world::TrainMotion& train = motion.carts.items().front();
  const double segment = derived.length / 12;
  const auto put = [&](double front, double speed) {
    const sim::TrackPlace place = sim::place_at(derived, front);
    train.segment = derived.order[place.index], train.s = place.s, train.track_distance = front, train.speed = speed;
    return ride_noise(d, derived, motion, 0.4);
  };
  EXPECT_EQ(put(5, 9), (RideNoise{0, 0, 1, 0.4})) << "nothing runs";
  motion.state = world::RideState::running;
  EXPECT_EQ(put(1.9 * segment, 7).rack, 0);
  EXPECT_EQ(put(1.9 * segment, 7).speed, 7);
  EXPECT_EQ(put(2.1 * segment, 7).rack, 7) << "the first car";
  EXPECT_EQ(put(3.0 * segment + 5.9, 7).rack, 7) << "the last one, 6 m behind";
  EXPECT_EQ(put(3.0 * segment + 6.1, 7).rack, 0);
  EXPECT_EQ(put(2.1 * segment, -7).rack, 0) << "the ratchet is silent backwards";
  EXPECT_EQ(put(2.1 * segment, -7).speed, 7);
}

// The noise of a train in a tunnel, or over water.
RideNoise around(double inside, double splash) {
  RideNoise noise = at_speed(16);
  noise.inside = inside, noise.splash = splash;
  return noise;
}

TEST(ride_sound, a_tunnel_is_louder_and_goes_on_after_the_wheels_and_water_hisses) {
  const double open = rms(sound_of(around(0, 0), 1));
  EXPECT_GT(rms(sound_of(around(1, 0), 1)), 1.5 * open);
  EXPECT_GT(rms(sound_of(around(0.5, 0), 1)), 1.15 * open);
  // Both sides hear other echoes, and what was heard outside leaves no trace.
  RideVoice voice, fresh;
  (void)sound_of(around(1, 0), 1, &voice);
  (void)sound_of(around(0, 0), 1, &voice);
  EXPECT_TRUE(voice.echo[0][0].samples.empty());
  const std::vector<float> dry = sound_of(around(0, 0), 1), wet = sound_of(around(0, 1), 1);
  EXPECT_GT(power_at(wet, 3100), 4 * power_at(dry, 3100));
  EXPECT_EQ(dry, sound_of(at_speed(16), 1, &fresh));
}

// An impulse comes back after each line's time and dies away: a second later next to nothing is left.
TEST(ride_sound, echoes_die_away) {
  RideVoice voice;
  (void)sound_of(around(1, 0), 1, &voice);
  const RideNoise still{0, 0, 1, 1, 0, 1, 0};
  std::vector<float> first(2 * kRate / 10), later(2 * kRate / 10), between(2 * kRate);
  synthesise(voice, still, kRate, first);
  synthesise(voice, still, kRate, between);
  synthesise(voice, still, kRate, later);
  EXPECT_GT(rms(first), 0.01);
  EXPECT_LT(rms(later), 0.02 * rms(first));
}

RC_GTEST_PROP(ride_sound, in_tunnels_does_not_depend_on_blocks_either_and_stays_within_one, ()) {
  const auto part = [] { return *rc::gen::inRange(0, 101) / 100.0; };
  RideNoise noise = at_speed(*rc::gen::inRange(0, 150));
  noise.inside = part(), noise.splash = part(), noise.rumble = part(), noise.load = 10 * part();
  const std::size_t frames = *rc::gen::inRange<std::size_t>(1, 6000), cut = *rc::gen::inRange<std::size_t>(0, frames);
  RideVoice one, two;
  std::vector<float> whole(2 * frames), parts(2 * frames);
  synthesise(one, noise, kRate, whole);
  synthesise(two, noise, kRate, std::span(parts).first(2 * cut));
  synthesise(two, noise, kRate, std::span(parts).subspan(2 * cut));
  RC_ASSERT(whole == parts);
  for (const float sample : whole) RC_ASSERT(std::abs(sample) <= 1.0f);
}

// A train of five cars on a level straight through a ridge, and over a lake 1 m below its rails.
TEST(ride_sound, hears_tunnels_by_the_part_of_the_train_in_them_and_water_by_its_nearness) {
  world::Document d = test::straight_document({-100, 5, 0}, {100, 5, 0}, 10);
  const world::Entity cart = world::add_cart(d, d.track.segments.at(0), 0.5);
  d.entities.get<world::Train>(cart).cars = 5;
  const auto noise_at = [&](double front, double speed) {
    const test::TrackOnLand track(d);
    world::Motion motion;
    sim::reset(d, track.derived, motion);
    motion.state = world::RideState::running;
    world::TrainMotion& train = motion.carts.items().front();
    const sim::TrackPlace place = sim::place_at(track.derived, front);
    train.segment = track.derived.order[place.index], train.s = place.s, train.track_distance = front;
    train.speed = speed;
    return ride_noise(d, track.derived, motion, 0.4, &track.ground);
  };
  EXPECT_EQ(noise_at(100, 15).inside, 0) << "no land";
  test::shape_land(d, test::ridge(24, 30));
  EXPECT_EQ(noise_at(40, 15).inside, 0);
  EXPECT_NEAR(noise_at(110, 15).inside, 1, 1e-12);
  double last = 0;
  for (double front = 60; front < 100; front += 0.5) {
    const double inside = noise_at(front, 15).inside;
    EXPECT_GE(inside, last - 1e-12) << front;
    last = inside;
  }
  test::shape_land(d, [](double, double) { return -6.0; });
  EXPECT_EQ(noise_at(100, 15).splash, 0) << "no water";
  for (const auto& [over, splash] : {std::pair(2.0, 0.0), {1.5, 0.0}, {0.75, 0.5}, {0.0, 1.0}, {-1.0, 1.0}}) {
    d.park.water = 5 - over;
    EXPECT_NEAR(noise_at(100, 15).splash, splash, 1e-6) << over;
    EXPECT_NEAR(noise_at(100, 3).splash, splash / 5, 1e-6) << over;
  }
}

}  // namespace ride_sound_test
}  // namespace coaster::view
