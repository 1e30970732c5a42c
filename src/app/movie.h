// A movie as numbered pictures at a fixed rate of ride time, and as MP4 and GIF if ffmpeg is installed; in a page as
// WebM by the browser; and its recording while the program runs: each picture is taken when its tick is due, whatever
// advances the ticks.
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/process.h"
#include "app/ride_summary.h"
#include "base/files.h"
#include "base/status.h"
#include "gfx/renderer.h"
#include "platform/system.h"
#include "script/statements.h"
#include "ui/context/state.h"
#include "world/motion.h"

namespace coaster::app {

struct MovieOrder {
  std::filesystem::path folder;
  int fps = script::kUsualMovieRate;  // one of script::kMovieRates
  bool gif = false;                   // also movie.gif
  base::FileRoot root;                // contains the folder
};

// Takes pictures, in order, and writes them to FOLDER/frame-00000.png and so on.
class Movie {
 public:
  // Creates the folder and removes the pictures of an earlier movie from it, and no other files. Nothing follows links
  // below it. Code::io with the reason.
  static base::Result<std::unique_ptr<Movie>> start(const MovieOrder& order);

  // A page's: the browser encodes the pictures while they are taken, and downloads a file of this name. Code::refused
  // with the reason if it cannot.
  static base::Result<std::unique_ptr<Movie>> start_in_page(const std::string& name);

  const MovieOrder& order() const { return order_; }  // its root is the folder
  int frames() const { return frames_; }              // pictures taken; up to the first that could not be written
  int ticks_a_frame() const { return world::kTicksPerSecond / order_.fps; }
  int wait() const { return wait_; }        // ticks until the next picture is due; 0: now
  void pass(int ticks) { wait_ -= ticks; }  // at most wait()
  // Adds the picture that is due. Background threads write it, as many as there are processors, at most kMostWriters.
  // Code::io if an earlier one could not be written, Code::refused for a picture of another size than the first; both
  // are final.
  base::Status add(gfx::Image picture);
  // False while the browser has to encode others first.
  bool ready() const { return !page_ || page_->ready(); }
  // Waits until all are written. Returns the first failure, in every call.
  base::Status finish();
  // Returns the browser's encoder; null but for a page's movie.
  std::unique_ptr<platform::BrowserEncoder> take_encoder() { return std::move(page_); }

  static constexpr std::size_t kMostWriters = 8;
  static std::string picture_name(int number);

 private:
  explicit Movie(const MovieOrder& order);
  void collect(std::size_t room);

  MovieOrder order_;
  int frames_ = 0, wait_ = 0, width_ = 0, height_ = 0;
  std::size_t most_writers_;
  std::deque<std::future<base::Status>> writers_;
  base::Status failed_;
  std::unique_ptr<platform::BrowserEncoder> page_;
};

// Makes FOLDER/movie.mp4 and FOLDER/movie.gif from the pictures, by ffmpeg in a separate process.
class MovieEncoder {
 public:
  // Begins, with the order of Movie::order(): ffmpeg writes new files, which get their names when they are whole.
  // Without ffmpeg, and for a movie without pictures, there is nothing to do. A page's encoder finishes the file.
  MovieEncoder(const MovieOrder& order, int frames, std::unique_ptr<platform::BrowserEncoder> page = nullptr);

  // Returns a line about the result once everything is made or failed, without waiting.
  std::optional<std::string> poll();
  double done() const { return page_ ? page_->done() : done_; }  // 0..1

 private:
  void read_progress();
  void next();

  MovieOrder order_;
  int frames_;
  std::string program_, error_;
  std::vector<std::string> files_, made_;  // names in the folder; files_: still to do, the first is in progress
  std::size_t all_ = 0;
  double done_ = 0;
  std::optional<base::NewFile> making_;
  Process process_;
  std::unique_ptr<platform::BrowserEncoder> page_;
};

struct Program;

struct MovieInProgress {
  std::unique_ptr<Movie> movie;           // null once all pictures are taken
  std::unique_ptr<MovieEncoder> encoder;  // null until all pictures are taken
  // Without panels and selection, in the size of the first picture even if the window changes.
  bool scene_alone = false;
  bool by_hand = false;        // started in a window: panels show it, and it ends with the lap
  std::int64_t lap_ticks = 0;  // expected ticks of a lap; 0: unknown
  base::Status failed;         // why it ended early
  ui::MovieState shown;        // shown by panels
};

// Starts a movie; film() takes its pictures. Code::refused while another one is recorded or encoded, Code::io if the
// folder cannot be written.
base::Status start_movie(Program& program, const MovieOrder& order, bool scene_alone = false);

// Advances ticks: calls step(n) for n ticks at a time, once for none, and takes the pictures that are due in between,
// each before the ticks that follow it. Without a movie, calls step(ticks). If a picture fails, the movie ends with a
// notice.
void film(Program& program, int ticks, const std::function<void(int)>& step);

// Returns the ticks of a window's frame while a movie is recorded: those to the next picture, or none while the
// browser has others to encode.
int ticks_to_film(const Program& program);

// Stops taking pictures: finishes those in progress and starts encoding. Ok if nothing is recorded; else the first
// failure of the pictures.
base::Status stop_movie(Program& program);

// Stops, waits for the movie file, and prints the result in a line to stderr. A failure of the encoder is reported
// there and is no error.
base::Status finish_movie(Program& program);

// Handles a movie in a window: the panels' request, the end of the lap, the end of the movie file. Call it once a
// frame, before the frame's ticks.
void follow_movie(Program& program, ui::MovieRequest wish);

// Records a movie without a window: rides from the start for a lap or for `pictures`, with the selected camera;
// measures the ride. Waits for the movie file.
base::Status film_ride(Program& program, const MovieOrder& order, std::optional<std::int64_t> pictures,
                       RideSummary& summary);

// True while a movie takes pictures.
bool recording(const Program& program);

// Advances the ride by a tick and measures it.
void ride_tick(Program& program, RideSummary& summary);
// Starts the ride at its start, so that the lap is complete.
base::Status begin_lap(Program& program);

// True if the first train has completed the lap, or the ride has ended.
bool lap_is_done(const edit::Session& session);

}  // namespace coaster::app
