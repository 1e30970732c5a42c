// The ride's sound in a window: opens the device when sound is wanted, and keeps it fed.
#pragma once

#include <memory>

#include "platform/sound.h"
#include "view/ride_sound.h"

namespace coaster::app {

struct Program;

struct Sounds {
  std::unique_ptr<platform::SoundDevice> device;  // null: none is wanted, or there is none
  bool refused = false;                           // tried again when sound is turned off and on
  int refusals = 0;  // the first one, at the start, is not told: sound is no more than an extra
  view::RideVoice voice;
};

// Once a frame of a window. Silent while a movie is recorded, whose time is not that of the clock.
void keep_sounding(Program& program);

}  // namespace coaster::app
