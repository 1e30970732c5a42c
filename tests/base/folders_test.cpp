#include "base/folders.h"
#include "base/scratch_folder.h"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace coaster::base {
namespace folders_test {

namespace fs = std::filesystem;

class folders : public testing::Test {
 protected:
  test::ScratchFolder scratch;
  fs::path folder = scratch.path();
};

struct Variable {
  std::string name, before;
  bool was;
  Variable(const char* n, const char* value) : name(n), was(getenv(n) != nullptr) {
    if (was) before = getenv(n);
    if (value != nullptr) setenv(n, value, 1);
    else unsetenv(n);
  }
  ~Variable() {
    if (was) setenv(name.c_str(), before.c_str(), 1);
    else unsetenv(name.c_str());
  }
};

TEST_F(folders, the_base_directories_are_those_of_the_specification) {
  const Variable home("HOME", "/home/x"), config("XDG_CONFIG_HOME", nullptr), state("XDG_STATE_HOME", "/var/s");
  EXPECT_EQ(user_folders().config, "/home/x/.config/coaster");
  EXPECT_EQ(user_folders().state, "/var/s/coaster");
  const Variable relative("XDG_STATE_HOME", "here");
  EXPECT_EQ(user_folders().state, "/home/x/.local/state/coaster") << "relative paths are to be ignored";
  const Variable none("HOME", nullptr);
  EXPECT_TRUE(user_folders().config.empty());
}

TEST_F(folders, data_are_where_the_variable_says_else_in_the_source_tree) {
  {
    const Variable named("COASTER_DATA", "/opt/some where/coaster");
    EXPECT_EQ(data_folder(), "/opt/some where/coaster");
  }
  // The test program has no share folder next to its folder.
  const Variable relative("COASTER_DATA", "share");
  EXPECT_EQ(data_folder(), fs::path(COASTER_SOURCE_DIR)) << "relative paths are ignored";
  EXPECT_TRUE(fs::exists(data_folder() / "tracks" / "loop.json"));
}

TEST_F(folders, installed_files_are_those_below_the_data_but_not_the_source_tree_s) {
  EXPECT_FALSE(is_installed(fs::path(COASTER_SOURCE_DIR) / "tracks" / "loop.json"));
  ASSERT_TRUE(make_folders(folder / "share" / "tracks"));
  fs::create_directory_symlink(folder / "share", folder / "link");
  const Variable named("COASTER_DATA", (folder / "link").c_str());
  EXPECT_TRUE(is_installed(folder / "share" / "tracks" / "loop.json"));
  EXPECT_TRUE(is_installed(folder / "link" / "tracks" / "loop.json"));
  EXPECT_FALSE(is_installed(folder / "share.json"));
  EXPECT_FALSE(is_installed(folder / "share" / ".." / "loop.json"));
  EXPECT_FALSE(is_installed(""));
}

TEST_F(folders, a_folder_is_made_with_those_above_it) {
  ASSERT_TRUE(make_folders(folder / "a" / "b"));
  EXPECT_EQ(fs::status(folder / "a" / "b").permissions() & fs::perms::all, fs::perms(0700));
  EXPECT_TRUE(make_folders(folder / "a" / "b"));
  std::ofstream(folder / "file") << "x";
  const Status refused = make_folders(folder / "file" / "c");
  EXPECT_EQ(refused.code, Code::io);
  EXPECT_EQ(refused.message, (folder / "file").string() + ": is a file; expected a folder or a new name");
  fs::create_symlink(folder / "nowhere", folder / "dangling");
  EXPECT_NE(make_folders(folder / "dangling").message.find("dangling: is a symbolic link that leads to no folder"),
            std::string::npos);
}

// The kernel's own folders take none, and give another reason than that there is none yet.
TEST_F(folders, one_that_cannot_be_made_is_refused_with_the_kernel_s_reason) {
  const fs::path inside = folder / std::string(300, 'n');
  EXPECT_EQ(make_folders(inside).message, inside.string() + ": cannot be made: " + std::strerror(ENAMETOOLONG));
}

TEST_F(folders, folders_come_first_then_files_by_name_without_regard_to_case) {
  for (const char* name : {"b.json", "A.json", "c.json", ".hidden"}) std::ofstream(folder / name) << "1234";
  fs::create_directory(folder / "z");
  fs::create_directory(folder / "Y");
  fs::create_symlink("c.json", folder / "link");
  fs::create_symlink("nowhere", folder / "dangling");
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  const auto listed = list_folder(folder);
  ASSERT_TRUE(listed);
  std::string names;
  for (const FolderEntry& e : *listed) names += e.name + (e.folder ? "/ " : " ");
  EXPECT_EQ(names, "Y/ z/ A.json b.json c.json link ");
  EXPECT_EQ(listed->back().bytes, 4u);
  EXPECT_EQ(listed->back().time, change_time(folder / "c.json"));
  EXPECT_EQ(list_folder(folder, true)->size(), 7u);
  EXPECT_EQ(list_folder(folder / "none").status().code, Code::bad_file);
}

TEST_F(folders, sizes_are_short) {
  EXPECT_EQ(size_text(0), "0 B");
  EXPECT_EQ(size_text(999), "999 B");
  EXPECT_EQ(size_text(1000), "1.0 kB");
  EXPECT_EQ(size_text(12'345), "12 kB");
  EXPECT_EQ(size_text(999'700), "1.0 MB");
  EXPECT_EQ(size_text(64u << 20), "67 MB");
}

TEST_F(folders, times_are_of_this_place) {
  const Variable zone("TZ", "UTC");
  ::tzset();
  EXPECT_EQ(local_time(0), "1970-01-01 00:00");
  EXPECT_EQ(local_time(1'772'355'900), "2026-03-01 09:05");
  EXPECT_EQ(change_time(folder / "none"), 0);
}

}  // namespace folders_test
}  // namespace coaster::base
