// What is fuzzed: every format of tracks that can be read (exchange/formats.h), and a row for each other reader. Each
// takes any bytes, must not crash, and checks what a reader promises about what it accepts.
#pragma once

#include <string_view>
#include <vector>

#include "exchange/formats.h"

namespace coaster::fuzz {

struct Target {
  std::string_view name;  // a format's ending without the dot; of its folder in tests/fuzz/corpus, where it has one
  void (*reader)(std::string_view bytes) = nullptr;
  const exchange::Format* format = nullptr;  // in place of a reader

  void run(std::string_view bytes) const;
};

std::vector<Target> targets();

}  // namespace coaster::fuzz
