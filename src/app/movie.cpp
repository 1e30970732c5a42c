#include "app/movie.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/frame.h"
#include "app/pictures.h"
#include "app/program.h"
#include "app/scene.h"
#include "base/console.h"
#include "base/crash_guard.h"
#include "base/parallel.h"
#include "base/text.h"
#include "edit/commands/commands_ride.h"
#include "gfx/image.h"
#include "platform/signals.h"

namespace coaster::app {
namespace {

constexpr std::string_view kBefore = "frame-", kAfter = ".png";
constexpr std::size_t kDigits = 5;

bool is_picture_name(const std::string& name) {
  if (name.size() <= kBefore.size()) return false;
  const auto number = base::parse_int(name.substr(kBefore.size(), kDigits));
  return number && *number >= 0 && name == Movie::picture_name(static_cast<int>(*number));
}

// Returns ffmpeg's arguments for one file, written to kGivenFile; words[0] is `program`. Names are relative to the
// folder, where the process runs, because ffmpeg would read a "%" in the folder's name as a pattern.
std::vector<std::string> arguments(const std::string& program, const MovieOrder& order, int frames,
                                   const std::string& file) {
  std::vector<std::string> words{program,         "-nostdin",  "-y",     "-loglevel",      "error",
                                 "-nostats",      "-progress", "pipe:1", "-framerate",     std::to_string(order.fps),
                                 "-start_number", "0",         "-i",     "frame-%05d.png", "-frames:v"};
  if (file.ends_with(".gif")) {
    // At most 25 a second, because GIF delays are in hundredths of a second, and 640 pixels wide; one palette for the
    // whole movie.
    const int fps = std::min(order.fps, 25);
    words.push_back(std::to_string(std::max(1, frames * fps / order.fps)));
    words.insert(
        words.end(),
        {"-filter_complex", fmt::format("fps={},scale='min(640,iw)':-2:flags=lanczos,split[a][b];"
                                        "[a]palettegen=stats_mode=diff[p];[b][p]paletteuse=dither=bayer:bayer_scale=4",
                                        fps)});
  } else {
    words.push_back(std::to_string(frames));
    // Compatible with all players: 4:2:0 with even sides.
    words.insert(words.end(), {"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-c:v", "libx264", "-preset", "medium", "-crf",
                               "18", "-pix_fmt", "yuv420p", "-movflags", "+faststart"});
  }
  words.insert(words.end(), {"-f", file.substr(file.rfind('.') + 1), kGivenFile});
  return words;
}

gfx::Image picture(Program& program) {
  MovieInProgress& filming = *program.filming;
  if (!filming.scene_alone) {
    if (!is_drawn(program)) run_frame(program, {platform::Tick{0}}, 0);
    draw_pixels(program);
    return program.renderer->read_pixels();
  }
  platform::Size size{filming.shown.width, filming.shown.height};
  if (filming.movie->frames() == 0) size = program.surface->size();
  if (size.width < 1 || size.height < 1) size = {1280, 720};  // started while the window was minimised
  filming.shown.width = size.width, filming.shown.height = size.height;
  draw_scene_alone(program, size);
  return program.renderer->read_pixels();
}

void take_picture(Program& program) {
  gfx::Image image = picture(program);
  if (!recording(program)) return;  // its frame has ended the movie
  MovieInProgress& filming = *program.filming;
  filming.failed = filming.movie->add(std::move(image));
  filming.shown.frames = filming.movie->frames();
  program.stats.movie_frames = filming.shown.frames;
  if (filming.failed) return;
  if (!filming.by_hand) edit::notify(program.session, filming.failed);  // else follow_movie() does
  (void)stop_movie(program);
}

// Returns the ticks of the first train's lap.
std::int64_t ticks_of_lap(edit::Session& session) {
  const sim::SimulatedRide* const simulated =
      edit::rides_of(session).ride(session.document, session.derived, world::first_cart(session.document));
  return simulated && simulated->samples.size() > 1 ? static_cast<std::int64_t>(simulated->samples.size() - 1) : 0;
}

base::Status begin_filming(Program& program, base::Result<std::unique_ptr<Movie>> movie, bool scene_alone) {
  if (!movie) return movie.status();
  program.filming = std::make_unique<MovieInProgress>();
  program.filming->movie = std::move(*movie);
  program.filming->scene_alone = scene_alone;
  program.stats.movie_frames = 0;
  return {};
}

void start_by_hand(Program& program) {
  const bool in_page = platform::BrowserEncoder::in_page();
  const std::filesystem::path folder = movie_folder(program);
  const std::string file = folder.filename().string() + ".webm";
  base::Status begun = begin_lap(program);
  if (begun && in_page) begun = begin_filming(program, Movie::start_in_page(file), true);
  else if (begun) begun = start_movie(program, {folder, script::kUsualMovieRate, false, program.files.root()}, true);
  if (!begun) return edit::notify(program.session, begun);
  program.filming->by_hand = true;
  edit::notify(program.session, edit::NoticeKind::info,
               in_page ? fmt::format("Recording one lap as {}, which will be downloaded.", file)
               : find_program("ffmpeg").empty()
                   ? fmt::format("Recording one lap as pictures in {}. Without ffmpeg "
                                 "there is no movie file.",
                                 folder.string())
                   : fmt::format("Recording one lap as pictures and movie.mp4 in {}.", folder.string()));
  program.filming->lap_ticks = ticks_of_lap(program.session);
}

void show_progress(const Program& program, const char* what) {
  base::print_progress(fmt::format("{}: {} pictures, {:3.0f} % ", what, program.filming->shown.frames,
                                   100 * program.filming->shown.done));
}

}  // namespace

std::string Movie::picture_name(int number) { return fmt::format("{}{:0{}}{}", kBefore, number, kDigits, kAfter); }

Movie::Movie(const MovieOrder& order)
    : order_(order), most_writers_(std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, kMostWriters)) {}

