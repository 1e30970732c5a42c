#include "sim/ride/equipment.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace coaster::sim {
namespace {

using world::EquipmentKind;

constexpr double kStopWithin = 0.02;  // m from the stopping point
constexpr double kCreep = 0.3;        // m/s, at which tyres push a train that stopped short
constexpr double kReached = 1e-10;    // m/s from a speed that counts as reached
constexpr double kBorder = 1e-8;      // m from a border that counts as past it
constexpr double kNarrow = 0.005;     // m/s, the hysteresis below which a brake holds its lower speed

double car_place(const TrackExtent& rails, const TrainPlace& train, int car) {
  return within_lap(train.front - car * train.spacing, rails.length, rails.closed);
}

bool inside(const EquipmentSpan& span, double at) { return at >= span.from && at < span.to; }

// What a kind does besides what is its own.
struct KindEffects {
  bool stops = false, brakes = false;  // at its end; while a train is too fast
};
KindEffects acts_of(EquipmentKind kind) {
  switch (kind) {
    case EquipmentKind::station: return {.stops = true};
    case EquipmentKind::lift:
    case EquipmentKind::launch: return {};
    case EquipmentKind::brake: return {.brakes = true};
    case EquipmentKind::block: return {.stops = true, .brakes = true};
  }
  return {};
}
bool stops(const EquipmentSpan& span) { return acts_of(span.equipment.kind).stops; }
bool brakes(const EquipmentSpan& span) { return acts_of(span.equipment.kind).brakes; }

// What the spans that were looked at so far do together.
class CombinedDrive {
 public:
  explicit CombinedDrive(const TrainMoment& now) : now_(now) {}
  const Drive& drive() const { return drive_; }
  double acceleration() const { return drive_.net ? drive_.acceleration : now_.free() + drive_.acceleration; }
  void add(double acceleration) { drive_.acceleration += drive_.held ? 0.0 : acceleration; }
  void set(double acceleration) {
    if (!drive_.held) drive_ = {acceleration, true};
  }
  void hold() { drive_ = {0, true, true}; }
  void at_least(double least) {
    if (acceleration() < least) set(least);
  }
  // Keeps the speed by a force of `least`..`most`, or does what it can.
  void keep_speed(double least, double most) {
    const double need = -acceleration();
    if (need > least && need < most) set(0);
    else add(need > 0 ? most : least);
  }
  // Returns -1, 0 or 1: slower than a speed, at it, faster.
  int compare(double speed, double to, const world::Equipment& e) const {
    const double reached = kReached + e.acceleration * now_.step;
    return speed < to - reached ? -1 : speed > to + reached ? 1 : 0;
  }

