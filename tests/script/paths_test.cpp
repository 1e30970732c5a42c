// Scripts read any path that they name and write only below $OUT.
#include "script/paths.h"
#include "base/scratch_folder.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

namespace coaster::script {
namespace paths_test {

class Paths : public testing::Test {
 protected:
  Paths() {
    std::filesystem::create_directories(root_ / "script");
    std::filesystem::create_directories(out_);
    std::ofstream(root_ / "script/beside.json") << "{}";
  }
  test::ScratchFolder scratch_;
  std::filesystem::path root_ = scratch_.path(), out_ = root_ / "out";
};

TEST_F(Paths, a_file_is_read_below_out_beside_the_script_or_where_the_program_is) {
  const std::filesystem::path folder = root_ / "script";
  EXPECT_EQ(find_input(folder, "$OUT/a/b.json", out_), out_ / "a/b.json");
  EXPECT_EQ(find_input(folder, "beside.json", out_), folder / "beside.json");
  EXPECT_EQ(find_input(folder, "elsewhere.json", out_), "elsewhere.json");
  EXPECT_EQ(find_input(folder, "/etc/hosts", out_), "/etc/hosts");
  EXPECT_EQ(find_input(folder, "$OUTSIDE/a", out_), "$OUTSIDE/a");
}

TEST_F(Paths, a_file_is_written_below_out_and_nowhere_else) {
  const auto root = base::FileRoot().open(out_);
  ASSERT_TRUE(root) << root.status().message;
  const auto good = find_output("$OUT/pictures/a.png", *root);
  ASSERT_TRUE(good) << good.status().message;
  EXPECT_EQ(*good, out_ / "pictures/a.png");
  EXPECT_TRUE(std::filesystem::is_directory(out_ / "pictures"));
  for (const char* const bad :
       {"a.png", "/tmp/a.png", "$OUT", "$OUT/", "$OUT/../a.png", "$OUT/x/../../a.png", "$OUTSIDE/a.png", ""})
    EXPECT_EQ(find_output(bad, *root).status().code, base::Code::usage) << bad;
  EXPECT_EQ(find_output("../a.png", *root).status().message,
            "scripts write only below $OUT: expected a file such as \"$OUT/a.png\", found \"../a.png\"");
  EXPECT_EQ(find_output("$OUT/", *root).status().message,
            "scripts write only below $OUT: expected a file such as \"$OUT/NAME\", found \"$OUT/\"");
  std::filesystem::create_directory_symlink(root_ / "script", out_ / "link");
  EXPECT_FALSE(find_output("$OUT/link/a.png", *root)) << "a link may lead anywhere";
}

}  // namespace paths_test
}  // namespace coaster::script
