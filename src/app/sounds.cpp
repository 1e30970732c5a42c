#include "app/sounds.h"

#include "app/program.h"
#include "base/text.h"
#include "world/appearance_settings.h"

namespace coaster::app {

void keep_sounding(Program& program) {
  Sounds& sounds = program.sounds;
  const edit::Session& session = program.session;
  const double volume = session.settings.look->sound;
  const bool wanted = volume > 0;
  if (!wanted) {
    sounds.refused = false;
    if (sounds.device && sounds.voice.heard.volume < 1e-3) {  // otherwise it fades out first
      program.surface->end_sound();
      sounds.device.reset();
    }
  }
  if (wanted && !sounds.device && !sounds.refused) {
    auto device = platform::SoundDevice::open();
    if (device) {
      sounds.device = std::move(*device);
    } else {
      sounds.refused = true;
      if (sounds.refusals++ > 0)
        edit::notify(program.session, edit::NoticeKind::info,
                     base::sentence("sound is off: " + device.status().message));
    }
  }
  if (!sounds.device) return;
  const view::RideNoise noise = recording(program)
                                    ? view::RideNoise{}
                                    : view::ride_noise(session.document, session.derived, session.motion, volume,
                                                       &edit::SessionFindings(program.session).ground());
  sounds.device->feed(
      [&](std::span<float> block) { view::synthesise(sounds.voice, noise, platform::kSoundRate, block); });
}

}  // namespace coaster::app
