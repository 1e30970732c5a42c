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
    std::filesystem::create_directories(bin_);
    if (const char* const path = std::getenv("PATH")) path_ = path;
    ::setenv("PATH", (bin_.string() + ":" + path_).c_str(), 1);
    make_ffmpeg("");
  }
  void TearDown() override { ::setenv("PATH", path_.c_str(), 1); }

  // `before`: commands of sh, with $last the output and the folder of the movie as working folder.
  void make_ffmpeg(const std::string& before) {
    const std::filesystem::path program = bin_ / "ffmpeg";
    std::ofstream(program) << "#!/bin/sh\nfor last; do :; done\nprintf '%s\\n' \"$@\" >>'" << noted_.string() << "'\n"
                           << before << "\necho made >\"$last\"\n";
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  }

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
  std::filesystem::path noted_ = scratch_.path() / "arguments", bin_ = scratch_.path() / "bin";
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

TEST_F(MovieFiles, pictures_after_one_that_cannot_be_written_do_not_count) {
  const auto movie = Movie::start({.folder = scratch_.path() / "movie", .fps = 30, .gif = false, .root = {}});
  ASSERT_TRUE(movie) << movie.status().message;
  std::filesystem::create_directory(scratch_.path() / "movie" / Movie::picture_name(2));
  for (int i = 0; i < 40 && (*movie)->add({.width = 1, .height = 1, .rgba = {1, 2, 3, 4}}); ++i)
    (*movie)->pass((*movie)->wait());
  EXPECT_FALSE((*movie)->finish());
  EXPECT_EQ((*movie)->frames(), 2);
}

// Another program puts a link in place of each new file while it is written.
TEST_F(MovieFiles, a_link_in_place_of_a_new_file_leads_nothing_outside) {
  const std::filesystem::path outside = scratch_.path() / "outside";
  std::ofstream(outside) << "mine";
  make_ffmpeg("for new in .movie.*; do rm \"$new\" && ln -s ../outside \"$new\"; done");
  EXPECT_NE(encode(30).find("There is no movie.mp4"), std::string::npos);
  std::string kept;
  std::getline(std::ifstream(outside), kept);
  EXPECT_EQ(kept, "mine");
  for (const auto& entry : std::filesystem::directory_iterator(scratch_.path() / "movie"))
    EXPECT_EQ(entry.path().filename(), base::kMadeList);
}

}  // namespace movie_test
}  // namespace coaster::app
