#include "platform/touch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace coaster::platform {

void TouchTranslator::press(Button button, Events& events) {
  button_ = button, down_ = true;
  events.push_back(MouseButton{button, true, {}});
}

void TouchTranslator::release(Events& events) {
  if (!down_) return;
  events.push_back(MouseButton{button_, false, {}});
  down_ = false, away_ = true;
}

bool TouchTranslator::follow(std::span<const Finger> fingers, double now, float scale, Events& events) {
  if (tapped_) {  // the frame after a tap or a long press
    tapped_ = false;
    release(events);
    return fingers.empty() && state_ == State::spent;
  }
  if (fingers.empty()) return follow_none(events);
  if (fingers.size() == 1) return follow_one(fingers[0], now, scale, events);
  return follow_two(fingers[0], fingers[1], events);
}

bool TouchTranslator::follow_none(Events& events) {
  const State before = std::exchange(state_, State::none);
  if (before == State::none && std::exchange(away_, false)) events.push_back(MouseMove{-1, -1, true});
  if (before == State::pending) {
    events.push_back(MouseMove{start_.x, start_.y, true});
    press(Button::left, events);
    tapped_ = true, state_ = State::spent;
    return false;
  }
  release(events);
  return true;
}

bool TouchTranslator::follow_one(const Finger& finger, double now, float scale, Events& events) {
  switch (state_) {
    case State::none: state_ = State::pending, start_ = finger, since_ = now; break;
    case State::pending:
      if (std::hypot(finger.x - start_.x, finger.y - start_.y) > kSlop * scale) {
        events.push_back(MouseMove{start_.x, start_.y, true});
        press(Button::left, events);
        state_ = State::drag;
        return false;
      }
      if (now - since_ >= kLongPress) {
        events.push_back(MouseMove{start_.x, start_.y, true});
        press(Button::right, events);
        tapped_ = true, state_ = State::spent;
      }
      break;
    case State::drag: events.push_back(MouseMove{finger.x, finger.y, true}); break;
    case State::two:
      release(events);
      state_ = State::spent;
      break;
    case State::spent: break;
  }
  return true;
}

bool TouchTranslator::follow_two(const Finger& first, const Finger& second, Events& events) {
  if (state_ == State::spent) return true;
  const MouseMove middle{0.5f * (first.x + second.x), 0.5f * (first.y + second.y), true};
  const float apart = std::max(1.0f, std::hypot(first.x - second.x, first.y - second.y));
  if (state_ != State::two) {
    const bool held = down_;
    release(events);
    state_ = State::two, distance_ = apart;
    if (held) return false;
  }
  events.push_back(middle);
  if (!down_) press(Button::middle, events);
  if (const float notches = std::log(apart / distance_) / std::log(kPerNotch); std::abs(notches) > 0.05f) {
    events.push_back(Wheel{0, notches});
    distance_ = apart;
  }
  return true;
}

}  // namespace coaster::platform
