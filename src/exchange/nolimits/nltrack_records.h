// The records of a NoLimits 1 track file, with every number checked. nltrack.h makes a document of them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "base/status.h"

namespace coaster::exchange {

struct NltrackKnot {
  glm::vec3 point, in, out;  // m: the knot, the ends of its handles
  float roll = 0;            // radians, within 10,000 turns; positive to the left in the file
  std::size_t number = 0;    // in the file, from 1
  std::size_t offset = 0;    // byte of the record in the file
};

struct NltrackRecords {
  std::vector<NltrackKnot> knots;
  bool closed = false;
};

// Code::bad_file with "NAME: error: at byte OFFSET: MESSAGE".
base::Status bad_nltrack(std::string_view name, std::size_t offset, const std::string& message);

// Returns the knots of chunk BEZR and the closed byte of chunk SEGM. Code::bad_file with the byte and the reason for
// chunks that are missing or cut off, coordinates beyond world::kMaxCoordinate, fewer than 2 knots, and more than
// world::kMaxKnots.
base::Result<NltrackRecords> read_nltrack_records(std::string_view bytes, std::string_view name);

}  // namespace coaster::exchange
