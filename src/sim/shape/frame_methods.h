// The table of frame methods: how carts and the ride camera are turned along the track; and where Frenet-Serret fails.
// Adding a method: an enumerator of world::FrameMethod and a row here. The track's mesh and what riders feel stay
// banked by the knots.
//
// Commands and queries over this file (edit/commands/commands.h, query/rows_joints.cpp):
//   frames_by knots|rmf|frenet|world_up            command and query
//   loop_twist                                     deg, below  (the query `twist @segment` is one segment's spread
//   twist) curvature, torsion (1/m), frenet (on, off)     at the selected place: a segment's place, a knot, a cart
//   frenet_flips                                   number of frenet_breaks()
//   joint_angle @k (deg), speed_ratio @k, curvature_before @k, curvature_after @k (vectors, 1/m), curvature_jump @k
//   (1/m), second_jump @k (m), g_step @k (g), g_step_max (g): joints; speed is the present one of the first cart
//   erratum NAME, erratum_wrong NAME               sim/study/live_errata.h, of the selected segment, else of the first
//   make_g2 @k, make_all_g2                        commands
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "sim/shape/derived.h"

namespace coaster::sim {

struct TrackFrame {
  curve::Frame frame;
  bool defined = true;  // false where the method says nothing and something else stands in
};

struct FrameMethodRow {
  std::string_view name;     // "rmf"
  std::string_view label;    // "Rotation-minimising"
  std::string_view formula;  // a line of help
  // The frame at arc length s of segment `index` of derived.order.
  TrackFrame (*frame)(const Derived& derived, std::size_t index, double s);
};

// Rows in the order of world::FrameMethod:
// knots     the knots' up: rotation-minimising within a segment, the rest of the twist spread linearly. The default.
// rmf       rotation-minimising from the first knot's up along the whole track (double reflection, Wang et al. 2008,
// doi
//           10.1145/1330511.1330513); on a closed track the twist left over is spread linearly in arc length. O(1): the
//           knots' frames turned back by the twist that they hold (derived.twists).
// frenet    Frenet-Serret: up is the principal normal. Paper erratum: where it is undefined the last normal before
// stands in, carried by
//           the rotation-minimising frame (within kFrenetReach segments; else the knots' frame), and `defined` is
//           false.
// world_up  up as near to +Y as can be; within 1e-6 rad of a vertical tangent a fixed horizontal axis stands in and
// `defined` is false.
std::span<const FrameMethodRow> frame_methods();
inline constexpr int kFrenetReach = 64;

TrackFrame track_frame(const Derived& derived, world::FrameMethod method, std::size_t index, double s);

// The place of a segment in derived.order, looked for at track distance `near` first (a cart's track_distance), else
// linearly. order.size() when it is not there.
std::size_t index_of_segment(const Derived& derived, world::Entity segment, double near);

// The twist in radians, (-pi, pi], by which the rotation-minimising frame carried once around a closed track must be
// turned about the tangent to meet the first one; 0 on an open track.
double loop_twist(const Derived& derived);

// A place where the Frenet-Serret normal is no help.
struct FrenetBreak {
  // undefined: no curvature from t to t_end; flip: the normal turns by more than 90 degrees within 1/32 of the segment
  // (an inflection or close to one) or, at t = 0, over the joint before the segment.
  enum class Kind : std::uint8_t { undefined, flip } kind = Kind::flip;
  world::Entity segment;
  double t = 0, t_end = 0;  // equal for a flip
  double angle = 0;         // rad, by which the normal turns; 0 where undefined
};

// Those inside one segment, by t: at most 32 spans and 3 flips. About 1 us.
std::vector<FrenetBreak> frenet_breaks(const SegmentShape& shape, world::Entity segment);
// Those of the whole track in order, joints included. About 1 us a segment: for a picture use FrenetBreaks.
std::vector<FrenetBreak> frenet_breaks(const Derived& derived);

// The same, kept: update() looks at the segments whose shape_build is new alone, and at nothing when none is.
class FrenetBreaks {
 public:
  const std::vector<FrenetBreak>& update(const Derived& derived);

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