base::Result<std::unique_ptr<Movie>> Movie::start(const MovieOrder& order) {
  COASTER_CHECK(script::is_movie_rate(order.fps), "a picture of a movie shows a whole tick");
  auto root = order.root.open(order.folder);
  if (!root) return root.status();
  MovieOrder below = order;
  below.root = std::move(*root);
  base::Files files(below.root);
  if (const base::Status removed = files.remove_made(order.folder, is_picture_name); !removed) return removed;
  return std::unique_ptr<Movie>(new Movie(below));
}

base::Result<std::unique_ptr<Movie>> Movie::start_in_page(const std::string& name) {
  MovieOrder order;
  order.folder = name;
  auto encoder = platform::BrowserEncoder::start(order.fps);
  if (!encoder) return encoder.status();
  std::unique_ptr<Movie> movie(new Movie(order));
  movie->page_ = std::move(*encoder);
  return movie;
}

// Waits for the oldest writers until at most `room` are left.
void Movie::collect(std::size_t room) {
  while (writers_.size() > room) {
    const base::Status wrote = writers_.front().get();
    writers_.pop_front();
    if (!failed_ || wrote) continue;
    failed_ = {base::Code::io, wrote.message};
    frames_ -= static_cast<int>(writers_.size()) + 1;  // those before it are saved
  }
}

base::Status Movie::add(gfx::Image picture) {
  constexpr int kMost = 100'000;  // limited by the digits of the names
  COASTER_CHECK(wait_ == 0, "no picture is due");
  if (frames_ == 0) width_ = picture.width, height_ = picture.height;
  if (failed_ && (picture.width != width_ || picture.height != height_))
    failed_ = {base::Code::refused, fmt::format("a movie's pictures have one size: {}x{} became {}x{}", width_, height_,
                                                picture.width, picture.height)};
  if (failed_ && frames_ >= kMost)
    failed_ = {base::Code::refused, fmt::format("a movie has at most {} pictures", kMost)};
  if (!failed_) return failed_;
  wait_ = ticks_a_frame();
  if (page_) return ++frames_, failed_ = page_->add(picture.width, picture.height, picture.rgba);
  collect(most_writers_ - 1);
  if (!failed_) return failed_;
  const auto write = [root = order_.root, path = order_.folder / picture_name(frames_++), image = std::move(picture)] {
    const base::HandlerStack stack;
    base::Files files(root);  // pictures bypass the program's file handling: injected faults are meant for documents
    return files.write_atomic(path, gfx::encode_png(image));
  };
  // Where the system refuses a thread, collect() writes the picture. std::async then needs `write` again: it may not
  // be moved.
  const auto policy = base::has_threads() ? std::launch::async | std::launch::deferred : std::launch::deferred;
  writers_.push_back(std::async(policy, write));
  return failed_;
}

