#include "base/file_lock.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>

#include "base/files.h"
#include "base/scratch_folder.h"

namespace coaster::base {
namespace file_lock_test {

namespace fs = std::filesystem;
using Outcome = LockAttempt::Outcome;

class file_lock : public testing::Test {
 protected:
  file_lock() { std::ofstream(folder / "a.json") << "x"; }
  fs::path lock_file() const { return folder / ".a.json.lock"; }

  // A process that holds the lock until it is killed.
  pid_t holder() {
    int ready[2];
    EXPECT_EQ(::pipe(ready), 0);
    const pid_t child = ::fork();
    if (child < 0) std::abort();  // kill(-1) would end every process
    if (child == 0) {
      const LockAttempt attempt = try_lock(folder / "a.json");
      const char byte = attempt.outcome == Outcome::taken ? '1' : '0';
      if (::write(ready[1], &byte, 1) == 1) ::pause();
      ::_exit(0);
    }
    char byte = 0;
    EXPECT_EQ(::read(ready[0], &byte, 1), 1);
    EXPECT_EQ(byte, '1');
    ::close(ready[0]), ::close(ready[1]);
    return child;
  }

  test::ScratchFolder scratch;
  fs::path folder = scratch.path();
};

TEST_F(file_lock, one_at_a_time_and_gone_when_it_is_let_go) {
  {
    const LockAttempt first = try_lock(folder / "a.json");
    ASSERT_EQ(first.outcome, Outcome::taken);
    EXPECT_TRUE(fs::exists(lock_file()));
    const LockAttempt second = try_lock(folder / "a.json");
    EXPECT_EQ(second.outcome, Outcome::held);
    EXPECT_EQ(second.holder, "process " + std::to_string(::getpid()));
  }
  EXPECT_FALSE(fs::exists(lock_file()));
  EXPECT_EQ(try_lock(folder / "a.json").outcome, Outcome::taken);
}

TEST_F(file_lock, another_process_is_named_and_its_death_frees_the_lock) {
  const pid_t child = holder();
  const LockAttempt held = try_lock(folder / "a.json");
  EXPECT_EQ(held.outcome, Outcome::held);
  EXPECT_EQ(held.holder, "process " + std::to_string(child));
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_TRUE(fs::exists(lock_file())) << "a killed process removes nothing";
  EXPECT_EQ(try_lock(folder / "a.json").outcome, Outcome::taken);
}

TEST_F(file_lock, links_lead_to_the_same_lock) {
  fs::create_directory(folder / "deep");
  fs::create_symlink("../a.json", folder / "deep" / "link.json");
  const LockAttempt first = try_lock(folder / "deep" / "link.json");
  ASSERT_EQ(first.outcome, Outcome::taken);
  EXPECT_TRUE(first.lock.covers(folder / "a.json"));
  EXPECT_TRUE(first.lock.covers(folder / "deep" / ".." / "a.json"));
  EXPECT_FALSE(first.lock.covers(folder / "b.json"));
  EXPECT_EQ(try_lock(folder / "a.json").outcome, Outcome::held);
}

TEST_F(file_lock, a_folder_that_is_not_there_has_none) {
  const LockAttempt attempt = try_lock(folder / "no" / "a.json");
  EXPECT_EQ(attempt.outcome, Outcome::impossible);
  EXPECT_FALSE(attempt.reason.empty());
}

TEST_F(file_lock, a_lock_of_another_machine_is_believed) {
  std::ofstream(lock_file()) << "4711\nno-such-machine\n";
  const LockAttempt attempt = try_lock(folder / "a.json");
  EXPECT_EQ(attempt.outcome, Outcome::held);
  EXPECT_EQ(attempt.holder, "process 4711 on no-such-machine");
}

TEST_F(file_lock, moving_it_lets_go_of_the_one_before) {
  std::ofstream(folder / "b.json") << "x";
  FileLock lock = std::move(try_lock(folder / "a.json").lock);
  lock = std::move(try_lock(folder / "b.json").lock);
  EXPECT_FALSE(fs::exists(lock_file()));
  EXPECT_TRUE(lock.covers(folder / "b.json"));
}

TEST_F(file_lock, a_folder_is_claimed_by_one_run_and_leaves_no_file) {
  const fs::path out = folder / "out";
  const FileRoot root = *FileRoot().open(out), other = *FileRoot().open(out),
                 beside = *FileRoot().open(folder / "beside");
  {
    const auto mine = claim_folder(root);
    ASSERT_TRUE(mine.ok()) << mine.status().message;
    EXPECT_TRUE(mine->valid());
    EXPECT_TRUE(fs::is_empty(out));
    const auto theirs = claim_folder(other);
    ASSERT_FALSE(theirs.ok());
    EXPECT_EQ(theirs.status().code, Code::refused);
    EXPECT_NE(theirs.status().message.find(out.string() + ": another run"), std::string::npos);
    EXPECT_TRUE(claim_folder(beside).ok());
  }
  EXPECT_TRUE(claim_folder(other).ok()) << "it is free again";
}

TEST_F(file_lock, the_claim_of_a_killed_process_ends_with_it) {
  const FileRoot root = *FileRoot().open(folder / "out");
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const auto mine = claim_folder(root);
    const char byte = mine ? '1' : '0';
    if (::write(ready[1], &byte, 1) == 1) ::pause();
    ::_exit(0);
  }
  char byte = 0;
  EXPECT_EQ(::read(ready[0], &byte, 1), 1);
  EXPECT_EQ(byte, '1');
  ::close(ready[0]), ::close(ready[1]);
  EXPECT_FALSE(claim_folder(root).ok());
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_TRUE(claim_folder(root).ok());
}

}  // namespace file_lock_test
}  // namespace coaster::base
