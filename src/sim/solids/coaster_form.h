// What each kind of coaster is built of, as data: cross-section of the track, supports, and the space that trains need.
// Lengths are in metres; offsets are (left, up) from the middle of the rails.
#pragma once

#include <optional>
#include <span>

#include <glm/glm.hpp>

#include "sim/ground/earthworks.h"
#include "sim/solids/mesh.h"
#include "world/coaster_kind.h"

namespace coaster::sim {

inline constexpr double kGauge = 1.2;        // m between the rails' axes
inline constexpr double kRailRadius = 0.12;  // m; rails of wood have their running surface at this height

// A swept rectangle.
struct BeamForm {
  glm::dvec2 low, high;
  Material part;
  bool from_afar = true;
};
// A plate across the track with a convex outline, counter-clockwise when looking against the direction of travel;
// `half` its thickness along the track.
struct PlateForm {
  std::span<const glm::dvec2> outline;
  double half;
  Material part;
};
// An arm from a rail to the spine, wider at the spine; its ends are inside both.
struct ArmForm {
  double half_at_rail, half_at_spine;  // half its width
  glm::dvec2 spine;                    // its end there, of the left arm
};
// A tube about a line above the rails by `lift`.
struct ClearanceTube {
  double radius, lift;
};
// Returns the largest distance of the tube from the middle of the rails, m.
constexpr double reach_of(const ClearanceTube& tube) { return tube.radius + (tube.lift < 0 ? -tube.lift : tube.lift); }

// column: posts of steel that hold the spine, from beside it where riders hang below. bent: braced frames of timber.
enum class SupportForm : std::uint8_t { column, bent };

struct CoasterForm {
  std::span<const Tube> tubes;
  std::span<const BeamForm> beams;
  std::optional<ArmForm> arms;        // of each tie
  std::span<const PlateForm> plates;  // of each tie
  double tie_spacing;                 // between ties, approximately: a whole number per segment
  double half_tie;                    // half an arm's thickness along the track
  double hold, hold_radius;           // height and radius of the spine, which supports hold; radius 0: no collar
  SupportForm supports;
  double side;                    // 1: riders sit above the rails, -1: they hang below
  ClearanceTube envelope;         // what trains need, from the spine to the riders' heads and feet
  double wheels;                  // radius about a rail's axis that its wheels and bogies need, beside `riders`
  ClearanceTube riders;           // the same beside a train's own support
  ClearanceTube train, track;     // of conflicts: half a metre wider than riders; what track fills
  double platform;                // height of the floors of stations
  std::optional<double> walkway;  // height of the walkway beside lifts and brakes; none: ties carry one
  double eye, head;               // height of the riders' eyes, and of the tops of their heads
  double hitch;                   // height of the couplings
  double reach;                   // radius about the middle of the rails that contains the track
};
const CoasterForm& form_of(world::CoasterKind kind);

// Returns the room that earth leaves to trains and track of a form.
TrackRoom track_room(const CoasterForm& form);

}  // namespace coaster::sim
