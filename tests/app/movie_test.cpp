#include "app/movie.h"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "base/scratch_folder.h"

namespace coaster::app {
namespace movie_test {

// PATH holds a program named ffmpeg that notes its arguments, one a line, and makes its output.
class MovieFiles : public testing::Test {
 protected:
  void SetUp() override {
    const std::filesystem::path bin = scratch_.path() / "bin", program = bin / "ffmpeg";
    std::filesystem::create_directories(bin);
    std::ofstream(program) << "#!/bin/sh\nfor last; do :; done\nprintf '%s\\n' \"$@\" >>'" << noted_.string()
                           << "'\necho made >\"$last\"\n";
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    if (const char* const path = std::getenv("PATH")) path_ = path;
    ::setenv("PATH", (bin.string() + ":" + path_).c_str(), 1);
  }
  void TearDown() override { ::setenv("PATH", path_.c_str(), 1); }

  // The line about the result, of a movie with so many pictures a second for one second.
  std::string encode(int fps) {
    const auto movie = Movie::start({.folder = scratch_.path() / "movie", .fps = fps, .gif = true, .root = {}});
    if (!movie) return movie.status().message;
    MovieEncoder encoder((*movie)->order(), fps);
    for (;;) {
      if (const auto line = encoder.poll()) return *line;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  std::string arguments() const {
    std::ifstream file(noted_);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  test::ScratchFolder scratch_;
  std::filesystem::path noted_ = scratch_.path() / "arguments";
  std::string path_;
};

// A GIF counts delays in hundredths of a second: 60 pictures a second would be a delay of 1.67, which it cannot say.
TEST_F(MovieFiles, a_gif_has_25_pictures_a_second_at_most) {
  EXPECT_NE(encode(60).find(", with movie.mp4 and movie.gif."), std::string::npos);
  EXPECT_NE(arguments().find("-frames:v\n60\n-vf"), std::string::npos) << arguments();
  EXPECT_NE(arguments().find("-frames:v\n25\n-filter_complex\nfps=25,"), std::string::npos) << arguments();
}

TEST_F(MovieFiles, a_gif_keeps_a_lower_rate) {
  EXPECT_NE(encode(20).find(", with movie.mp4 and movie.gif."), std::string::npos);
  EXPECT_NE(arguments().find("-frames:v\n20\n-filter_complex\nfps=20,"), std::string::npos) << arguments();
}

}  // namespace movie_test
}  // namespace coaster::app
