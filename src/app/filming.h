// Recording a movie while the program goes on: takes each picture when its tick has come, whoever advances the ticks.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "app/movie.h"
#include "app/ride_summary.h"
#include "base/status.h"
#include "ui/host/host.h"

namespace coaster::app {

struct Program;

struct Filming {
  std::unique_ptr<Movie> movie;           // null once all pictures are taken
  std::unique_ptr<MovieEncoder> encoder;  // from then on
  bool scene_alone =
      false;  // without panels and what is selected, as large as the first picture whatever becomes of the window
  bool by_hand = false;        // panels show it, and it ends by itself with the lap
  std::int64_t lap_ticks = 0;  // that a lap is expected to take; 0: nobody knows
  base::Status failed;         // why it ended early
  ui::MovieState shown;        // what panels see of it
};

// Begins; pictures come with the ticks that film() advances. Code::refused while another one is recorded or its file is
// made, Code::io for a folder that cannot be written to.
base::Status start_movie(Program& program, const MovieOrder& order, bool scene_alone = false);

// Ticks that go by: calls step(n) for n ticks at a time, once for none, and takes the pictures that are due in between,
// each before the ticks that follow it. Without a movie, step(ticks). A picture that cannot be taken ends the movie,
// with a notice.
void film(Program& program, int ticks, const std::function<void(int)>& step);

// No more pictures: those under way are written, and the movie file is begun. Ok when nothing is recorded; else the
// first failure of the pictures.
base::Status stop_movie(Program& program);

// Stops, waits for the movie file, and says in a line on stderr what there is now. A failure to make the file is told
// there and is none.
base::Status finish_movie(Program& program);

// In a window, once a frame before its ticks: what the panels asked for, the end of the lap, the end of the movie file.
void follow_movie(Program& program, ui::MovieWish wish);

// Without a window: the ride from its start, for a lap or for `pictures`, by the camera chosen; measured as it goes.
// Waits for the movie file.
base::Status film_ride(Program& program, const MovieOrder& order, std::optional<std::int64_t> pictures,
                       RideSummary& summary);

// Whether the first train has come round, or the ride is over.
bool lap_is_done(const edit::Session& session);

}  // namespace coaster::app
