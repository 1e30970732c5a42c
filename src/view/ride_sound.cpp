// Synthesis by filtered noise and struck resonators. Nothing here is hashed, so libm may be used.
#include "view/ride_sound.h"

#include <algorithm>
#include <cmath>

#include "base/portable_math.h"
#include "sim/ground/ground.h"
#include "sim/ride/equipment.h"
#include "sim/ride/ride.h"
#include "sim/ride/train.h"
#include "sim/shape/rails.h"
#include "world/equipment_rows.h"

namespace coaster::view {
namespace {

constexpr double kTurn = 2 * base::kPi;

double finite(double value, double low, double high) { return std::isfinite(value) ? std::clamp(value, low, high) : 0; }

// xorshift32 (Marsaglia 2003, doi 10.18637/jss.v008.i14) as white noise in -1..1.
double white(std::uint32_t& seed) {
  seed ^= seed << 13, seed ^= seed >> 17, seed ^= seed << 5;
  return static_cast<double>(seed) * (2.0 / 4294967296.0) - 1;
}

struct RingFilter {
  double a1, a2, gain;
};
// Poles at radius r, so that the ring decays to 1/e in `decay` seconds; the impulse response is a sine that begins at 0
// with amplitude 1.
RingFilter ring(double hertz, double decay, int rate) {
  const double r = std::exp(-1 / (decay * rate)), w = kTurn * std::min(hertz, 0.45 * rate) / rate;
  return {2 * r * std::cos(w), -r * r, std::sin(w)};
}
double rung(Resonator& resonator, const RingFilter& ring, double in) {
  double now = ring.a1 * resonator.last + ring.a2 * resonator.before + ring.gain * in;
  if (std::abs(now) < 1e-15) now = 0;  // denormal numbers are slow and inaudible
  resonator.before = resonator.last;
  return resonator.last = now;
}

// Values that depend on speed, computed once for several frames.
struct SpeedFilters {
  RingFilter wind;
  double wind_gain, wheel_gain, wheel_pole;
};
constexpr int kToneFrames = 32;

SpeedFilters tone_of(const RideNoise& heard, int rate) {
  constexpr double kFast = 35;       // m/s, speed of the loudest wind
  constexpr double kBrighter = 0.9;  // of wheels on wood
  const double speed = heard.speed, part = std::min(speed / kFast, 1.3);
  SpeedFilters tone;
  // A wide resonance that rises with speed: 280 Hz at rest, 1 kHz at 30 m/s; half the amplitude is left after one
  // period.
  const double hertz = 280 + 24 * speed;
  tone.wind = ring(hertz, 0.6 / hertz, rate);
  tone.wind_gain = 0.34 * part * part;
  tone.wheel_pole = 1 - std::exp(-kTurn * (70 + 5 * speed) * (1 + kBrighter * heard.rumble) / rate);
  tone.wheel_gain = 3.2 * std::pow(std::min(speed / kFast, 1.3), 0.8) * (0.55 + 0.45 * std::min(heard.load, 3.0));
  return tone;
}

struct ToothPartial {
  double hertz, decay, gain;
};
// A steel tooth: tuned by ear, not after a particular lift.
constexpr std::array<ToothPartial, 3> kSteel{{{420, 0.028, 0.34}, {1270, 0.016, 0.22}, {2910, 0.008, 0.12}}};

// The distance over the rack gives the frames until the next click; each click differs slightly.
double clack(RideVoice& voice, const std::array<RingFilter, 3>& rings, int rate) {
  double strike = 0;
  voice.tooth += voice.heard.rack / (kRackPitch * rate);
  if (voice.tooth >= 1) {
    voice.tooth -= std::floor(voice.tooth);
    ++voice.clacks;
    strike = 1 + 0.25 * white(voice.seeds[2]);
  }
  double sum = 0;
  for (std::size_t i = 0; i < kSteel.size(); ++i) sum += kSteel[i].gain * rung(voice.steel[i], rings[i], strike);
  return sum;
}

// Times after which a tunnel's walls answer, s; left and right differ, so that it sounds wide.
constexpr double kEchoes[2][3] = {{0.0297, 0.0371, 0.0437}, {0.0311, 0.0353, 0.0419}};

double echo(std::array<EchoLine, 3>& lines, const double (&delays)[3], int rate, double in) {
  constexpr double kBack = 0.72, kDull = 0.4;
  double sum = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EchoLine& line = lines[i];
    const auto length = static_cast<std::size_t>(delays[i] * rate);
    if (line.samples.size() != length) line = {std::vector<float>(length), 0, 0};
    const auto out = static_cast<double>(line.samples[line.at]);
    line.dull = (1 - kDull) * out + kDull * line.dull;
    line.samples[line.at] = static_cast<float>(in + kBack * line.dull);
    line.at = (line.at + 1) % length;
    sum += out;
  }
  return 0.5 * sum;
}

// Hiss of spray: noise without its low part.
double splash(RideVoice& voice, int rate) {
  if (voice.heard.splash <= 0) return 0;
  const double in = white(voice.seeds[3]), pole = 1 - std::exp(-kTurn * 900 / rate);
  voice.spray += pole * (in - voice.spray);
  return 0.5 * voice.heard.splash * (in - voice.spray);
}

// Compresses samples above half of full scale, so that the sum stays below 1.
double bounded(double x) {
  constexpr double kKnee = 0.5;
  const double size = std::abs(x);
  return size <= kKnee ? x : std::copysign(kKnee + (1 - kKnee) * std::tanh((size - kKnee) / (1 - kKnee)), x);
}

// The places of a train, m along the track.
struct TrainPlaces {
  double front, length;
};
void take_ground(const sim::DerivedTrack& derived, const sim::Ground& ground, TrainPlaces train, RideNoise& noise) {
  constexpr double kLoud = 15;  // m/s
  constexpr int kLooks = 5;
  for (int i = 0; i < kLooks; ++i) {
    const double back = train.front - train.length * i / (kLooks - 1),
                 at = derived.closed && back < 0 ? back + derived.length : std::max(back, 0.0);
    if (ground.tunnel_at(at) != nullptr) {
      noise.inside += 1.0 / kLooks;
      continue;
    }
    const sim::TrackPlace place = sim::place_at(derived, at);
    const glm::dvec3 rails = sim::rails_at(derived.shape_at(place.index), place.s);
    if (!(ground.height(rails.x, rails.z) < ground.water())) continue;
    const double near = std::clamp(1 - (rails.y - ground.water()) / kSplashHeight, 0.0, 1.0);
    noise.splash = std::max(noise.splash, near * std::min(noise.speed / kLoud, 1.0));
  }
}

// Moves a part of the noise towards what is wanted; a very small rest ends, so that nothing is computed for it.
void fade(double& heard, double wanted, double nearer) {
  heard += nearer * (wanted - heard);
  if (wanted == 0 && heard < 1e-4) heard = 0;
}

}  // namespace