 private:
  const TrainMoment& now_;
  Drive drive_;
};

double dispatch_speed(const world::Equipment& e) { return std::max<double>(e.speed, kCreep); }

// Pushes a train until it has the speed `to`, and keeps it from falling below.
void push(const world::Equipment& e, double to, double speed, CombinedDrive& driving) {
  const int fast = driving.compare(speed, to, e);
  if (fast <= 0) driving.at_least(fast < 0 ? double{e.acceleration} : 0.0);
}

void lift(const world::Equipment& e, double speed, CombinedDrive& driving) {
  if (driving.compare(speed, 0, e) < 0) return driving.hold();  // the ratchet catches a train that rolls back
  push(e, e.speed, speed, driving);
}

bool too_fast(const world::Equipment& e, double speed) { return std::abs(speed) > e.speed + e.hysteresis; }
bool too_slow(const world::Equipment& e, double speed) { return std::abs(speed) < e.speed - e.hysteresis - kReached; }

// True if a launch, or a brake that works, is at a speed that it keeps. A brake holds a train at rest; with next to no
// hysteresis it would switch many times a tick, and keeps its lower speed.
bool keeps(const world::Equipment& e, double speed, const CombinedDrive& driving) {
  if (e.kind == EquipmentKind::launch) return driving.compare(speed, e.speed, e) == 0;
  const bool low = e.hysteresis < kNarrow && driving.compare(std::abs(speed), e.speed - e.hysteresis, e) == 0;
  return low || driving.compare(speed, 0, e) == 0;
}

// Adds the force of a launch or brake of which a share of the train is on it, or keeps the speed by it.
void act(const world::Equipment& e, double share, double speed, CombinedDrive& driving) {
  const double most = e.acceleration * share, sign = speed > 0 ? 1.0 : -1.0;
  const bool launches = e.kind == EquipmentKind::launch, rests = driving.compare(speed, 0, e) == 0;
  if (!keeps(e, speed, driving)) return driving.add(launches ? most : -sign * most);
  const bool forwards = launches || rests || sign < 0, backwards = !launches && (rests || sign > 0);
  driving.keep_speed(backwards ? -most : 0, forwards ? most : 0);
}

// Returns where a train's first car stops: at the span's end, or so far before it that the train leaves the span at the
// speed of its dispatch, but in its second half.
double stopping_point(const EquipmentSpan& span, const TrainPlace& train) {
  const double speed = span.equipment.speed, run_up = 0.5 * speed * speed / span.equipment.acceleration;
  return span.to - std::clamp(run_up - (train.cars - 1) * train.spacing, 0.0, 0.5 * (span.to - span.from));
}

// Drives a train to its stopping point along v^2 = 2 a d, and on from there. The brake is three times as strong as
// that needs. `left`: m to where it comes to rest.
void stop_and_go(const EquipmentSpan& span, double left, const TrainMoment& now, CombinedDrive& driving,
                 ControlState& state) {
  const world::Equipment& e = span.equipment;
  const double push = e.acceleration, cruise = dispatch_speed(e);
  const int fast = driving.compare(now.speed, cruise, e);
  if (state.dwell < 0) return driving.set(fast < 0 ? push : 0.0);
  const int moves = driving.compare(now.speed, 0, e);
  if (moves == 0 && left <= 0.5 * kStopWithin && state.dwell == 0)
    state.dwell =
        1 + static_cast<std::int32_t>(e.kind == EquipmentKind::station ? e.seconds * world::kTicksPerSecond : 0);
  if (state.dwell > 0) return driving.hold();
  const double excess = now.speed * std::abs(now.speed) - 2.0 * push * std::max(left, 0.0),
               on_curve = 1e-9 + 2.0 * push * std::abs(now.speed) * now.step;  // m^2/s^2
  if (excess > on_curve || fast > 0) driving.set(-3.0 * push);
  else if (moves > 0 && excess >= -on_curve) driving.set(-push);
  else driving.set(fast < 0 ? push : 0.0);
}

// What a piece does to a train now, in the order in which it is done: those that keep a speed follow those that add to
// the acceleration, and see the sum, so that no two take turns. The tyres that dispatch a train push beside a launch.
enum class Role { dispatch, add, keep, lift, hold, stop, none };
Role role_of(const EquipmentContact& contact, double speed, bool way_free, const ControlState& state,
             const CombinedDrive& driving) {
  const world::Equipment& e = contact.span->equipment;
  if (e.kind == EquipmentKind::lift) return Role::lift;
  if (stops(*contact.span)) {
    if (contact.front && (e.kind == EquipmentKind::station || !way_free || state.dwell > 0)) return Role::stop;
    if (state.dwell < 0) return driving.compare(speed, dispatch_speed(e), e) < 0 ? Role::dispatch : Role::hold;
  }
  const bool works = e.kind == EquipmentKind::launch ? driving.compare(speed, e.speed, e) <= 0
                                                     : brakes(*contact.span) && state.braking && !too_slow(e, speed);
  return !works ? Role::none : keeps(e, speed, driving) ? Role::keep : Role::add;
}

}  // namespace

std::vector<EquipmentSpan> equipment_spans(const world::Document& document, const DerivedTrack& derived) {
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

Contacts contacts_of(std::span<const EquipmentSpan> spans, const TrackExtent& rails, const TrainPlace& train,
                     bool back) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const double border = back ? -kBorder : kBorder;
  Contacts contacts{{}, kNever, kNever, back};
  for (const EquipmentSpan& span : spans) {
    int on = 0;
    bool front = false;
    for (int car = 0; car < train.cars; ++car) {
      const double at = within_lap(train.front + border - car * train.spacing, rails.length, rails.closed);
      on += inside(span, at);
      front = front || (car == 0 && inside(span, at));
      for (const double end : {span.from, span.to}) {
        double ahead = end - at;
        if (ahead <= 0 && rails.closed) ahead += rails.length;
        if (ahead > 0) contacts.ahead = std::min(contacts.ahead, ahead + border);
        double behind = at - end;
        if (behind < 0 && rails.closed) behind += rails.length;
        if (behind >= 0) contacts.behind = std::min(contacts.behind, behind - border);
      }
    }
    if (on > 0) contacts.on.push_back({&span, static_cast<double>(on) / train.cars, front});
  }
  return contacts;
}

