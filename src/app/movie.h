// A movie as numbered pictures at a fixed rate of ride time, and as MP4 and GIF if ffmpeg is installed; in a page as
// WebM by the browser. app/filming.h takes the pictures.
#pragma once

#include <deque>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/process.h"
#include "base/files.h"
#include "gfx/renderer.h"
#include "platform/encoder.h"
#include "script/movie_rates.h"
#include "world/motion.h"

namespace coaster::app {

struct MovieOrder {
  std::filesystem::path folder;
  int fps = script::kUsualMovieRate;  // one of script::kMovieRates
  bool gif = false;                   // also movie.gif
  base::Root root;                    // contains the folder
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
  std::unique_ptr<platform::Encoder> take_encoder() { return std::move(page_); }

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
  std::unique_ptr<platform::Encoder> page_;
};

// Makes FOLDER/movie.mp4 and FOLDER/movie.gif from the pictures, by ffmpeg in a separate process.
class MovieEncoder {
 public:
  // Begins, with the order of Movie::order(): ffmpeg writes new files, which get their names when they are whole.
  // Without ffmpeg, and for a movie without pictures, there is nothing to do. A page's encoder finishes the file.
  MovieEncoder(const MovieOrder& order, int frames, std::unique_ptr<platform::Encoder> page = nullptr);

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
  std::unique_ptr<platform::Encoder> page_;
};

}  // namespace coaster::app
