// The fonts of the system.
#include "platform/system.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace coaster::platform {
namespace system_fonts_test {

namespace fs = std::filesystem;

TEST(system_fonts, a_font_that_has_a_letter_is_found) {
  const fs::path dejavu = "/usr/share/fonts/truetype/dejavu";
  if (!fs::exists(dejavu / "DejaVuSans.ttf")) GTEST_SKIP() << "DejaVu is not installed";
  const fs::path folder = fs::path(testing::TempDir()) / "coaster_system_fonts";  // only those fonts
  fs::create_directories(folder);
  std::ofstream(folder / "fonts.conf") << "<?xml version='1.0'?><!DOCTYPE fontconfig SYSTEM 'fonts.dtd'><fontconfig>"
                                       << "<dir>" << dejavu.string() << "</dir><cachedir>" << folder.string()
                                       << "/cache</cachedir></fontconfig>";
  setenv("FONTCONFIG_FILE", (folder / "fonts.conf").c_str(), 1);  // which fontconfig reads once in a process
  // Arabic, Cyrillic, one that no font has.
  const std::vector<SystemFont> fonts = fonts_with({0x0634, 0x0416, 0x10FFF0});
  ASSERT_EQ(fonts.size(), 1U) << "one has both; none has the third";
  EXPECT_EQ(fs::path(fonts[0].path).parent_path(), dejavu);
  EXPECT_TRUE(fonts_with({0x10FFF0}).empty());
  EXPECT_TRUE(fonts_with({}).empty());
}

}  // namespace system_fonts_test
}  // namespace coaster::platform