base::Status Movie::finish() {
  collect(0);
  return failed_;
}

MovieEncoder::MovieEncoder(const MovieOrder& order, int frames, std::unique_ptr<platform::BrowserEncoder> page)
    : order_(order), frames_(frames), program_(find_program("ffmpeg")), page_(std::move(page)) {
  if (page_ && frames > 0) page_->finish(order.folder.string());
  if (page_ || program_.empty() || frames < 1) return;
  files_ = {"movie.mp4"};
  if (order.gif) files_.emplace_back("movie.gif");
  all_ = files_.size();
  next();
}

void MovieEncoder::next() {
  if (files_.empty()) return;
  auto made = base::Files(order_.root).create(order_.folder / files_.front());
  base::Status started = made.status();
  if (made) {
    making_.emplace(std::move(*made));
    started = process_.start(arguments(program_, order_, frames_, files_.front()), making_->folder(), true,
                             making_->file().get());
  }
  if (started) return;
  making_.reset();
  error_ = started.message;
  files_.clear();
}

// Parses ffmpeg's output. Lines "frame=12" report the progress; other lines with a "=" in their first word belong to
// the same report; the last other line is an error.
void MovieEncoder::read_progress() {
  std::string& text = process_.output();
  const bool ended = !process_.running();
  for (;;) {
    const std::size_t end = text.find('\n');
    if (end == std::string::npos && !(ended && !text.empty())) return;
    std::string line = text.substr(0, end);
    text.erase(0, end == std::string::npos ? end : end + 1);
    while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back()))) line.pop_back();
    if (line.starts_with("frame=")) {
      const double part = std::clamp(std::atof(line.c_str() + 6) / std::max(1, frames_), 0.0, 1.0);
      done_ = std::max(done_, (static_cast<double>(made_.size()) + part) / static_cast<double>(all_));
    } else if (!line.empty() && line.find('=') > line.find(' ')) {
      error_ = line;
    }
  }
}

std::optional<std::string> MovieEncoder::poll() {
  if (frames_ < 1) return "The movie has no pictures because no time passed.";
  if (page_) return page_->poll();
  const std::string pictures = fmt::format("Saved {} picture{}", frames_, frames_ == 1 ? "" : "s"),
                    folder = order_.folder.string();
  if (program_.empty()) return fmt::format("{} in {}. Install ffmpeg to make a movie of them.", pictures, folder);
  if (process_.running()) {
    const std::optional<int> status = process_.poll();
    read_progress();
    if (!status) return std::nullopt;
    const bool placed = *status == 0 && making_->put_in_place();
    if (*status == 0 && !placed) error_ = std::strerror(errno);
    making_.reset();
    if (placed) {
      made_.push_back(files_.front());
      files_.erase(files_.begin());
      error_.clear();  // warnings
      next();
    } else {
      if (error_.empty())
        error_ =
            *status > 128 ? fmt::format("ended by signal {}", *status - 128) : fmt::format("exit code {}", *status);
      error_ = fmt::format("There is no {} because ffmpeg failed: {}", files_.front(), error_);
      files_.clear();
    }
    if (process_.running()) return std::nullopt;
  }
  done_ = 1;
  return fmt::format("{} in {}{}{}.{}{}", pictures, folder, made_.empty() ? "" : ", with ", fmt::join(made_, " and "),
                     error_.empty() ? "" : " ", error_);
}

bool recording(const Program& program) { return program.filming && program.filming->movie; }

void ride_tick(Program& program, RideSummary& summary) {
  advance(program, 1);
  measure(program.session, summary);
}

base::Status begin_lap(Program& program) {
  if (const base::Status stopped = apply(program, edit::RideStop{}); !stopped) return stopped;
  return apply(program, edit::RideStart{});
}

bool lap_is_done(const edit::Session& session) {
  if (session.motion.state != world::RideState::running) return true;
  return session.motion.carts.size() > 0 && session.motion.carts.items()[0].laps != 0;
}