const Contacts& TrainContacts::update(std::span<const EquipmentSpan> spans, const TrackExtent& rails,
                                      const TrainPlace& train, double at, bool back) {
  const bool past = at > ahead() - 0.5 * kBorder || at < behind() + 0.5 * kBorder;
  if (past || back != contacts_.back) contacts_ = contacts_of(spans, rails, train, back), at_ = at;
  return contacts_;
}

Drive drive_of(const Contacts& contacts, const TrainPlace& train, const TrainMoment& now, bool way_free,
               ControlState& state) {
  CombinedDrive driving(now);
  const auto any = [&](auto is) { return std::any_of(contacts.on.begin(), contacts.on.end(), is); };
  if (!any([](const EquipmentContact& c) { return stops(*c.span); })) state.dwell = 0;
  const bool on =
      any([&](const EquipmentContact& c) { return brakes(*c.span) && too_fast(c.span->equipment, now.speed); });
  const bool keeps =
      any([&](const EquipmentContact& c) { return brakes(*c.span) && !too_slow(c.span->equipment, now.speed); });
  state.braking = on || (state.braking && keeps);
  for (const EquipmentContact& contact : contacts.on) {
    const bool rests = contact.front && driving.compare(now.speed, 0, contact.span->equipment) == 0;
    if (contact.span->equipment.kind == EquipmentKind::block && rests && way_free && state.dwell == 0) state.dwell = -1;
  }
  for (const Role role : {Role::dispatch, Role::add, Role::keep, Role::lift, Role::hold, Role::stop})
    for (const EquipmentContact& contact : contacts.on) {
      const world::Equipment& e = contact.span->equipment;
      if (role_of(contact, now.speed, way_free, state, driving) != role) continue;
      if (role == Role::lift) lift(e, now.speed, driving);
      else if (role == Role::dispatch || role == Role::hold) push(e, dispatch_speed(e), now.speed, driving);
      else if (role == Role::stop)
        stop_and_go(*contact.span, stopping_point(*contact.span, train) - 0.5 * kStopWithin - now.front, now, driving,
                    state);
      else act(e, contact.share, now.speed, driving);
    }
  return driving.drive();
}

void count_down(bool way_free, ControlState& state) {
  if (state.dwell > 1) --state.dwell;
  else if (state.dwell == 1 && way_free) state.dwell = -1;
}

std::string deadlock_text(const world::Document& document, const DerivedTrack& derived) {
  const std::size_t trains = document.entities.pool<world::Train>().size();
  if (trains < 2 || !derived.closed) return {};
  const std::vector<EquipmentSpan> spans = equipment_spans(document, derived);
  const auto sections = static_cast<std::size_t>(std::count_if(spans.begin(), spans.end(), stops));
  if (sections == 0 || sections > trains) return {};
  return fmt::format("{} trains need {} block sections, the track has {}", trains, trains + 1, sections);
}

bool section_free(std::span<const EquipmentSpan> spans, const TrackExtent& rails, const TrainPlace& train,
                  std::span<const TrainPlace> others) {
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

bool collide(const TrackExtent& rails, const TrainPlace& a, const TrainPlace& b) {
  const double clear = 0.5 * (a.length + b.length);
  for (int i = 0; i < a.cars; ++i)
    for (int j = 0; j < b.cars; ++j) {
      double apart = std::abs(car_place(rails, a, i) - car_place(rails, b, j));
      if (rails.closed) apart = std::min(apart, rails.length - apart);
      if (apart < clear) return true;
    }
  return false;
}

std::optional<std::size_t> first_collision(const TrackExtent& rails, std::span<const TrainPlace> trains,
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
