// Writing below a folder: links, pipes and names prepared in it never lead to a file outside it being created, changed
// or removed.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "base/file_lock.h"
#include "base/files.h"
#include "base/scratch_folder.h"

namespace coaster::base {
namespace root_test {

namespace fs = std::filesystem;

class root : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(top / "out");
    fs::create_directories(top / "foreign" / "folder");
    std::ofstream(victim()) << "victim";
    const auto opened = FileRoot().open(top / "out");
    ASSERT_TRUE(opened.ok()) << opened.status().message;
    io = Files(*opened);
  }
  // All that is foreign is as it was.
  void TearDown() override {
    EXPECT_EQ(text(victim()), "victim");
    EXPECT_EQ(std::distance(fs::recursive_directory_iterator(top / "foreign"), fs::recursive_directory_iterator()), 2);
    EXPECT_EQ(std::distance(fs::directory_iterator(top), fs::directory_iterator()), 2);
  }
  fs::path victim() const { return top / "foreign" / "victim"; }
  fs::path out(const char* name) const { return top / "out" / name; }
  static std::string text(const fs::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  static int files_in(const fs::path& folder) {
    int files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) files += entry.is_directory() ? 0 : 1;
    return files;
  }
  void refused(const fs::path& path, std::string_view reason) {
    const Status status = io.write_atomic(path, "new");
    EXPECT_EQ(status.code, Code::refused) << path;
    EXPECT_NE(status.message.find(reason), std::string::npos) << status.message;
  }

  test::ScratchFolder scratch;
  fs::path top = scratch.path();
  Files io;
};

TEST_F(root, what_lies_below_is_written) {
  ASSERT_TRUE(io.write_atomic(out("a"), "1").ok());
  ASSERT_TRUE(io.write_atomic(out("a"), "2").ok());
  EXPECT_EQ(text(out("a")), "2");
  ASSERT_TRUE(io.root().make_folders(out("deep/er")).ok());
  EXPECT_TRUE(io.write_atomic(out("deep/../deep/./er/b"), "3").ok());
  EXPECT_EQ(text(out("deep/er/b")), "3");
  EXPECT_TRUE(io.rename(out("deep/er/b"), "c"));
  EXPECT_TRUE(io.remove(out("deep/er/c")));
  EXPECT_FALSE(fs::exists(out("deep/er/c")));
  ASSERT_TRUE(io.write_atomic(out("deep/er/b"), "4").ok());
  EXPECT_TRUE(io.remove_made(out("deep")).ok());
  EXPECT_EQ(files_in(out("deep")), 0);
}

TEST_F(root, a_name_outside_is_refused) {
  for (const fs::path& path :
       {victim(), out("../foreign/victim"), out("a/../../foreign/new"), fs::path("new"), top / "outer", out("..")}) {
    refused(path, "writes only below");
    EXPECT_FALSE(io.root().contains(path)) << path;
    EXPECT_EQ(io.root().make_folders(path).code, Code::refused) << path;
    EXPECT_FALSE(io.remove(path)) << path;
    EXPECT_EQ(io.remove_made(path).code, Code::refused) << path;
    EXPECT_FALSE(io.rename(path, "other")) << path;
  }
}

TEST_F(root, a_link_is_refused_whether_it_leads_somewhere_or_not) {
  fs::create_symlink("../foreign/new", out("dangling"));
  fs::create_symlink(victim(), out("link"));
  fs::create_symlink("link", out("loop_free"));
  for (const char* const name : {"dangling", "link", "loop_free"}) {
    refused(out(name), "is a symbolic link");
    EXPECT_EQ(io.root().make_folders(out(name)).code, Code::refused);
    EXPECT_EQ(io.root().open(out(name)).status().code, Code::refused);
    EXPECT_TRUE(fs::is_symlink(out(name)));
  }
}

TEST_F(root, a_link_on_the_way_is_refused) {
  fs::create_directory_symlink("../foreign", out("away"));
  fs::create_directory(out("in"));
  fs::create_directory_symlink(top / "foreign", out("in/away"));
  for (const char* const name : {"away/new", "away/victim", "in/away/new", "in/away/folder/new", "away/../away/new"}) {
    refused(out(name), "away: is a symbolic link");
    EXPECT_EQ(io.root().make_folders(out(name)).code, Code::refused) << name;
    EXPECT_FALSE(io.remove(out(name))) << name;
    EXPECT_FALSE(io.rename(out(name), "other")) << name;
    EXPECT_FALSE(try_lock(out(name), io.root()).lock.held()) << name;
  }
}

