#include "app/process.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <thread>

#include "base/scratch_folder.h"

namespace coaster::app {
namespace process_test {

namespace fs = std::filesystem;

class ProcessTest : public testing::Test {
 protected:
  void SetUp() override { path_ = std::getenv("PATH") != nullptr ? std::getenv("PATH") : ""; }
  void TearDown() override { ::setenv("PATH", path_.c_str(), 1); }

  // Returns the path of a new file with these lines and rights.
  fs::path program(const fs::path& folder, const std::string& name, const std::string& lines, unsigned mode = 0700) {
    fs::create_directories(folder);
    const fs::path file = folder / name;
    std::ofstream(file) << "#!/bin/sh\n" << lines;
    EXPECT_EQ(::chmod(file.c_str(), mode), 0);
    return file;
  }
  // Polls until the process ends; nothing after five seconds.
  static std::optional<int> ended(Process& process) {
    for (int i = 0; i < 5'000; ++i) {
      if (const auto code = process.poll()) return code;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return std::nullopt;
  }

  test::ScratchFolder scratch_;
  fs::path folder_ = scratch_.path();
  std::string path_;
};

TEST_F(ProcessTest, a_program_is_the_first_executable_file_of_an_absolute_folder_of_the_path) {
  const fs::path none = folder_ / "none", plain = folder_ / "plain", folders = folder_ / "folders",
                 first = folder_ / "first", second = folder_ / "second";
  fs::create_directories(none);
  program(plain, "tool", "", 0600);
  fs::create_directories(folders / "tool");
  const fs::path found = program(first, "tool", "");
  program(second, "tool", "");
  const auto with = [&](const std::string& path) {
    ::setenv("PATH", path.c_str(), 1);
    return find_program("tool");
  };
  EXPECT_EQ(with(first.string() + ":" + second.string()), found.string());
  EXPECT_EQ(with(second.string() + ":" + first.string()), (second / "tool").string());
  EXPECT_EQ(with(none.string() + ":" + first.string()), found.string());
  EXPECT_EQ(with(plain.string() + ":" + first.string()), found.string()) << "without the right to run it";
  EXPECT_EQ(with(folders.string() + ":" + first.string()), found.string()) << "a folder";
  EXPECT_EQ(with(plain.string()), "");
  EXPECT_EQ(with(folders.string()), "");
  EXPECT_EQ(with(""), "");
  ::unsetenv("PATH");
  EXPECT_EQ(find_program("tool"), "");
  const fs::path before = fs::current_path();
  fs::current_path(first);
  EXPECT_EQ(with("."), "") << "a relative folder";
  EXPECT_EQ(with("::."), "");
  fs::current_path(before);
}

TEST_F(ProcessTest, its_output_and_exit_code_are_read_without_waiting) {
  Process process;
  EXPECT_FALSE(process.running());
  EXPECT_EQ(process.poll(), std::nullopt);
  const std::string quiet = program(folder_, "quiet", "echo one; echo wrong >&2; printf %s \"$1\"; exit 7\n").string();
  ASSERT_TRUE(process.start({quiet, "two words; $HOME"}));
  EXPECT_TRUE(process.running());
  EXPECT_EQ(ended(process), 7);
  EXPECT_FALSE(process.running());
  EXPECT_EQ(process.output(), "one\ntwo words; $HOME") << "no shell reads its words, and errors are left out";
  ASSERT_TRUE(process.start({quiet, ""}, -1, true));
  EXPECT_EQ(ended(process), 7);
  EXPECT_EQ(process.output(), "one\nwrong\n") << "of this start alone";
}

TEST_F(ProcessTest, it_runs_in_the_folder_with_no_input_and_the_given_file) {
  Process process;
  const std::string looks = program(folder_, "looks", "pwd -P; cat; cat " + std::string(kGivenFile) + "\n").string();
  std::ofstream(folder_ / "given") << "from the file";
  const int folder = ::open(folder_.c_str(), O_RDONLY | O_CLOEXEC),
            file = ::open((folder_ / "given").c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_TRUE(process.start({looks}, folder, false, file));
  EXPECT_EQ(ended(process), 0);
  EXPECT_EQ(process.output(), fs::canonical(folder_).string() + "\nfrom the file");
  ::close(folder), ::close(file);
}

TEST_F(ProcessTest, more_output_than_a_pipe_holds_arrives_whole) {
  Process process;
  ASSERT_TRUE(process.start({program(folder_, "many", "seq 1 40000\n").string()}));
  EXPECT_EQ(ended(process), 0);
  std::string expected;
  for (int i = 1; i <= 40'000; ++i) expected += std::to_string(i) + "\n";
  EXPECT_EQ(process.output(), expected);
}

TEST_F(ProcessTest, a_signal_is_told_and_what_cannot_be_started_is_refused_by_name) {
  Process process;
  ASSERT_TRUE(process.start({program(folder_, "killed", "kill -9 $$\n").string()}));
  EXPECT_EQ(ended(process), 128 + 9);
  const std::string missing = (folder_ / "missing").string();
  const base::Status refused = process.start({missing});
  EXPECT_EQ(refused.code, base::Code::io);
  EXPECT_EQ(refused.message, missing + ": cannot be started: No such file or directory");
  EXPECT_FALSE(process.running());
  EXPECT_EQ(process.start({}).code, base::Code::io);
  ASSERT_TRUE(process.start({program(folder_, "sleeps", "exec sleep 60\n").string()}));
  process.end();
  EXPECT_FALSE(process.running());
  EXPECT_EQ(process.poll(), std::nullopt);
}

}  // namespace process_test
}  // namespace coaster::app
