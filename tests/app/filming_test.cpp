// Recording a movie while the program runs.
#include "app/movie.h"

#include <cstdlib>
#include <optional>

#include "app/pictures.h"
#include "app/program_fixture.h"
#include "gfx/image.h"
#include "script/statements.h"

namespace coaster::app {
namespace filming_test {

class FilmingTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    restart_drawing();
    if (const char* const path = std::getenv("PATH")) path_ = path;
    ::setenv("PATH", folder_.c_str(), 1);  // no ffmpeg there: pictures alone
  }
  void TearDown() override {
    if (path_) ::setenv("PATH", path_->c_str(), 1);
    ProgramTest::TearDown();
  }
  base::Status start(int fps) { return start_movie(*program_, {folder_ / "movie", fps, false, {}}, true); }
  // Returns the steps between pictures.
  std::vector<int> film(int ticks) {
    std::vector<int> steps;
    app::film(*program_, ticks, [&](int some) { steps.push_back(some); });
    return steps;
  }
  // -1 once the movie has ended.
  int frames() const { return program_->filming && program_->filming->movie ? program_->filming->movie->frames() : -1; }
  std::size_t pictures_in(const char* name) const {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / name))
      count += entry.path().extension() == ".png" ? 1 : 0;
    return count;
  }
  std::optional<std::string> path_;
};

TEST_F(FilmingTest, without_a_movie_ticks_go_by_at_once) {
  EXPECT_EQ(film(10), std::vector{10});
  EXPECT_EQ(film(0), std::vector{0});
}

TEST_F(FilmingTest, pictures_are_due_by_ticks_each_before_those_that_follow_it) {
  ASSERT_TRUE(start(30).ok());
  EXPECT_EQ(film(10), (std::vector{4, 4, 2}));
  EXPECT_EQ(frames(), 3) << "of the ticks 0, 4 and 8";
  EXPECT_EQ(film(2), std::vector{2});
  EXPECT_EQ(frames(), 3) << "that of tick 12 waits for what is to be seen then";
  EXPECT_EQ(film(0), std::vector{0});
  EXPECT_EQ(frames(), 3);
  EXPECT_EQ(film(1), std::vector{1});
  EXPECT_EQ(frames(), 4);
}

TEST_F(FilmingTest, at_every_rate_there_are_as_many_pictures_as_the_time_has_however_it_is_cut) {
  constexpr int kTicks = 61;
  for (const int fps : script::kMovieRates) {
    ASSERT_TRUE(start(fps).ok());
    int ticks = 0;
    for (int cut = 1; ticks < kTicks; cut = cut * 3 % 7 + 1) {
      const int some = std::min(cut, kTicks - ticks);
      int went = 0;
      for (const int step : film(some)) went += step;
      EXPECT_EQ(went, some) << fps;
      ticks += some;
    }
    int due = 0;  // pictures of the ticks 0, 1 .. 60 that show a whole multiple of 1/fps s
    for (int tick = 0; tick < kTicks; ++tick) due += tick * fps % world::kTicksPerSecond == 0 ? 1 : 0;
    EXPECT_EQ(frames(), due) << fps;
    ASSERT_TRUE(finish_movie(*program_).ok());
    EXPECT_EQ(pictures_in("movie"), static_cast<std::size_t>(due)) << fps;
  }
}

TEST_F(FilmingTest, one_movie_at_a_time) {
  ASSERT_TRUE(start(60).ok());
  EXPECT_EQ(start(60).code, base::Code::refused);
  (void)film(1);
  ASSERT_TRUE(stop_movie(*program_).ok());
  EXPECT_EQ(start(60).code, base::Code::refused) << "its file is being made";
  ASSERT_TRUE(finish_movie(*program_).ok());
  EXPECT_TRUE(start(60).ok());
}

TEST_F(FilmingTest, pictures_keep_the_first_one_s_size) {
  ASSERT_TRUE(start(60).ok());
  (void)film(1);
  program_->surface->resize({80, 60});
  (void)film(2);
  ASSERT_EQ(frames(), 2);
  ASSERT_TRUE(finish_movie(*program_).ok());
  for (const int number : {0, 1}) {
    const std::filesystem::path path = folder_ / "movie" / Movie::picture_name(number);
    const auto image = gfx::decode_png(*program_->files.read(path), path.string());
    ASSERT_TRUE(image.ok());
    EXPECT_EQ(image->width, 64) << number;
    EXPECT_EQ(image->height, 48) << number;
  }
}

