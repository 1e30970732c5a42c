// Builds a document from an element's vertices and rolls.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exchange/nolimits/nl2_rolls.h"
#include "exchange/own/track_file.h"

namespace coaster::exchange {

struct ElementFile {
  std::vector<SplineVertex> vertices;  // for a closed track the last repeats the first
  std::vector<int> lines;              // line numbers of the vertices
  std::vector<ElementRoll> rolls;      // in any order
  bool closed = false;
  std::string weights;  // the name of the member that holds the vertices' weights; empty if all are 1
};

// A vertex that makes the file unusable.
struct ElementError {
  std::size_t vertex = 0;
  std::string expected, found;
};

struct ElementTrack {
  world::Document document;
  ImportReport report;
  std::vector<std::pair<std::size_t, std::string>> warnings;  // each with the vertex it is about
  std::optional<ElementError> error;                          // set: there is no document
};

ElementTrack track_of(const ElementFile& file);

}  // namespace coaster::exchange
