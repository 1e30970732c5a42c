// The ride's sound in a window: opens the device when sound is on, and feeds it.
#pragma once

#include <memory>

#include "platform/sound.h"
#include "view/ride_sound.h"

namespace coaster::app {

struct Program;

struct Sounds {
  std::unique_ptr<platform::SoundDevice> device;  // null: sound is off, or there is no device
  bool refused = false;                           // no device; tried again when sound is turned off and on
  int refusals = 0;                               // the first refusal, at the start, is not reported: sound is optional
  view::RideVoice voice;
};

// Updates the sound; call it once per frame of a window. Silent while a movie is recorded, because its time is not real
// time.
void keep_sounding(Program& program);

}  // namespace coaster::app