TEST_F(root, a_hard_link_is_replaced_and_pipes_and_devices_are_refused) {
  ASSERT_TRUE(io.write_atomic(out("hard"), "old").ok());
  fs::remove(out("hard"));
  fs::create_hard_link(victim(), out("hard"));
  ASSERT_TRUE(io.write_atomic(out("hard"), "new").ok()) << "a run made a file of that name";
  EXPECT_EQ(text(out("hard")), "new");
  EXPECT_EQ(fs::hard_link_count(victim()), 1u);
  ASSERT_EQ(::mkfifo(out("pipe").c_str(), 0600), 0);
  EXPECT_FALSE(io.write_atomic(out("pipe"), "new").ok());
  EXPECT_TRUE(fs::is_fifo(out("pipe")));
  if (::mknod(out("null").c_str(), S_IFCHR | 0600, 0x103) == 0) {  // the superuser's right
    EXPECT_FALSE(io.write_atomic(out("null"), "new").ok());
    EXPECT_TRUE(fs::is_character_file(out("null")));
  }
}

TEST_F(root, a_link_in_a_folder_to_be_emptied_is_refused_and_not_followed) {
  fs::create_directories(out("tree/inner"));
  for (const fs::path& link : {out("tree/inner/away"), out("tree/link")}) {
    fs::create_symlink(link == out("tree/link") ? victim() : top / "foreign", link);
    EXPECT_EQ(io.remove_made(out("tree")).code, Code::refused);
    EXPECT_TRUE(fs::is_symlink(link));
    fs::remove(link);
  }
  EXPECT_TRUE(io.remove_made(out("tree")).ok());
  fs::remove_all(out("tree"));
  fs::create_directory_symlink(top / "foreign", out("tree"));
  EXPECT_EQ(io.remove_made(out("tree")).code, Code::refused);
}

// The rule: only what runs made is replaced or removed.
TEST_F(root, a_file_that_no_run_made_is_neither_replaced_nor_removed) {
  std::ofstream(out("mine")) << "mine";
  refused(out("mine"), "no run of coaster made this file");
  EXPECT_EQ(io.create(out("mine")).status().code, Code::refused);
  EXPECT_FALSE(io.remove(out("mine")));
  EXPECT_EQ(text(out("mine")), "mine");
  ASSERT_TRUE(io.write_atomic(out("made"), "1").ok());
  const Files later(*FileRoot().open(top / "out"));
  EXPECT_TRUE(Files(later).write_atomic(out("made"), "2").ok()) << "of an earlier run";
  EXPECT_FALSE(io.rename(out("made"), "mine")) << "the name is not free";
  EXPECT_EQ(text(out("mine")), "mine");
  EXPECT_TRUE(io.rename(out("made"), "renamed"));
  EXPECT_TRUE(io.remove(out("renamed")));
  EXPECT_TRUE(io.write_atomic(out("mine"), "asked", ReplaceableFiles::any).ok()) << "where the user was asked";
}

TEST_F(root, a_folder_is_emptied_only_if_runs_made_all_of_it) {
  EXPECT_TRUE(io.remove_made(out("home")).ok()) << "there is none";
  ASSERT_TRUE(io.root().make_folders(out("home/recovery")).ok());
  ASSERT_TRUE(io.write_atomic(out("home/settings.json"), "1").ok());
  ASSERT_TRUE(io.write_atomic(out("home/recovery/a"), "1").ok());
  LockAttempt lock = try_lock(out("home/recovery/a"), io.root());
  std::ofstream(out("home/recovery/mine")) << "mine";
  const Status refusal = io.remove_made(out("home"));
  EXPECT_EQ(refusal.code, Code::refused);
  EXPECT_NE(refusal.message.find("mine: no run"), std::string::npos) << refusal.message;
  EXPECT_EQ(text(out("home/settings.json")), "1") << "all of it stays";
  EXPECT_EQ(text(out("home/recovery/mine")), "mine");
  fs::remove(out("home/recovery/mine"));
  EXPECT_TRUE(io.remove_made(out("home")).ok()) << "the lock and the list are traces of the others";
  EXPECT_EQ(files_in(out("home")), 0);
  const auto frames = [](const std::string& name) { return name.starts_with("frame"); };
  std::ofstream(out("home/mine")) << "mine";
  ASSERT_TRUE(io.write_atomic(out("home/frame1"), "1").ok());
  EXPECT_TRUE(io.remove_made(out("home"), frames).ok()) << "the other file has another name";
  EXPECT_FALSE(fs::exists(out("home/frame1")));
  std::ofstream(out("home/frame2")) << "mine";
  EXPECT_EQ(io.remove_made(out("home"), frames).code, Code::refused);
  EXPECT_EQ(text(out("home/frame2")), "mine");
}

