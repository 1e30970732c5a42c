// Sound output: the system's device by OpenAL, or none. The caller provides the samples.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>

#include "base/status.h"

namespace coaster::platform {

// Returns "OpenAL", or "none" in a program built without it.
std::string sound_library();

inline constexpr int kSoundRate = 44'100;  // frames a second
inline constexpr int kSoundBlock = 1'024;  // frames, 23 ms
inline constexpr int kSoundBlocks = 4;     // blocks queued in the device: latency of up to 93 ms

class SoundDevice {
 public:
  // Opens the system's default device. Code::refused with the reason if there is none, or the program was built without
  // sound.
  static base::Result<std::unique_ptr<SoundDevice>> open();
  ~SoundDevice();
  SoundDevice(const SoundDevice&) = delete;
  SoundDevice& operator=(const SoundDevice&) = delete;

  // Calls `fill` for every block that has been played: kSoundBlock frames, left and right alternating, within -1..1.
  // Call it at least every 60 ms; after a longer pause playback continues with a gap. Returns the number of blocks
  // filled.
  int feed(const std::function<void(std::span<float>)>& fill);

 private:
  struct Parts;
  explicit SoundDevice(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

}  // namespace coaster::platform
