// The document: everything that is saved and can be undone. A value: copy it for a snapshot, compare it with ==.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "curve/cubic.h"
#include "world/coaster_kind.h"
#include "world/components.h"
#include "world/park.h"

namespace coaster::world {

// The order of travel. Segment i leads from knot i to knot i+1. A closed track (at least 2 knots) has as many segments
// as knots, the last one leading back to the first knot; an open one has one fewer (none for 0 or 1 knots).
struct Track {
  std::vector<Entity> knots, segments;
  bool closed = false;
  friend bool operator==(const Track&, const Track&) = default;
};

// The meaning of the cubics; in both cases they are the line that trains move along.
enum class TrackCurve : std::uint8_t { rails, heartline };
inline constexpr base::NameRow kTrackCurves[] = {
    {"rails", "Rails", "The curve is the middle of the rails. The riders' hearts move above it."},
    {"heartline", "Heartline", "The curve is the path of the riders' hearts. The rails hang below it."}};
constexpr std::span<const base::NameRow> rows_of(TrackCurve) { return kTrackCurves; }

struct Document {
  Entities entities;
  Track track;
  std::string name = "Untitled";  // UTF-8
  double start_speed = 1.0;       // m/s along the track, may be negative; |start_speed| <= kMaxSpeed
  double datum = 0.0;             // m, height of zero potential energy
  Losses resistance;              // none by default: the paper's frictionless circuit
  double heartline = 1.1;         // m above the rails, height of the riders' hearts, for which forces are given
  bool rollback_fails = true;     // true: a rollback ends the ride
  TrackCurve curve = TrackCurve::rails;
  CoasterKind kind = CoasterKind::steel;
  Paint paint;           // of the track and its trains; its sections may have their own
  Park park;             // the land around it
  UnknownMembers extra;  // unknown top-level members of the file
  std::array<std::uint32_t, base::count_of<EntityKind>()> last_number{};  // by EntityKind: the last number assigned
  // The fields that determine how the track is ridden.
  static constexpr void fields(auto visit) {
    visit(Field{"start_speed", -kMaxSpeed, kMaxSpeed}, &Document::start_speed);
    visit(Field{"datum", -kMaxCoordinate, kMaxCoordinate}, &Document::datum);
    visit(Field{}, &Document::resistance);
    visit(Field{"heartline", -kMaxHeartline, kMaxHeartline, FilePresence::unusual, 2}, &Document::heartline);
    visit(Field{"rollback_fails", 0, 0, FilePresence::unusual, 3}, &Document::rollback_fails);
    visit(Field{"curve", 0, 0, FilePresence::unusual, 4}, &Document::curve);
    visit(Field{"kind", 0, 0, FilePresence::unusual, 5}, &Document::kind);
    visit(Field{"", 0, 0, FilePresence::unusual, 6}, &Document::paint);
  }
  friend bool operator==(const Document&, const Document&) = default;
};

// Return the height of the rails and of the riders' hearts above the curve, m along `up`. Drawing and contact use the
// first, forces on riders the second.
inline double rails_height(const Document& document) {
  return document.curve == TrackCurve::heartline ? 0.0 - document.heartline : 0.0;
}
inline double riders_height(const Document& document) { return rails_height(document) + document.heartline; }

// Returns the entity of that name, or kNone. Linear in the number of entities (a microsecond per thousand).
Entity find(const Document& document, EntityName name);
EntityName name_of(const Document& document, Entity entity);  // the entity must be alive
// Returns "k3" for a living entity, "-" for none.
std::string label_of(const Document& document, Entity entity);

// Returns the cart with the lowest number, or kNone.
Entity first_cart(const Document& document);

const Knot& knot(const Document& document, Entity e);
const Segment& segment(const Document& document, Entity e);

// Copies the fittings of one segment to another, which may be in the same document.
void copy_fittings(const Document& original, Entity from, Document& document, Entity to);

// Returns the control points of a segment: p0 and p3 are exactly the knots' positions, p1 and p2 are on their tangents
// at the handle lengths.
curve::Cubic cubic_of(const Document& document, Entity segment);
glm::vec3 in_handle(const Knot& knot);   // position - tangent * in_length
glm::vec3 out_handle(const Knot& knot);  // position + tangent * out_length
float as_handle(double length);          // a handle's length: in float, within kMinHandle..kMaxHandle

// The segments that end and start at a knot; kNone at the ends of an open track. Linear in the track's length.
struct KnotSegments {
  Entity before, after;
};
KnotSegments neighbours(const Document& document, Entity knot);
// Returns the index in track.knots or track.segments, or nothing.
std::optional<std::size_t> index_of(const std::vector<Entity>& order, Entity e);

// Returns the sum of arc lengths by adaptive Gauss-Legendre, m.
double exact_length(const Document& document);

// Returns the hash of everything except entity slots: equal for a document and its saved and reloaded copy, and for
// documents with the same names and values in track order. Extras count. Fixed by tests: changing it changes scripts.
std::uint64_t hash(const Document& document);

// Returns nothing if every invariant of this file and components.h holds, else one line that names the broken one. For
// tests and after loading.
std::optional<std::string> broken_invariant(const Document& document);

// Returns what the track is called where people choose among files: its name; the name of its file, without the
// extension, where nobody has named it. "" or the default name if it has no file either.
std::string track_name(const std::string& name, const std::filesystem::path& file);

}  // namespace coaster::world
