// The document: everything that is saved and undone. A value: copy it for a snapshot, compare it with ==.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "curve/cubic.h"
#include "world/components.h"
#include "world/registry.h"

namespace coaster::world {

// Order of travel. Segment i leads from knot i to knot i+1; a closed track (at least 2 knots) has as many
// segments as knots, the last one leading back to the first knot; an open one has one fewer (none for 0 or 1 knots).
struct Track {
  std::vector<Entity> knots, segments;
  bool closed = false;
  friend bool operator==(const Track&, const Track&) = default;
};

struct Document {
  Registry<Name, Knot, Segment, Cart, Equipment, Extra> entities;  // equipment stands on segments
  Track track;
  std::string name = "Untitled";  // UTF-8
  double start_speed = 1.0;       // m/s along the track, may be negative; |start_speed| <= kMaxSpeed
  double datum = 0.0;             // m, the height whose potential energy is 0
  Resistance resistance;          // none by default: the frictionless circuit of the paper
  double heartline = 1.1;         // m over the rails, where the riders' hearts are and what forces are told for
  bool rollback_fails = true;     // a train that rolls back ends the ride; else it rolls on
  Extra extra;                    // unknown top-level members of the file
  std::array<std::uint32_t, 3> last_number{};  // by Kind: the last name given
  friend bool operator==(const Document&, const Document&) = default;
};

// The entity of that name, or kNone. Linear in the number of entities (a microsecond per thousand).
Entity find(const Document& document, Name name);
Name name_of(const Document& document, Entity entity);  // the entity must be alive
// "k3" for a living entity, "-" for none.
std::string label_of(const Document& document, Entity entity);

// The cart with the lowest number, or kNone.
Entity first_cart(const Document& document);

const Knot& knot(const Document& document, Entity e);
const Segment& segment(const Document& document, Entity e);

// Control points of a segment: p0 and p3 are exactly the knots' positions, p1 and p2 lie on their tangents at the
// handle lengths.
curve::Cubic cubic_of(const Document& document, Entity segment);
glm::vec3 in_handle(const Knot& knot);   // position - tangent * in_length
glm::vec3 out_handle(const Knot& knot);  // position + tangent * out_length

// Segments that end and start at a knot; kNone at the ends of an open track. Linear in the track's length.
struct Neighbours {
  Entity before, after;
};
Neighbours neighbours(const Document& document, Entity knot);
// Place in track.knots or track.segments, or nothing.
std::optional<std::size_t> index_of(const std::vector<Entity>& order, Entity e);

// The sum of arc lengths by adaptive Gauss-Legendre, m.
double exact_length(const Document& document);

// Hash of everything but the slots that entities happen to have: equal for a document and its saved-and-loaded copy,
// and for documents that read the same by names, in track order. Extras count. Fixed by tests: changing it changes
// scripts.
std::uint64_t hash(const Document& document);

// Nothing when every promise of this file and components.h holds, else one line that says which is broken. For tests
// and after loading.
std::optional<std::string> broken_invariant(const Document& document);

}  // namespace coaster::world
