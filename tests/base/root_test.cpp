// Writing below a folder: links, pipes and names prepared in it never lead to a file outside it being created, changed
// or removed.
#include "base/root.h"

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
    const auto opened = Root().open(top / "out");
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
  EXPECT_TRUE(io.remove_tree(out("deep")));
  EXPECT_FALSE(fs::exists(out("deep")));
}

TEST_F(root, a_name_outside_is_refused) {
  for (const fs::path& path :
       {victim(), out("../foreign/victim"), out("a/../../foreign/new"), fs::path("new"), top / "outer", out("..")}) {
    refused(path, "writes only below");
    EXPECT_FALSE(io.root().contains(path)) << path;
    EXPECT_EQ(io.root().make_folders(path).code, Code::refused) << path;
    EXPECT_FALSE(io.remove(path)) << path;
    EXPECT_FALSE(io.remove_tree(path)) << path;
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
  fs::create_hard_link(victim(), out("hard"));
  ASSERT_TRUE(io.write_atomic(out("hard"), "new").ok());
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

TEST_F(root, removing_a_tree_leaves_what_its_links_lead_to) {
  fs::create_directories(out("tree/inner"));
  fs::create_directory_symlink(top / "foreign", out("tree/inner/away"));
  fs::create_symlink(victim(), out("tree/link"));
  EXPECT_TRUE(io.remove_tree(out("tree")));
  EXPECT_FALSE(fs::exists(out("tree")));
  fs::create_directory_symlink(top / "foreign", out("tree"));
  EXPECT_TRUE(io.remove_tree(out("tree"))) << "the link itself";
  EXPECT_FALSE(fs::exists(fs::symlink_status(out("tree"))));
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
  const auto named = Root().open(top / "named");
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
