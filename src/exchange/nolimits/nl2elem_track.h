// Builds a document from an element's vertices and rolls.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exchange/nolimits/nl2_rolls.h"
#include "exchange/own/track_file.h"

namespace coaster::exchange {

struct ElementFile {
  std::vector<SplineVertex> vertices;  // for a closed track the last is at the first
  std::vector<int> lines;              // of the vertices
  std::vector<ElementRoll> rolls;      // in any order
  bool closed = false;
};

// A vertex that makes the file unusable.
struct ElementError {
  std::size_t vertex = 0;
  std::string expected, found;
};

struct ElementTrack {
  world::Document document;
  ImportReport report;
  std::vector<std::pair<std::size_t, std::string>> warnings;  // with the vertex each is about
  std::optional<ElementError> error;                          // there is no document then
};

ElementTrack track_of(const ElementFile& file);

}  // namespace coaster::exchange
