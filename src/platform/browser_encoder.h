// A browser's encoder of movies: web_page.cpp has it, desktop.cpp says that there is none.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "base/status.h"

namespace coaster::platform {

// A browser's own encoder of movies (WebM). Only a page has one: elsewhere movies are files of pictures (app/movie.h).
class BrowserEncoder {
 public:
  // True in a page, even if its browser has no encoder.
  static bool in_page();
  // Begins a movie of `rate` pictures a second. Code::refused with the reason if the browser cannot encode.
  static base::Result<std::unique_ptr<BrowserEncoder>> start(int rate);
  // Without finish(): discards the movie. NOLINTNEXTLINE(performance-trivially-destructible): a page's does that
  ~BrowserEncoder();

  // False while several pictures wait: a page that goes on adding runs out of memory.
  bool ready() const;
  // Adds a picture, 4 bytes a pixel, the top row first. All have one size. Code::io once the encoder has failed.
  base::Status add(int width, int height, std::span<const std::uint8_t> rgba);
  // After the last picture: the browser downloads the file under this name once it is complete.
  void finish(const std::string& name);
  // After finish(): a line about the result, or nothing yet.
  std::optional<std::string> poll();
  double done() const;  // 0..1 of the pictures
};

}  // namespace coaster::platform
