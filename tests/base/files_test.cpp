#include "base/files.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <iterator>

namespace coaster::base {
namespace {

namespace fs = std::filesystem;

class files : public testing::Test {
 protected:
  void SetUp() override {
    folder = fs::temp_directory_path() / ("coaster_files_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }
  std::string content(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::size_t entries() { return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator())); }

  fs::path folder;
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
  for (IoOperation operation : {IoOperation::open, IoOperation::write, IoOperation::fsync, IoOperation::close, IoOperation::rename}) {
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

TEST_F(files, a_new_file_has_the_mode_that_other_programs_give) {
  ASSERT_TRUE(io.write_atomic(folder / "a", "x").ok());
  std::ofstream(folder / "b") << "x";
  EXPECT_EQ(fs::status(folder / "a").permissions(), fs::status(folder / "b").permissions());
}

TEST_F(files, a_folder_that_is_missing_is_an_error) {
  EXPECT_EQ(io.write_atomic(folder / "no" / "a", "x").code, Code::io);
  EXPECT_EQ(io.write_atomic(folder, "x").code, Code::io);
}

}  // namespace
}  // namespace coaster::base
