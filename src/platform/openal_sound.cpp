// SoundDevice by OpenAL 1.1: one source with a queue of blocks.
#include <AL/al.h>
#include <AL/alc.h>
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "platform/sound.h"

namespace coaster::platform {

struct SoundDevice::Parts {
  ALCdevice* device = nullptr;
  ALCcontext* context = nullptr;
  ALuint source = 0;
  std::array<ALuint, kSoundBlocks> buffers{};
  std::vector<ALuint> unused;  // buffers not in the queue
  std::vector<float> samples = std::vector<float>(2 * kSoundBlock);
  std::vector<std::int16_t> words = std::vector<std::int16_t>(2 * kSoundBlock);

  ~Parts() {
    if (context) {
      alcMakeContextCurrent(context);
      if (source) {
        alSourceStop(source);
        alDeleteSources(1, &source);
      }
      if (buffers[0]) alDeleteBuffers(kSoundBlocks, buffers.data());
      alcMakeContextCurrent(nullptr);
      alcDestroyContext(context);
    }
    if (device) alcCloseDevice(device);
  }
};

namespace {

// The libraries below OpenAL print errors about missing devices to stderr. A missing device is no error here; the
// settings show it.
class QuietErrors {
 public:
  QuietErrors() {
    std::fflush(stderr);
    kept_ = dup(STDERR_FILENO);
    const int nothing = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (kept_ >= 0 && nothing >= 0) dup2(nothing, STDERR_FILENO);
    if (nothing >= 0) close(nothing);
  }
  ~QuietErrors() {
    if (kept_ < 0) return;
    dup2(kept_, STDERR_FILENO);
    close(kept_);
  }
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;

 private:
  int kept_ = -1;
};

}  // namespace

std::string sound_library() { return "OpenAL"; }

SoundDevice::SoundDevice(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
SoundDevice::~SoundDevice() = default;

base::Result<std::unique_ptr<SoundDevice>> SoundDevice::open() {
  auto parts = std::make_unique<Parts>();
  {
    const QuietErrors quiet;
    parts->device = alcOpenDevice(nullptr);
  }
  if (!parts->device) return base::Status{base::Code::refused, "there is no sound device"};
  parts->context = alcCreateContext(parts->device, nullptr);
  if (!parts->context || !alcMakeContextCurrent(parts->context))
    return base::Status{base::Code::refused, "the sound device has no OpenAL context"};
  alGetError();
  alGenBuffers(kSoundBlocks, parts->buffers.data());
  alGenSources(1, &parts->source);
  if (alGetError() != AL_NO_ERROR) return base::Status{base::Code::refused, "the sound device has no free source"};
  parts->unused.assign(parts->buffers.begin(), parts->buffers.end());
  return std::unique_ptr<SoundDevice>(new SoundDevice(std::move(parts)));
}

int SoundDevice::feed(const std::function<void(std::span<float>)>& fill) {
  Parts& p = *parts_;
  ALint played = 0;
  alGetSourcei(p.source, AL_BUFFERS_PROCESSED, &played);
  for (; played > 0; --played) {
    ALuint buffer = 0;
    alSourceUnqueueBuffers(p.source, 1, &buffer);
    if (buffer) p.unused.push_back(buffer);
  }
  int filled = 0;
  for (; !p.unused.empty(); ++filled) {
    fill(p.samples);
    for (std::size_t i = 0; i < p.samples.size(); ++i)
      p.words[i] = static_cast<std::int16_t>(std::lround(32'767.0f * p.samples[i]));
    alBufferData(p.unused.back(), AL_FORMAT_STEREO16, p.words.data(),
                 static_cast<ALsizei>(p.words.size() * sizeof p.words[0]), kSoundRate);
    alSourceQueueBuffers(p.source, 1, &p.unused.back());
    p.unused.pop_back();
  }
  ALint state = 0;
  alGetSourcei(p.source, AL_SOURCE_STATE, &state);
  if (state != AL_PLAYING) alSourcePlay(p.source);  // at the start, and after a gap
  return filled;
}

}  // namespace coaster::platform
