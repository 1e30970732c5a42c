// Sound on its way out: the system's device by OpenAL, or none. What is played is the caller's affair.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>

#include "base/status.h"

namespace coaster::platform {

// "OpenAL", or "none" in a program built without it.
std::string sound_library();

inline constexpr int kSoundRate = 44'100;  // frames a second
inline constexpr int kSoundBlock = 1'024;  // frames: 23 ms
inline constexpr int kSoundBlocks = 4;     // waiting in the device: what is fed is heard up to 93 ms later

class SoundDevice {
 public:
  // The system's usual device. Code::refused with the reason when there is none, or the program was built without
  // sound.
  static base::Result<std::unique_ptr<SoundDevice>> open();
  ~SoundDevice();
  SoundDevice(const SoundDevice&) = delete;
  SoundDevice& operator=(const SoundDevice&) = delete;

  // Calls `fill` for every block that has been played: kSoundBlock frames, left and right in turn, within -1..1. To be
  // called at least every 60 ms; after a longer pause it goes on where it stopped, with a gap. Returns the blocks that
  // were filled.
  int feed(const std::function<void(std::span<float>)>& fill);

 private:
  struct Parts;
  explicit SoundDevice(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace coaster::platform
