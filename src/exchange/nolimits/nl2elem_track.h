// Builds a document from an element's vertices and rolls.
#pragma once

#include <optional>

#include "exchange/nolimits/nl2_spline.h"
#include "exchange/own/track_file.h"

namespace coaster::exchange {

struct ElementRoll {
  glm::dvec3 up{0, 1, 0};  // unit
  double coord = 0;        // fraction of the track's length, 0..1
};

struct ElementFile {
  std::vector<SplineVertex> vertices;  // for a closed track the first is not repeated
  std::vector<int> lines;              // of the vertices
  std::vector<ElementRoll> rolls;      // in any order
  bool closed = false;
};

struct ElementTrack {
  world::Document document;
  ImportReport report;
  std::optional<std::size_t>
      pathless;  // the vertex where the curve has no direction or exceeds the limits; there is no document then
};

ElementTrack track_of(const ElementFile& file);

}  // namespace coaster::exchange
