// The table of frame methods, which orient trains and the ride camera along the track, and the places where
// Frenet-Serret fails. To add a method, add an enumerator of world::FrameMethod and a row here. The track's mesh and
// the riders' forces always use the banking of the knots.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "sim/shape/derived_track.h"

namespace coaster::sim {

struct TrackFrame {
  curve::Frame frame;
  bool defined = true;  // false if the method is undefined and another frame is used
};

struct FrameMethodRow {
  std::string_view name;     // "rmf"
  std::string_view label;    // "Rotation-minimising"
  std::string_view formula;  // one line of help
  // Returns the frame at arc length s of segment `index` of derived.order.
  TrackFrame (*frame)(const DerivedTrack& derived, std::size_t index, double s);
};

// Rows in the order of world::FrameMethod:
// - knots: the knots' up; rotation-minimising within a segment, turned by the roll (roll.h). The default.
// - rmf: rotation-minimising from the first knot's up along the whole track (double reflection, Wang et al. 2008,
//   doi 10.1145/1330511.1330513); on a closed track the remaining twist is spread linearly in arc length. O(1): the
//   knots' frames turned back by their own twist (derived.twists).
// - frenet: Frenet-Serret; up is the principal normal. Paper erratum: where it is undefined, the last normal before is
//   carried on by the rotation-minimising frame (within kFrenetReach segments; else the knots' frame), and `defined`
//   is false.
// - world_up: up as near to +Y as possible; within 1e-6 rad of a vertical tangent a fixed horizontal axis is used and
//   `defined` is false.
std::span<const FrameMethodRow> frame_methods();
inline constexpr int kFrenetReach = 64;

TrackFrame track_frame(const DerivedTrack& derived, world::FrameMethod method, std::size_t index, double s);

// Returns the index of a segment in derived.order; tries the track distance `near` first (a cart's track_distance),
// then searches linearly. Returns order.size() if it is missing.
std::size_t index_of_segment(const DerivedTrack& derived, world::Entity segment, double near);

// Returns the twist in radians, (-pi, pi], about the tangent from the rotation-minimising frame carried once around a
// closed track to the first frame; 0 on an open track.
double loop_twist(const DerivedTrack& derived);

// A place where the Frenet-Serret normal fails.
struct FrenetBreak {
  // undefined: no curvature, or none that is bounded, from t to t_end; flip: the normal turns by more than 90 degrees
  // within 1/32 of the segment around an inflection or a place close to one (curve::binormal_turns), each of two near
  // ones by itself, or, at t = 0, over the joint before the segment.
  enum class Kind : std::uint8_t { undefined, flip } kind = Kind::flip;
  world::Entity segment;
  double t = 0, t_end = 0;  // equal for a flip
  double angle = 0;         // rad, rotation of the normal; 0 if undefined
};

// Returns the breaks inside one segment, by t: at most 32 spans and 3 flips. About 1 us.
std::vector<FrenetBreak> frenet_breaks(const SegmentShape& shape, world::Entity segment);
// Returns the breaks of the whole track in order, joints included. About 1 us per segment; for a picture use
// FrenetBreaks.
std::vector<FrenetBreak> frenet_breaks(const DerivedTrack& derived);

// Caches the breaks: update() checks only segments with a new shape_build, and nothing if there are none.
class FrenetBreaks {
 public:
  const std::vector<FrenetBreak>& update(const DerivedTrack& derived);

 private:
  struct Entry {
    std::uint64_t build = 0;
    std::vector<FrenetBreak> found;
  };
  world::Pool<Entry> entries_;
  std::vector<FrenetBreak> all_;
  std::uint64_t last_build_ = 0;
  std::vector<world::Entity> order_;
  bool closed_ = false;
};

}  // namespace coaster::sim

namespace coaster::world {
inline std::span<const sim::FrameMethodRow> rows_of(FrameMethod) { return sim::frame_methods(); }
}  // namespace coaster::world
