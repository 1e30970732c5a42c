// The ride's sound in a window: opens the device when sound is on, and feeds it.
#pragma once

#include <memory>

#include "platform/sound.h"
#include "view/ride_sound.h"

namespace coaster::app {

struct Program;

struct Sounds {
  std::unique_ptr<platform::SoundDevice> device;  // null: sound is off, or there is no device
  bool refused = false;                           // tried again when sound is turned off and on
  int refusals = 0;                               // the first one, at the start, is not reported: sound is optional
  view::RideVoice voice;
};

// Once per frame of a window. Silent while a movie is recorded, because its time is not the clock's.
void keep_sounding(Program& program);

}  // namespace coaster::app
