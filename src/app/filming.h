// Records a movie while the program runs: takes each picture when its tick is due, whatever advances the ticks.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "app/movie.h"
#include "app/ride_summary.h"
#include "base/status.h"
#include "ui/context/output.h"
#include "ui/context/state.h"

namespace coaster::app {

struct Program;

struct Filming {
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
void follow_movie(Program& program, ui::MovieWish wish);

// Records a movie without a window: rides from the start for a lap or for `pictures`, with the selected camera;
// measures the ride. Waits for the movie file.
base::Status film_ride(Program& program, const MovieOrder& order, std::optional<std::int64_t> pictures,
                       RideSummary& summary);

// True while a movie takes pictures.
bool recording(const Program& program);

// Starts the ride at its start, so that the lap is complete.
base::Status begin_lap(Program& program);

// True if the first train has completed the lap, or the ride has ended.
bool lap_is_done(const edit::Session& session);

}  // namespace coaster::app
