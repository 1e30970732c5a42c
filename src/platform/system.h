// What a desktop (desktop.cpp) and a page (web_page.cpp) each have in their own way: the system's fonts (fontconfig)
// for characters that the program's own font lacks, the loop of frames, and a browser's encoder of movies.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/status.h"

namespace coaster::platform {

// A font file of outlines, and the font's place in it.
struct SystemFont {
  std::string path;
  int index = 0;
};

// Returns the fonts that together have as many of the characters as the system's fonts have; none without fontconfig.
std::vector<SystemFont> fonts_with(std::vector<unsigned> characters);

// --- The loop of frames, which a browser runs itself

// Calls `step` until it returns false, then returns the result of `finish`. In a web page it returns 0 at once: the
// browser continues to call `step`, and after the last one the program ends with the result of `finish`.
int run_frames(std::function<bool()> step, std::function<int()> finish);

// --- A browser's encoder of movies

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
