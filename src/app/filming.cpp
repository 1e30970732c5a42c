#include "app/filming.h"

#include <chrono>
#include <thread>

#include <fmt/format.h>

#include "app/frame.h"
#include "app/pictures.h"
#include "app/process.h"
#include "app/program.h"
#include "app/scene.h"
#include "base/console.h"
#include "edit/commands/commands_ride.h"
#include "platform/signals.h"

namespace coaster::app {
namespace {

gfx::Image picture(Program& program) {
  Filming& filming = *program.filming;
  if (!filming.scene_alone) {
    if (!is_drawn(program)) run_frame(program, {platform::Tick{0}}, 0);
    draw_pixels(program);
    return program.renderer->read_pixels();
  }
  platform::Size size{filming.shown.width, filming.shown.height};
  if (filming.movie->frames() == 0) size = program.surface->size();
  if (size.width < 1 || size.height < 1) size = {1280, 720};  // started while the window was minimised
  filming.shown.width = size.width, filming.shown.height = size.height;
  const view::Viewport whole{0, 0, static_cast<float>(size.width), static_cast<float>(size.height)};
  draw_scene_alone(program, view::view_of(program.picture.rig.eye, whole, program.picture.view.density), size);
  return program.renderer->read_pixels();
}

void take_picture(Program& program) {
  gfx::Image image = picture(program);
  if (!recording(program)) return;  // its frame has ended the movie
  Filming& filming = *program.filming;
  filming.failed = filming.movie->add(std::move(image));
  filming.shown.frames = filming.movie->frames();
  program.stats.movie_frames = filming.shown.frames;
  if (filming.failed) return;
  if (!filming.by_hand) edit::notify(program.session, filming.failed);  // else follow_movie() does
  (void)stop_movie(program);
}

// Returns the ticks of the first train's lap.
std::int64_t ticks_of_lap(edit::Session& session) {
  const sim::Ghost* const ghost =
      edit::rides_of(session).ride(session.document, session.derived, world::first_cart(session.document));
  return ghost && ghost->samples.size() > 1 ? static_cast<std::int64_t>(ghost->samples.size() - 1) : 0;
}

base::Status begin_filming(Program& program, base::Result<std::unique_ptr<Movie>> movie, bool scene_alone) {
  if (!movie) return movie.status();
  program.filming = std::make_unique<Filming>();
  program.filming->movie = std::move(*movie);
  program.filming->scene_alone = scene_alone;
  program.stats.movie_frames = 0;
  return {};
}

void start_by_hand(Program& program) {
  const bool in_page = platform::Encoder::in_page();
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

bool recording(const Program& program) { return program.filming && program.filming->movie; }

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
    Filming& filming = *program.filming;
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
  Filming& filming = *program.filming;
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
  Filming& filming = *program.filming;
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

void follow_movie(Program& program, ui::MovieWish wish) {
  if (wish == ui::MovieWish::start && !program.filming) start_by_hand(program);
  if (!program.filming || !program.filming->by_hand) return;  // a script's movie is under its own control
  if (wish == ui::MovieWish::stop) {
    if (recording(program)) (void)stop_movie(program);
    else program.filming.reset();  // the pictures are complete; nobody waits for the movie file
  }
  if (recording(program) && lap_is_done(program.session)) (void)stop_movie(program);
  if (!program.filming || !program.filming->encoder) return;
  Filming& filming = *program.filming;
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
  Filming& filming = *program.filming;
  filming.lap_ticks =
      pictures ? *pictures * filming.movie->ticks_a_frame() : std::min(kMostRideTicks, ticks_of_lap(program.session));
  const auto over = [&] {
    return pictures ? filming.shown.frames >= *pictures
                    : summary.ticks >= kMostRideTicks || lap_is_done(program.session);
  };
  const auto tick = [&](int ticks) {
    for (int i = 0; i < ticks; ++i) {
      advance(program, 1);
      measure(program.session, summary);
    }
  };
  while (recording(program) && !over() && platform::pending_signal() == 0) {
    film(program, 1, tick);
    if (filming.movie && filming.movie->wait() == 0) show_progress(program, "movie");
  }
  finish_summary(program.session, summary);
  return finish_movie(program);
}

}  // namespace coaster::app
