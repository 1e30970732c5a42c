#include "sim/ride/equipment.h"

#include <algorithm>
#include <cmath>

namespace coaster::sim {
namespace {

using world::EquipmentKind;

constexpr double kStopWithin = 0.02;  // m from the stopping point
constexpr double kStopSpeed = 0.05;   // m/s, slow enough to stop
constexpr double kCreep = 0.3;        // m/s, at which tyres push a train that stopped short

double car_place(const Rails& rails, const TrainPlace& train, int car) {
  return within_lap(train.front - car * train.spacing, rails.length, rails.closed);
}

bool inside(const EquipmentSpan& span, double at) { return at >= span.from && at < span.to; }

// Returns true if no car is on a span or within 1 m of it. May return false for a distant train across the track's
// start.
bool far_from(const EquipmentSpan& span, const Rails& rails, const TrainPlace& train, double front) {
  constexpr double kNear = 1;  // m
  const double tail = front - (train.cars - 1) * train.spacing;
  return tail >= 0 && front <= rails.length && (span.from > front + kNear || span.to < tail - kNear);
}

// Returns the fraction of a train's cars on a span.
double share_on(const EquipmentSpan& span, const Rails& rails, const TrainPlace& train) {
  int on = 0;
  for (int i = 0; i < train.cars; ++i) on += inside(span, car_place(rails, train, i));
  return static_cast<double>(on) / train.cars;
}

struct Moment {
  double speed, free, dt;
  // Returns the acceleration that equipment must add to gravity and losses to reach the speed `to`.
  double towards(double to) const { return (to - speed) / dt - free; }
};

// Returns the net acceleration towards a speed, within -brake..push.
double steer(const Moment& now, double to, double push, double brake) {
  return std::clamp((to - now.speed) / now.dt, -brake, push) - now.free;
}

double lift(const world::Equipment& e, const Moment& now) {
  const double ratchet = now.towards(0.0);  // prevents rollback
  const double pull = std::min(now.towards(e.speed), e.acceleration - now.free);
  return std::max({pull, ratchet, 0.0});
}

double launch(const world::Equipment& e, const Moment& now, double share) {
  return std::clamp(now.towards(e.speed), 0.0, e.acceleration * share);
}

double brake(const world::Equipment& e, const Moment& now, double share, ControlState& state) {
  const double speed = std::abs(now.speed);
  if (speed > e.speed + e.hysteresis) state.braking = true;
  if (speed < e.speed - e.hysteresis) state.braking = false;
  if (!state.braking) return 0.0;
  const double most = e.acceleration * share, to_rest = now.towards(0.0);
  return now.speed > 0 ? -std::min(most, std::max(-to_rest, 0.0)) : std::min(most, std::max(to_rest, 0.0));
}

// Returns where a train's first car stops: at the span's end, or so far before it that the train leaves the span at the
// speed of its dispatch, but in its second half.
double stopping_point(const EquipmentSpan& span, const TrainPlace& train) {
  const double speed = span.equipment.speed, run_up = 0.5 * speed * speed / span.equipment.acceleration;
  return span.to - std::clamp(run_up - (train.cars - 1) * train.spacing, 0.0, 0.5 * (span.to - span.from));
}

// Stops a train at its stopping point, waits, and dispatches it. `left`: m to that point.
Drive stop_and_go(const EquipmentSpan& span, const Moment& now, double left, bool way_free, ControlState& state) {
  const world::Equipment& e = span.equipment;
  const double push = e.acceleration;
  if (state.dwell < 0)
    return {std::max(steer(now, std::max<double>(e.speed, kCreep), push, 0.0), now.towards(0.0)), false};
  if (state.dwell > 0) {
    if (state.dwell > 1) --state.dwell;
    else if (way_free) state.dwell = -1;
    return {now.towards(0.0), true};
  }
  if (left <= kStopWithin && now.speed < kStopSpeed) {
    state.dwell =
        1 + static_cast<std::int32_t>(e.kind == EquipmentKind::station ? e.seconds * world::kTicksPerSecond : 0);
    return {now.towards(0.0), true};
  }
  // Follows v^2 = 2 a d down to the stopping point; the brake is three times as strong as needed. Never passes that
  // point.
  const double allowed = std::sqrt(2.0 * push * std::max(left - 0.5 * kStopWithin, 0.0));
  const double target = std::min(std::max<double>(e.speed, kCreep), allowed);
  const double last_step = std::max(left, 0.0) / now.dt;
  return {steer(now, std::min(target, last_step), push, 3.0 * push), false};
}

}  // namespace

std::vector<EquipmentSpan> equipment_spans(const world::Document& document, const Derived& derived) {
  std::vector<EquipmentSpan> spans;
  if (document.entities.pool<world::Equipment>().size() == 0) return spans;
  world::Entity station;  // the section of the previous segment, if that is a station
  for (std::size_t i = 0; i < derived.order.size(); ++i) {
    const auto* const found = document.entities.find<world::Equipment>(derived.order[i]);
    const bool stops = found && found->kind == EquipmentKind::station;
    const world::Entity here = stops ? world::segment(document, derived.order[i]).section : world::kNone;
    const bool goes_on = here.valid() && here == station && spans.back().equipment == *found;
    if (goes_on) spans.back().to = derived.starts[i + 1];
    else if (found) spans.push_back({derived.starts[i], derived.starts[i + 1], derived.order[i], *found});
    station = here;
  }
  return spans;
}

Drive drive_of(std::span<const EquipmentSpan> spans, const Rails& rails, const TrainPlace& train, double speed,
               double free, bool way_free, double dt, ControlState& state) {
  Drive drive;
  bool on_stop = false, on_brake = false;
  const double front = car_place(rails, train, 0);
  for (const EquipmentSpan& span : spans) {
    if (far_from(span, rails, train, front)) continue;
    const double share = share_on(span, rails, train);
    const EquipmentKind kind = span.equipment.kind;
    const bool stops = kind == EquipmentKind::station || kind == EquipmentKind::block;
    // A stopping point may be exactly the span's end: a first car that stands there belongs to it.
    const bool front_on =
        inside(span, front) || (stops && state.dwell > 0 && std::abs(front - span.to) < 2 * kStopWithin);
    if (share == 0 && !front_on) continue;
    const Moment now{speed, free + drive.acceleration,
                     dt};  // includes the effect of other spans: a train on two lifts is pulled once
    if (stops) {
      on_stop = true;
      if (front_on && (kind == EquipmentKind::station || !way_free || state.dwell > 0)) {
        const Drive stop = stop_and_go(span, now, stopping_point(span, train) - front, way_free, state);
        drive.acceleration += stop.acceleration, drive.held |= stop.held;
      } else if (state.dwell < 0) {
        drive.acceleration +=
            std::max(steer(now, std::max<double>(span.equipment.speed, kCreep), span.equipment.acceleration, 0.0), 0.0);
      } else if (kind == EquipmentKind::block) {
        on_brake = true;
        drive.acceleration += brake(span.equipment, now, share, state);
      }
      continue;
    }
    switch (kind) {
      case EquipmentKind::lift: drive.acceleration += lift(span.equipment, now); break;
      case EquipmentKind::launch: drive.acceleration += launch(span.equipment, now, share); break;
      case EquipmentKind::brake:
        on_brake = true;
        drive.acceleration += brake(span.equipment, now, share, state);
        break;
      case EquipmentKind::station:
      case EquipmentKind::block: break;
    }
  }
  if (!on_stop) state.dwell = 0;
  if (!on_brake) state.braking = false;
  return drive;
}

bool section_free(std::span<const EquipmentSpan> spans, const Rails& rails, const TrainPlace& train,
                  std::span<const TrainPlace> others) {
  const auto stops = [](const EquipmentSpan& span) {
    return span.equipment.kind == EquipmentKind::station || span.equipment.kind == EquipmentKind::block;
  };
  const double front = car_place(rails, train, 0);
  const auto here = std::find_if(spans.begin(), spans.end(), [&](const EquipmentSpan& span) {
    return stops(span) && front >= span.from && front <= span.to + 2 * kStopWithin;
  });
  if (here == spans.end()) return true;
  auto next = std::find_if(here + 1, spans.end(), stops);
  if (next == spans.end() && !rails.closed) {  // to the end of the track
    return std::none_of(others.begin(), others.end(), [&](const TrainPlace& t) { return t.front > here->to; });
  }
  if (next == spans.end()) next = std::find_if(spans.begin(), spans.end(), stops);
  const double from = here->to, to = next->to;
  for (const TrainPlace& other : others)
    for (int car = 0; car < other.cars; ++car) {
      const double at = car_place(rails, other, car);
      if (from < to ? at > from && at <= to : at > from || at <= to) return false;
    }
  return true;
}

bool collide(const Rails& rails, const TrainPlace& a, const TrainPlace& b) {
  const double clear = 0.5 * (a.length + b.length);
  for (int i = 0; i < a.cars; ++i)
    for (int j = 0; j < b.cars; ++j) {
      double apart = std::abs(car_place(rails, a, i) - car_place(rails, b, j));
      if (rails.closed) apart = std::min(apart, rails.length - apart);
      if (apart < clear) return true;
    }
  return false;
}

std::optional<std::size_t> first_collision(const Rails& rails, std::span<const TrainPlace> trains,
                                           std::span<const char> left_out) {
  constexpr double kMargin = 1e-3;  // m, for rounding
  struct Reach {
    double from, extent;  // m: the whole train is within [from, from + extent]
    std::size_t train;
  };
  std::vector<Reach> order;
  order.reserve(trains.size());
  for (std::size_t i = 0; i < trains.size(); ++i) {
    if (left_out[i]) continue;
    const TrainPlace& train = trains[i];
    const double extent = (train.cars - 1) * train.spacing + train.length + 2 * kMargin,
                 from = train.front + 0.5 * train.length + kMargin - extent;
    order.push_back({within_lap(from, rails.length, rails.closed), extent, i});
  }
  std::sort(order.begin(), order.end(), [](const Reach& a, const Reach& b) { return a.from < b.from; });
  std::size_t first = trains.size();
  for (std::size_t k = 0; k < order.size(); ++k)
    for (std::size_t n = k + 1; n < k + order.size(); ++n) {
      const bool round = n >= order.size();  // across the track's start
      if (round && !rails.closed) break;
      const Reach &behind = order[k], &ahead = order[round ? n - order.size() : n];
      if (ahead.from + (round ? rails.length : 0.0) > behind.from + behind.extent) break;
      const std::size_t a = std::min(behind.train, ahead.train), b = std::max(behind.train, ahead.train);
      if (a < first && collide(rails, trains[a], trains[b])) first = a;
    }
  return first < trains.size() ? std::optional(first) : std::nullopt;
}

}  // namespace coaster::sim
