#include "base/files.h"
#include "base/scratch_folder.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

#include <fstream>
#include <iterator>
#include <vector>

namespace coaster::base {
namespace files_test {

namespace fs = std::filesystem;

class files : public testing::Test {
 protected:
  std::string content(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::size_t entries() {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }

  test::ScratchFolder scratch;
  fs::path folder = scratch.path();
  Files io;
};

TEST_F(files, what_is_written_reads_back) {
  std::string bytes(200'000, 'x');
  bytes[17] = '\0';
  ASSERT_TRUE(io.write_atomic(folder / "a", bytes).ok());
  EXPECT_EQ(*io.read(folder / "a"), bytes);
  EXPECT_EQ(entries(), 1u);
}

TEST_F(files, what_is_no_file_is_refused_with_the_reason) {
  EXPECT_EQ(io.read(folder / "missing").status().code, Code::bad_file);
  EXPECT_EQ(io.read(folder).status().code, Code::bad_file);
  EXPECT_NE(io.read(folder).status().message.find("directory"), std::string::npos);
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(io.read(folder / "pipe").status().code, Code::bad_file);
  ASSERT_TRUE(io.write_atomic(folder / "big", "12345").ok());
  EXPECT_TRUE(io.read(folder / "big", 5).ok());
  EXPECT_EQ(io.read(folder / "big", 4).status().code, Code::bad_file);
}

TEST_F(files, each_failing_operation_leaves_the_old_file_and_nothing_else) {
  ASSERT_TRUE(io.write_atomic(folder / "a", "old").ok());
  for (IoOperation operation :
       {IoOperation::open, IoOperation::write, IoOperation::fsync, IoOperation::close, IoOperation::rename}) {
    io.inject(operation, 1);
    const Status status = io.write_atomic(folder / "a", "new");
    EXPECT_EQ(status.code, Code::io);
    EXPECT_NE(status.message.find((folder / "a").string()), std::string::npos) << status.message;
    EXPECT_EQ(content(folder / "a"), "old");
    EXPECT_EQ(entries(), 1u);
  }
  io.inject(IoOperation::open, 2);  // the first opens the folder, the second the temporary file
  EXPECT_EQ(io.write_atomic(folder / "a", "new").code, Code::io);
  EXPECT_EQ(content(folder / "a"), "old");
  EXPECT_EQ(entries(), 1u);
  EXPECT_TRUE(io.write_atomic(folder / "a", "new").ok()) << "a fault strikes once";
  EXPECT_EQ(content(folder / "a"), "new");
}

TEST_F(files, a_failing_fsync_of_the_folder_is_reported_with_one_whole_file_in_place) {
  io.inject(IoOperation::fsync, 2);
  EXPECT_EQ(io.write_atomic(folder / "a", "new").code, Code::io);
  EXPECT_EQ(content(folder / "a"), "new");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(files, faults_in_reading_are_io_errors) {
  ASSERT_TRUE(io.write_atomic(folder / "a", "old").ok());
  for (IoOperation operation : {IoOperation::open, IoOperation::read}) {
    io.inject(operation, 1);
    EXPECT_EQ(io.read(folder / "a").status().code, Code::io);
    EXPECT_TRUE(io.read(folder / "a").ok());
  }
}

TEST_F(files, a_symbolic_link_is_followed_and_the_mode_is_kept) {
  ASSERT_TRUE(io.write_atomic(folder / "target", "old").ok());
  fs::permissions(folder / "target", fs::perms(0640));
  fs::create_symlink("target", folder / "link");
  ASSERT_TRUE(io.write_atomic(folder / "link", "new").ok());
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(content(folder / "target"), "new");
  EXPECT_EQ(fs::status(folder / "target").permissions(), fs::perms(0640));
}

TEST_F(files, a_link_to_what_is_not_there_yet_makes_its_target) {
  fs::create_directory(folder / "deep");
  fs::create_symlink("deep/new", folder / "link");
  ASSERT_TRUE(io.write_atomic(folder / "link", "x").ok());
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(content(folder / "deep" / "new"), "x");
  fs::create_symlink("round", folder / "round");
  EXPECT_EQ(io.write_atomic(folder / "round", "x").code, Code::io);
}

TEST_F(files, a_file_that_may_not_be_written_is_refused) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everything";
  ASSERT_TRUE(io.write_atomic(folder / "a", "old").ok());
  fs::permissions(folder / "a", fs::perms(0444));
  EXPECT_EQ(io.write_atomic(folder / "a", "new").code, Code::io);
  EXPECT_EQ(content(folder / "a"), "old");
}

TEST_F(files, a_long_name_can_be_saved_to) {
  const fs::path file = folder / std::string(255, 'n');
  ASSERT_TRUE(io.write_atomic(file, "x").ok());
  EXPECT_EQ(content(file), "x");
}

// The temporary file that a process with this number would be writing now.
fs::path temporary_of(const fs::path& target, int pid) {
  // A child writes one and ends before it can put it in place: its name contains this machine's mark.
  const pid_t child = ::fork();
  if (child < 0) std::abort();
  if (child == 0) {
    struct rlimit none {};
    ::setrlimit(RLIMIT_CORE, &none);
    ::signal(SIGXFSZ, SIG_DFL);
    none.rlim_cur = none.rlim_max = 1;  // B: the second byte kills it in the middle of its work
    ::setrlimit(RLIMIT_FSIZE, &none);
    Files io;
    (void)io.write_atomic(target, "xy");
    (void)io.write_atomic(target, "xyz");
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status));
  fs::path found;
  for (const auto& entry : fs::directory_iterator(target.parent_path()))
    if (entry.path() != target) found = entry.path();
  if (pid == 0 || found.empty()) return found;
  std::string name = found.filename().string();
  const std::string number = "." + std::to_string(child) + ".";
  name.replace(name.rfind(number), number.size(), "." + std::to_string(pid) + ".");
  fs::rename(found, found.parent_path() / name);
  return found.parent_path() / name;
}

TEST_F(files, what_a_killed_writer_left_goes_with_the_next_save_of_the_same_file) {
  const fs::path left = temporary_of(folder / "a", 0);
  ASSERT_FALSE(left.empty());
  ASSERT_TRUE(io.write_atomic(folder / "b", "x").ok());
  EXPECT_TRUE(fs::exists(left)) << "another file's";
  ASSERT_TRUE(io.write_atomic(folder / "a", "x").ok());
  EXPECT_FALSE(fs::exists(left));
  EXPECT_EQ(entries(), 2u);
}

TEST_F(files, what_a_running_writer_is_at_stays) {
  const fs::path left = temporary_of(folder / "a", ::getppid());
  ASSERT_FALSE(left.empty());
  EXPECT_EQ(io.remove_leftovers(folder / "a"), 0);
  EXPECT_EQ(io.remove_leftovers_in(folder), 0);
  EXPECT_TRUE(fs::exists(left));
}

TEST_F(files, names_that_look_alike_are_nobody_s_leftovers) {
  const fs::path left = temporary_of(folder / "a", 0);
  const std::string name = left.filename().string();
  fs::remove(left);
  for (const std::string& other :
       std::vector<std::string>{name + "x", name.substr(1), ".a.00000000.1.0", ".a.", ".a.json.lock"})
    std::ofstream(folder / other) << "mine";
  EXPECT_EQ(io.remove_leftovers_in(folder), 0);
  EXPECT_EQ(entries(), 5u);
}

TEST_F(files, a_new_file_has_the_mode_that_other_programs_give) {
  ASSERT_TRUE(io.write_atomic(folder / "a", "x").ok());
  std::ofstream(folder / "b") << "x";
  EXPECT_EQ(fs::status(folder / "a").permissions(), fs::status(folder / "b").permissions());
}

TEST_F(files, a_folder_that_is_missing_is_an_error) {
  EXPECT_EQ(io.write_atomic(folder / "no" / "a", "x").code, Code::io);
  EXPECT_EQ(io.write_atomic(folder, "x").code, Code::io);
}

}  // namespace files_test
}  // namespace coaster::base