RideNoise ride_noise(const world::Document& document, const sim::DerivedTrack& derived, const world::Motion& motion,
                     double volume, const sim::Ground* ground) {
  RideNoise noise;
  noise.volume = volume, noise.rumble = base::row_of(document.kind).rumble;
  const world::Entity cart = world::first_cart(document);
  const world::TrainMotion* const moving = motion.carts.find(cart);
  const world::Train* const design = document.entities.find<world::Train>(cart);
  if (!moving || !design || motion.state != world::RideState::running || !derived.segments.contains(moving->segment))
    return noise;
  noise.speed = std::abs(moving->speed);
  noise.load = std::abs(sim::felt(document, derived, cart, *moving).up);
  const double front = moving->track_distance,
               length = (sim::cars_on(derived, *design) - 1) * static_cast<double>(design->spacing);
  for (const sim::EquipmentSpan& span : sim::equipment_spans(document, derived)) {
    if (!base::row_of(span.equipment.kind).has_chain) continue;
    const auto over = [&](double to) { return to >= span.from && to - length <= span.to; };
    // On a closed track the rear may still be before the start of the track.
    if (over(front) || (derived.closed && over(front + derived.length))) noise.rack = std::max(0.0, moving->speed);
  }
  if (ground != nullptr && !ground->plain()) take_ground(derived, *ground, {front, length}, noise);
  return noise;
}

void synthesise(RideVoice& voice, const RideNoise& noise, int rate, std::span<float> out) {
  // On wood the wheels knock at each tie.
  constexpr double kSlow = 0.03, kMostSpeed = 150, kWheelRound = 1.1, kTieRound = 0.9;  // s, m/s, m, m
  constexpr double kSwing = 0.2, kKnock = 0.3, kLouder = 0.8;
  const RideNoise wanted{finite(noise.speed, 0, kMostSpeed), finite(noise.rack, 0, kMostSpeed),
                         finite(noise.load, 0, 10),          finite(noise.volume, 0, 1),
                         finite(noise.rumble, 0, 1),         finite(noise.inside, 0, 1),
                         finite(noise.splash, 0, 1)};
  const double round = kWheelRound + wanted.rumble * (kTieRound - kWheelRound), swing = kSwing + kKnock * wanted.rumble;
  const double nearer = 1 - std::exp(-1 / (kSlow * rate));
  std::array<RingFilter, 3> rings{};
  for (std::size_t i = 0; i < rings.size(); ++i) rings[i] = ring(kSteel[i].hertz, kSteel[i].decay, rate);
  RideNoise& heard = voice.heard;
  SpeedFilters tone = tone_of(voice.toned, rate);
  for (std::size_t frame = 0; 2 * frame + 1 < out.size(); ++frame) {
    heard.speed += nearer * (wanted.speed - heard.speed);
    heard.load += nearer * (wanted.load - heard.load);
    heard.volume += nearer * (wanted.volume - heard.volume);
    heard.rumble = wanted.rumble;
    fade(heard.inside, wanted.inside, nearer), fade(heard.splash, wanted.splash, nearer);
    if (heard.inside == 0 && !voice.echo[0][0].samples.empty()) voice.echo = {};
    heard.rack = wanted.rack;  // clicks are counted by distance: no smoothing needed
    if (voice.frames++ % kToneFrames == 0) tone = tone_of(voice.toned = heard, rate);
    voice.turn += heard.speed / (round * rate);
    voice.turn -= std::floor(voice.turn);
    double in = white(voice.seeds[0]);
    const double shared = in;
    for (double& low : voice.low) in = low += tone.wheel_pole * (in - low);
    const double wheels =
        (1 + kLouder * heard.inside) * tone.wheel_gain * in * (1 - swing + swing * std::sin(kTurn * voice.turn));
    const double teeth = clack(voice, rings, rate), water = splash(voice, rate);
    const double other = white(voice.seeds[1]);
    const std::array<double, 2> noises{0.8 * shared + 0.6 * other, 0.8 * shared - 0.6 * other};
    for (std::size_t side = 0; side < 2; ++side) {
      const double wind = tone.wind_gain * rung(voice.wind[side], tone.wind, noises[side]);
      double sum = wind + wheels + teeth + water;
      if (heard.inside > 0) sum += heard.inside * echo(voice.echo[side], kEchoes[side], rate, sum);
      out[2 * frame + side] = static_cast<float>(bounded(heard.volume * sum));
    }
  }
}

}  // namespace coaster::view
