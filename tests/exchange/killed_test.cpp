// Processes that are killed while they save: at any moment, the file is a complete saved one.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <ctime>
#include <random>
#include <set>

#include "base/scratch_folder.h"
#include "base/tries.h"
#include "exchange/formats.h"
#include "exchange/own/autosave.h"

namespace coaster::exchange {
namespace killed_test {

namespace fs = std::filesystem;

world::Document document_of(int serial) {
  world::Document document;
  document.name = std::to_string(serial) + std::string(150, 'n');
  document.start_speed = serial;
  return document;
}

void wait_microseconds(unsigned microseconds) {
  const timespec time{0, static_cast<long>(microseconds) * 1000};
  ::nanosleep(&time, nullptr);
}

// Runs `work` in a child process and kills it that long after it was done for the first time: a new process may take
// longer to get there than to be done again.
template <class Work>
void killed_after(unsigned microseconds, Work work) {
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);  // kill(-1) would end every process
  if (child == 0) {
    work(1);
    (void)!::write(ready[1], "", 1);
    for (int serial = 2;; serial = serial % 100 + 1) work(serial);
  }
  ::close(ready[1]);
  char byte = 0;
  const ssize_t worked = ::read(ready[0], &byte, 1);
  ::close(ready[0]);
  wait_microseconds(microseconds);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  ASSERT_EQ(worked, 1) << "the process ended by itself";
}

// Returns how long `work` takes on this machine now, in microseconds: kills must happen before, in and after it.
template <class Work>
unsigned duration_of(Work work) {
  constexpr int kTimes = 20;
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < kTimes; ++i) work(i);
  return static_cast<unsigned>(
      std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - start).count() / kTimes);
}

class killed : public testing::Test {
 protected:
  std::size_t entries() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }

  test::ScratchFolder scratch;
  fs::path folder = scratch.path();
  base::Files files;
  std::mt19937 bits{20120607};
};

TEST_F(killed, a_thousand_kills_during_save_leave_no_unreadable_file) {
  const fs::path file = folder / "track.json";
  ASSERT_TRUE(save_track(files, file, document_of(0)));
  const unsigned longest = std::clamp(
      4 * duration_of([&](int serial) { (void)save_track(files, file, document_of(serial)); }), 2000u, 16000u);
  std::size_t most = 0;
  std::set<std::string> seen;
  for (int kill = 0; kill < test::tries(1000); ++kill) {
    killed_after(200 + bits() % longest, [&](int serial) { (void)save_track(files, file, document_of(serial)); });
    const auto track = load_track(files, file);
    ASSERT_TRUE(track) << track.status().message;
    const int serial = static_cast<int>(track->document.start_speed);
    ASSERT_EQ(world::hash(track->document), world::hash(document_of(serial)));
    seen.insert(track->document.name);
    most = std::max(most, entries());
  }
  EXPECT_GT(seen.size(), 2u) << "the processes did get to save";
  EXPECT_GT(most, 1u) << "some were killed in the middle of it, with their temporary file there";
  EXPECT_LE(most, 2u) << "and each next save removed what was left";
  ASSERT_TRUE(save_track(files, file, document_of(7)));
  EXPECT_EQ(entries(), 1u);
}

TEST_F(killed, an_autosave_is_found_whole_whenever_its_program_was_killed) {
  Autosave measured;
  const unsigned longest = std::clamp(
      8 * duration_of([&](int serial) { (void)measured.write(files, folder, document_of(serial), "", serial); }), 8000u,
      40000u);
  measured.remove();
  int found_some = 0;
  for (int kill = 0; kill < 100; ++kill) {
    killed_after(2000 + bits() % longest, [&](int serial) {
      static Autosave own;
      (void)own.write(files, folder, document_of(serial), "", serial);
    });
    auto found = find_autosaves(files, folder);
    ASSERT_LE(found.size(), 1u);
    if (!found.empty()) {
      ++found_some;
      const auto track = load_track(files, found.front().info.track);
      ASSERT_TRUE(track) << track.status().message;
      EXPECT_EQ(track->document.name, found.front().info.name);
      EXPECT_EQ(track->document.start_speed, static_cast<double>(found.front().info.time));
      discard(files, found.front());
    }
    found.clear();
    (void)find_autosaves(files, folder);
    for (const auto& entry : fs::directory_iterator(folder))
      EXPECT_TRUE(entry.path().string().ends_with(".lock")) << entry.path();
  }
  EXPECT_GT(found_some, 10);
}

}  // namespace killed_test
}  // namespace coaster::exchange