base::Status start_movie(Program& program, const MovieOrder& order, bool scene_alone) {
  if (program.filming) return {base::Code::refused, "a movie is already being made"};
  return begin_filming(program, Movie::start(order), scene_alone);
}

void film(Program& program, int ticks, const std::function<void(int)>& step) {
  bool stepped = false;
  while (recording(program) && ticks > 0) {
    if (program.filming->movie->wait() == 0) {
      take_picture(program);
      continue;
    }
    const int some = std::min(ticks, program.filming->movie->wait());
    step(some);
    stepped = true;
    ticks -= some;
    if (!recording(program)) break;  // the frame has ended it
    MovieInProgress& filming = *program.filming;
    filming.movie->pass(some);
    filming.shown.ticks += some;
    filming.shown.done =
        filming.lap_ticks > 0
            ? std::min(1.0, static_cast<double>(filming.shown.ticks) / static_cast<double>(filming.lap_ticks))
            : 0;
  }
  if (ticks > 0 || !stepped) step(ticks);
}

int ticks_to_film(const Program& program) {
  const Movie& movie = *program.filming->movie;
  return movie.ready() ? movie.ticks_a_frame() : 0;
}

base::Status stop_movie(Program& program) {
  if (!recording(program)) return {};
  MovieInProgress& filming = *program.filming;
  const base::Status written = filming.movie->finish();
  if (filming.failed) filming.failed = written;
  filming.encoder =
      std::make_unique<MovieEncoder>(filming.movie->order(), filming.movie->frames(), filming.movie->take_encoder());
  filming.movie.reset();
  filming.shown.encoding = true;
  filming.shown.done = 0;
  return filming.failed;
}

base::Status finish_movie(Program& program) {
  if (!program.filming) return {};
  (void)stop_movie(program);
  MovieInProgress& filming = *program.filming;
  for (;;) {
    if (const auto line = filming.encoder->poll()) {
      base::print_error(*line);
      break;
    }
    if (platform::pending_signal() != 0) break;
    filming.shown.done = filming.encoder->done();
    show_progress(program, "movie file");
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  const base::Status failed = filming.failed;
  program.filming.reset();
  return failed;
}

void follow_movie(Program& program, ui::MovieRequest wish) {
  if (wish == ui::MovieRequest::start && !program.filming) start_by_hand(program);
  if (!program.filming || !program.filming->by_hand) return;  // a script's movie is under its own control
  if (wish == ui::MovieRequest::stop) {
    if (recording(program)) (void)stop_movie(program);
    else program.filming.reset();  // the pictures are complete; nobody waits for the movie file
  }
  if (recording(program) && lap_is_done(program.session)) (void)stop_movie(program);
  if (!program.filming || !program.filming->encoder) return;
  MovieInProgress& filming = *program.filming;
  filming.shown.done = filming.encoder->done();
  const auto line = filming.encoder->poll();
  if (!line) return;
  if (filming.failed) edit::notify(program.session, edit::NoticeKind::info, *line);
  else edit::notify(program.session, edit::NoticeKind::error, "The recording stopped. " + filming.failed.message);
  program.filming.reset();
}

base::Status film_ride(Program& program, const MovieOrder& order, std::optional<std::int64_t> pictures,
                       RideSummary& summary) {
  if (const base::Status begun = begin_lap(program); !begun) return begun;
  if (const base::Status started = start_movie(program, order, true); !started) return started;
  MovieInProgress& filming = *program.filming;
  filming.lap_ticks =
      pictures ? *pictures * filming.movie->ticks_a_frame() : std::min(kMostRideTicks, ticks_of_lap(program.session));
  const auto over = [&] {
    return pictures ? filming.shown.frames >= *pictures
                    : summary.ticks >= kMostRideTicks || lap_is_done(program.session);
  };
  const auto tick = [&](int ticks) {
    for (int i = 0; i < ticks; ++i) ride_tick(program, summary);
  };
  while (recording(program) && !over() && platform::pending_signal() == 0) {
    film(program, 1, tick);
    if (filming.movie && filming.movie->wait() == 0) show_progress(program, "movie");
  }
  finish_summary(program.session, summary);
  return finish_movie(program);
}

}  // namespace coaster::app