TEST_F(root, the_list_of_made_files_is_no_way_out) {
  fs::create_symlink("../foreign/new", out(std::string(kMadeList).c_str()));
  EXPECT_TRUE(io.write_atomic(out("a"), "1").ok()) << "it is new";
  refused(out("a"), "no run of coaster made this file");
  fs::remove(out(std::string(kMadeList).c_str()));
  fs::create_hard_link(victim(), out(std::string(kMadeList).c_str()));
  EXPECT_TRUE(io.write_atomic(out("b"), "1").ok());
  EXPECT_EQ(text(victim()), "victim");
}

TEST_F(root, a_lock_s_name_with_other_words_is_left_alone) {
  std::ofstream(out(".mine.lock")) << "my notes";
  EXPECT_EQ(try_lock(out("mine"), io.root()).outcome, LockAttempt::Outcome::impossible);
  EXPECT_EQ(text(out(".mine.lock")), "my notes");
}

TEST_F(root, a_lock_is_a_new_file_below) {
  fs::create_hard_link(victim(), out(".hard.lock"));
  fs::create_symlink("../foreign/new", out(".link.lock"));
  ASSERT_EQ(::mkfifo(out(".pipe.lock").c_str(), 0600), 0);
  for (const char* const name : {"hard", "link", "pipe", "../foreign/victim"})
    EXPECT_EQ(try_lock(out(name), io.root()).outcome, LockAttempt::Outcome::impossible) << name;
  fs::create_symlink(victim(), out("foreign"));
  EXPECT_EQ(try_lock(out("foreign"), io.root()).outcome, LockAttempt::Outcome::impossible);
  fs::create_symlink("a", out("own"));
  const LockAttempt own = try_lock(out("own"), io.root());
  EXPECT_EQ(own.outcome, LockAttempt::Outcome::taken);
  EXPECT_TRUE(fs::exists(out(".a.lock"))) << "of the file that the link leads to";
}

TEST_F(root, the_folder_itself_may_be_a_link_and_stays_the_same_one) {
  fs::create_directory_symlink("out", top / "named");
  const auto named = FileRoot().open(top / "named");
  ASSERT_TRUE(named.ok());
  fs::remove(top / "named");
  fs::create_directory_symlink("foreign", top / "named");  // afterwards it leads elsewhere
  EXPECT_TRUE(Files(*named).write_atomic(top / "named" / "a", "1").ok());
  EXPECT_TRUE(Files(*named).write_atomic(out("b"), "2").ok()) << "by its other name";
  EXPECT_EQ(text(out("a")) + text(out("b")), "12");
  fs::remove(top / "named");
}

TEST_F(root, a_root_inside_is_opened_without_links) {
  fs::create_directory_symlink("../foreign", out("away"));
  const auto inner = io.root().open(out("inner"));
  ASSERT_TRUE(inner.ok());
  EXPECT_TRUE(Files(*inner).write_atomic(out("inner/a"), "1").ok());
  EXPECT_EQ(Files(*inner).write_atomic(out("a"), "1").code, Code::refused);
  EXPECT_EQ(io.root().open(out("away/folder")).status().code, Code::refused);
  EXPECT_EQ(io.root().open(top / "foreign").status().code, Code::refused);
}

TEST_F(root, faults_are_shared_with_another_root) {
  Files other = io.with({});
  io.inject(IoOperation::fsync, 1);
  EXPECT_EQ(other.write_atomic(out("a"), "1").code, Code::io);
  EXPECT_TRUE(io.write_atomic(out("a"), "1").ok());
  io.inject(IoOperation::fsync, 1);
  EXPECT_TRUE(Files(io.root()).write_atomic(out("a"), "2").ok()) << "without the faults";
}

}  // namespace root_test
}  // namespace coaster::base
