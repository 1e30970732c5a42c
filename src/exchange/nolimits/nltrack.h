// Import of NoLimits 1 track files (.nltrack): Bézier knots with two handles and a roll, the same kind of curve as the
// document's.
#pragma once

#include <string_view>

#include "exchange/own/track_file.h"

namespace coaster::exchange {

// The layout, big-endian; everything else is skipped:
//   "BEZR" u32 size of the rest, 16 bytes, u32 count, then count records of 60 bytes: point, in-handle, out-handle
//          (absolute, 9 x f32, m), roll (f32, rad from the horizon), 3 flag bytes, 17 bytes of padding
//   "SEGM" u32 size of the rest, u32 count, then u8 closed (0xFF or 0)
// Positions are kept bit for bit. A knot here is a position, a unit tangent and two lengths, so handles are rounded:
// each stays within 2e-7 of its length and an ulp of its coordinates if the file's handles are collinear. If they are
// not, the tangent is along out-handle minus in-handle, and a warning gives the largest turn. Handles shorter than
// world::kMinHandle are lengthened to it, with a warning; a handle that no segment uses (at the ends of an open track)
// may have zero length. Rolls that continue over whole turns from knot to knot become `turns`. Roll in the file is
// positive to the left (in the document to the right, hence the change of sign); the three flags are ignored. All
// joints
// are aligned (G1). The document is named after the file. Errors are Code::bad_file, "NAME: error: at byte N: expected
// ..., found ...".
base::Result<LoadedTrack> parse_nltrack(std::string_view bytes, std::string_view name);

}  // namespace coaster::exchange
