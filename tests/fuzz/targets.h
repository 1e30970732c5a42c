// The fuzz targets: every format of tracks that can be read (exchange/formats.h), and a row for each other reader. Each
// accepts any bytes, must not crash, and checks the reader's guarantees for accepted input.
#pragma once

#include <string_view>
#include <vector>

#include "exchange/formats.h"

namespace coaster::fuzz {

struct Target {
  // A format's extension without the dot; also of its folder in tests/fuzz/corpus, if it has one.
  std::string_view name;
  void (*reader)(std::string_view bytes) = nullptr;
  const exchange::TrackFormat* format = nullptr;  // instead of a reader

  void run(std::string_view bytes) const;
};

std::vector<Target> targets();

}  // namespace coaster::fuzz
