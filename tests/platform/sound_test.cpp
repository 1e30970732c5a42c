// The sound device, on OpenAL Soft's null backend, which consumes samples at the rate of the clock.
#include "platform/sound.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <thread>

namespace coaster::platform {
namespace sound_test {

std::unique_ptr<SoundDevice> silent_device() {
  ::setenv("ALSOFT_DRIVERS", "null", 1);
  auto device = SoundDevice::open();
  return device ? std::move(*device) : nullptr;
}

TEST(sound, a_device_takes_its_blocks_at_first_and_one_for_each_that_was_played) {
  if (sound_library() == "none") GTEST_SKIP() << "built without sound";
  const auto device = silent_device();
  ASSERT_TRUE(device);
  const auto now = [] { return std::chrono::steady_clock::now(); };
  const auto start = now();
  std::size_t frames = 0;
  const auto fill = [&](std::span<float> block) {
    for (std::size_t i = 0; i < block.size(); ++i) block[i] = i % 2 == 0 ? 1.0f : -1.0f;
    frames += block.size() / 2;
  };
  EXPECT_EQ(device->feed(fill), kSoundBlocks);
  EXPECT_EQ(frames, static_cast<std::size_t>(kSoundBlocks * kSoundBlock));
  const int again = device->feed(fill);
  const double seconds =
      std::chrono::duration<double>(now() - start).count();  // a busy machine may have kept this process waiting
  EXPECT_LE(again, 1 + static_cast<int>(seconds * kSoundRate / kSoundBlock)) << "no more can have been played yet";
  // Waits, up to 5 s on a busy machine, until 0.3 s of sound have been requested.
  for (int i = 0; i < 500 && frames < 3 * kSoundRate / 10; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    device->feed(fill);
  }
  EXPECT_GE(frames, static_cast<std::size_t>(3 * kSoundRate / 10));
}

TEST(sound, a_device_that_starved_goes_on) {
  if (sound_library() == "none") GTEST_SKIP() << "built without sound";
  const auto device = silent_device();
  ASSERT_TRUE(device);
  const auto fill = [](std::span<float> block) { std::fill(block.begin(), block.end(), 0.0f); };
  device->feed(fill);
  std::this_thread::sleep_for(std::chrono::milliseconds(250));  // longer than all blocks together
  int filled = 0;
  for (int i = 0; i < 500 && filled < kSoundBlocks; ++i) {
    filled += device->feed(fill);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_GE(filled, kSoundBlocks);
}

TEST(sound, can_be_opened_again_and_says_why_when_it_cannot) {
  for (int i = 0; i < 3 && sound_library() != "none"; ++i) EXPECT_TRUE(silent_device());
  ::setenv("ALSOFT_DRIVERS", "-all", 1);  // no backend at all
  const auto none = SoundDevice::open();
  if (!none) {
    EXPECT_EQ(none.status().code, base::Code::refused);
    EXPECT_NE(none.status().message.find("sound"), std::string::npos);
  }
  ::setenv("ALSOFT_DRIVERS", "null", 1);
}

}  // namespace sound_test
}  // namespace coaster::platform