TEST_F(FilmingTest, a_movie_is_named_by_the_track_or_its_file_and_its_folder_by_the_whole_path) {
  const char* const home = std::getenv("HOME");
  ::setenv("HOME", folder_.c_str(), 1);  // without Videos and Pictures
  EXPECT_EQ(movie_folder(*program_), std::filesystem::current_path() / "untitled-movie-1");
  program_->session.file.path = "rides/Wild_Mouse.json";
  EXPECT_EQ(movie_folder(*program_).filename(), "wild-mouse-movie-1");
  program_->session.document.name = "Red Comet";
  EXPECT_EQ(movie_folder(*program_).filename(), "red-comet-movie-1");
  home != nullptr ? ::setenv("HOME", home, 1) : ::unsetenv("HOME");
}

TEST_F(FilmingTest, a_folder_that_cannot_be_made_is_refused) {
  ASSERT_TRUE(program_->files.write_atomic(folder_ / "movie", "a file").ok());
  EXPECT_EQ(start(30).code, base::Code::io);
  EXPECT_FALSE(program_->filming);
}

TEST_F(FilmingTest, a_movie_by_hand_starts_with_the_ride_and_ends_with_its_lap) {
  build_track(*program_);
  ::setenv("XDG_VIDEOS_DIR", folder_.c_str(), 1);
  follow_movie(*program_, ui::MovieRequest::start);
  ::unsetenv("XDG_VIDEOS_DIR");
  ASSERT_TRUE(program_->filming);
  EXPECT_TRUE(program_->filming->by_hand);
  EXPECT_EQ(program_->session.motion.state, world::RideState::running);
  EXPECT_GT(program_->filming->lap_ticks, 0);
  (void)film(10);
  follow_movie(*program_, ui::MovieRequest::none);
  ASSERT_TRUE(program_->filming && program_->filming->movie) << "the lap is not over";
  program_->session.motion.carts.items()[0].laps = 1;
  follow_movie(*program_, ui::MovieRequest::none);
  EXPECT_FALSE(program_->filming) << "the pictures are there, and there is no ffmpeg to wait for";
  EXPECT_EQ(program_->session.notices.list.back().kind, edit::NoticeKind::info);
  EXPECT_EQ(pictures_in("untitled-movie-1"), 3u);
}

TEST_F(FilmingTest, a_movie_by_hand_that_cannot_be_written_says_so_once) {
  build_track(*program_);
  ::setenv("XDG_VIDEOS_DIR", folder_.c_str(), 1);
  follow_movie(*program_, ui::MovieRequest::start);
  ::unsetenv("XDG_VIDEOS_DIR");
  const std::size_t notices = program_->session.notices.list.size();
  std::filesystem::create_directories(folder_ / "untitled-movie-1" / "frame-00002.png");  // in the way
  for (int i = 0; i < 100 && program_->filming; ++i) {
    if (recording(*program_)) (void)film(4);
    follow_movie(*program_, ui::MovieRequest::none);
  }
  EXPECT_FALSE(program_->filming);
  EXPECT_EQ(program_->session.notices.list.size(), notices + 1);
  const std::string said = last_notice(*program_);
  EXPECT_TRUE(said.starts_with("The recording stopped. ")) << said;
  EXPECT_NE(said.find("frame-00002.png"), std::string::npos) << said;
}

TEST_F(FilmingTest, a_movie_by_hand_can_be_stopped_before) {
  build_track(*program_);
  ::setenv("XDG_VIDEOS_DIR", folder_.c_str(), 1);
  follow_movie(*program_, ui::MovieRequest::start);
  ::unsetenv("XDG_VIDEOS_DIR");
  ASSERT_TRUE(program_->filming);
  (void)film(5);
  follow_movie(*program_, ui::MovieRequest::stop);
  EXPECT_FALSE(program_->filming);
  EXPECT_EQ(pictures_in("untitled-movie-1"), 2u);
}

}  // namespace filming_test
}  // namespace coaster::app
