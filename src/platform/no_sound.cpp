// SoundDevice for a program built without OpenAL.
#include "platform/sound.h"

namespace coaster::platform {

struct SoundDevice::Parts {};

std::string sound_library() { return "none"; }
SoundDevice::SoundDevice(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
SoundDevice::~SoundDevice() = default;
base::Result<std::unique_ptr<SoundDevice>> SoundDevice::open() {
  return base::Status{base::Code::refused, "this program was built without sound (OpenAL)"};
}
int SoundDevice::feed(const std::function<void(std::span<float>)>&) { return 0; }

}  // namespace coaster::platform
