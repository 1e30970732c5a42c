// The ghost's train: its motion over tables of the rails, tick by tick. For ghost.cpp.
#pragma once

#include <cmath>
#include <functional>
#include <span>
#include <vector>

#include "sim/ride/equipment.h"
#include "sim/ride/ghost_tables.h"
#include "sim/ride/train.h"

namespace coaster::sim {

class GhostTrain {
 public:
  // Refers to its arguments.
  GhostTrain(const RailTables& tables, std::span<const SegmentTable* const> segments,
             std::span<const EquipmentSpan> equipment, const world::Resistance& resistance, const GhostStart& start)
      : equipment_(equipment),
        resistance_(resistance),
        landscape_(tables, segments, start.cars, start.spacing),
        rails_{tables.length(), tables.closed()},
        control_(start.control),
        place_{start.front, start.cars, start.spacing, start.length},
        moving_{start.front, start.speed, 0},
        losses_(!(resistance == world::Resistance{})) {
    settle();
  }

  const TrainState& state() const { return moving_; }   // x: m from the track's start, unwrapped
  double in_lap() const { return moving_.x - round_; }  // m from the start of the lap, of the first car
  bool held() const { return drive_.held; }
  // Returns the acceleration along the rails, m/s^2.
  double acceleration() const {
    if (drive_.net) return drive_.acceleration;
    return gravity_here_ + (drive_.acceleration - direction() * loss(resistance_, moving_.speed));
  }
  // Returns those of the last tick; `travelled` is state().x, `sample` 0.
  std::span<const GhostSwitch> switches() const { return switches_; }

  // Advances by a tick, in parts that end where equipment switches. Returns false at an open end.
  bool advance() {
    constexpr int kMostParts = 64;
    double dt = world::kTick;
    bool on_track = true;
    if (equipment_.empty()) return advance(dt);
    count_down(true, control_);
    switches_.clear(), switched_ = 0;
    for (int part = 0; dt > 0 && part < kMostParts && on_track; ++part) {
      place_.front = in_lap();
      contacts_ = &near_.update(equipment_, rails_, place_, moving_.x, moving_.speed < 0);
      const Drive next = drive_at(moving_, control_);
      if (!(next == drive_)) {
        switches_.push_back({0, moving_.x, moving_.speed, acceleration(), 0});
        drive_ = next;
        switches_.back().acceleration_after = acceleration();
      }
      if (drive_.held) {
        moving_.work -= 0.5 * moving_.speed * moving_.speed;
        moving_.speed = 0;
        break;
      }
      on_track = advance(dt);
    }
    return on_track;
  }

 private:
  double gravity(double at) { return -world::kGravity * landscape_.slope(at - round_); }
  // Updates the gravity after each move, which is used several times, and the start of the train's lap.
  void settle() {
    if (rails_.closed && !(moving_.x >= round_ && moving_.x < round_ + rails_.length))
      round_ = rails_.length * std::floor(moving_.x / rails_.length);
    gravity_here_ = gravity(moving_.x);
  }
  double direction() const {
    return direction_of(moving_.speed, resistance_, [&] { return gravity_here_ + drive_.acceleration; });
  }

  // Returns the drive from a moment on. Updates `control`.
  Drive drive_at(const TrainState& at, ControlState& control) {
    const std::function<double()> free = [&] {
      const double pull = gravity(at.x);
      return pull - direction_of(at.speed, resistance_, [&] { return pull; }) * loss(resistance_, at.speed);
    };
    return drive_of(*contacts_, place_, {at.x - round_, at.speed, free}, true, control);
  }

  // Advances by at most `dt`, which is the time left afterwards. Returns false at an open end.
  bool advance(double& dt) {
    double used = dt;
    const double sign = drive_.net ? 0.0 : direction(), drive = drive_.acceleration;
    dt = 0;
    if (!drive_.net && moving_.speed == 0 && sign == 0 && resistance_.rolling > 0) return true;  // held by friction
    const auto rates = [&](const TrainState& m, double pull) {
      if (drive_.net) return TrainRates{m.speed, drive, (drive - pull) * m.speed};
      const double others = drive - sign * loss(resistance_, m.speed);
      return TrainRates{m.speed, pull + others, others * m.speed};
    };
    const auto after = [&](double time) {
      return runge_kutta(moving_, rates(moving_, gravity_here_), time,
                         [&](const TrainState& m) { return rates(m, gravity(m.x)); });
    };
    TrainState next = after(used);
    const double left = used;
    const auto cut = [&](const auto& value, double within = 1e-15) {
      used = time_of(moving_, used, after, value, within), next = after(used);
    };
    if (!equipment_.empty()) cut_at_switches(next, cut);
    dt = left - used;
    if (losses_ && sign != 0 && next.speed * sign < 0) {  // friction stops it and does not reverse it
      const double part = moving_.speed / (moving_.speed - next.speed);
      next = {moving_.x + part * (next.x - moving_.x), 0.0, moving_.work + part * (next.work - moving_.work)};
    }
    const bool on_track = rails_.closed || (next.x >= 0 && next.x <= rails_.length);
    if (!on_track) {
      const bool back = next.x < 0;
      const double end = back ? 0.0 : rails_.length;
      cut([&](const TrainState& at) { return back ? end - at.x : at.x - end; });
      next.x = end;
    }
    moving_ = next;
    settle();
    return on_track;
  }

  // Ends a part that leads to `next` where a car comes to an end of equipment, where friction stops the train, or where
  // the drive changes.
  template <class Cut>
  void cut_at_switches(TrainState& next, const Cut& cut) {
    const double ahead = near_.ahead(), behind = near_.behind(), from = moving_.speed;
    if (next.x > ahead) cut([&](const TrainState& at) { return at.x - ahead; });
    if (next.x < behind) cut([&](const TrainState& at) { return behind - at.x; });
    if (losses_ && !drive_.net && next.speed * from < 0) {
      cut([&](const TrainState& at) { return from > 0 ? -at.speed : at.speed; });
      next.speed = 0;
    }
    const auto switches = [&](const TrainState& at) {
      ControlState then = control_;
      return drive_at(at, then) == drive_ && then == control_ ? -1.0 : 1.0;
    };
    if (!contacts_->on.empty() && switched_ < kMostSwitches && switches(next) > 0)
      ++switched_, cut(switches, kSwitchWithin);
  }

  std::span<const EquipmentSpan> equipment_;
  world::Resistance resistance_;
  Landscape landscape_;
  Rails rails_;
  ControlState control_;
  TrainPlace place_;
  TrainContacts near_;
  const Contacts* contacts_ = nullptr;  // the present ones
  Drive drive_;
  std::vector<GhostSwitch> switches_;
  int switched_ = 0;  // in this tick
  TrainState moving_;
  double round_ = 0, gravity_here_ = 0;  // m, m/s^2
  bool losses_;
};

}  // namespace coaster::sim
