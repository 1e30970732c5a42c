// Reads a document: names, control points, neighbours, length. topology.cpp changes it.
#include "world/document.h"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/hash.h"
#include "base/text.h"
#include "curve/arc_length.h"
#include "world/element_rows.h"
#include "world/motion.h"
#include "world/sections.h"

namespace coaster::world {
namespace {

using Broken = std::optional<std::string>;

// --- Every invariant of document.h, components.h and registry.h: for tests and after loading

// Twice the tolerance of orthonormalise(): rounding to float afterwards must not break the invariant.
constexpr double kUnitTolerance = 2e-6;

bool within(double value, double low, double high) { return value >= low && value <= high; }  // false for NaN

Broken broken_knot(const Document& document, Entity e) {
  const Knot& k = knot(document, e);
  const auto broken = [&](const char* what) { return fmt::format("{}: {}", label_of(document, e), what); };
  for (int axis = 0; axis < 3; ++axis)
    if (!within(k.position[axis], -kMaxCoordinate, kMaxCoordinate)) return broken("position beyond the limit");
  const glm::dvec3 tangent(k.tangent), up(k.up);
  if (!within(glm::dot(tangent, tangent), 1 - kUnitTolerance, 1 + kUnitTolerance)) return broken("tangent is not unit");
  if (!within(glm::dot(up, up), 1 - kUnitTolerance, 1 + kUnitTolerance)) return broken("up is not unit");
  if (!within(glm::dot(tangent, up), -kUnitTolerance, kUnitTolerance)) return broken("up is not perpendicular");
  if (!within(k.in_length, kMinHandle, kMaxHandle) || !within(k.out_length, kMinHandle, kMaxHandle))
    return broken("handle length beyond the limits");
  if (!within(k.spin, -kMaxSpin, kMaxSpin)) return broken("spin beyond the limit");
  if (k.joint == JointKind::smooth && k.in_length != k.out_length) return broken("smooth joint with unequal lengths");
  return {};
}

Broken broken_names(const Document& document) {
  const auto& names = document.entities.pool<EntityName>();
  if (names.size() != document.entities.size()) return "an entity without a name";
  std::vector<EntityName> sorted = names.items();
  std::ranges::sort(sorted);
  if (const auto twice = std::ranges::adjacent_find(sorted); twice != sorted.end())
    return to_text(*twice) + ": the name is taken twice";
  for (std::size_t i = 0; i < names.size(); ++i) {
    const EntityName name = names.items()[i];
    const Entity e = names.entities()[i];
    if (name.number < 1 || name.number > document.last_number[static_cast<std::size_t>(name.kind)])
      return to_text(name) + ": number beyond the last one given";
    if (!document.entities.alive(e)) return to_text(name) + ": names a dead entity";
    const bool knot_here = document.entities.find<Knot>(e), segment_here = document.entities.find<Segment>(e),
               cart_here = document.entities.find<Train>(e), section_here = document.entities.find<Section>(e);
    if (knot_here != (name.kind == EntityKind::knot) || segment_here != (name.kind == EntityKind::segment) ||
        cart_here != (name.kind == EntityKind::cart) || section_here != (name.kind == EntityKind::section))
      return to_text(name) + ": components of another kind";
  }
  return {};
}

Broken broken_chain(const Document& document) {
  const Track& track = document.track;
  const std::size_t count = track.knots.size();
  if (count > kMaxKnots) return "more knots than the limit";
  if (track.closed && count < 2) return "a closed track has at least 2 knots";
  const std::size_t expected = track.closed ? count : count > 0 ? count - 1 : 0;
  if (track.segments.size() != expected) return "the number of segments does not fit the knots";
  if (document.entities.pool<Knot>().size() != count) return "a knot is not on the track, or twice";
  if (document.entities.pool<Segment>().size() != expected) return "a segment is not on the track, or twice";
  std::vector<char> seen;  // by slot
  const auto first_seen = [&](Entity e) {
    if (e.index >= seen.size()) seen.resize(e.index + 1);
    return std::exchange(seen[e.index], 1) == 0;
  };
  for (const Entity e : track.knots)
    if (!document.entities.find<Knot>(e) || !first_seen(e)) return "the order of knots is broken";
  for (std::size_t i = 0; i < expected; ++i) {
    const Entity e = track.segments[i];
    if (!document.entities.find<Segment>(e) || !first_seen(e)) return "the order of segments is broken";
    const Segment& s = segment(document, e);
    if (s.from != track.knots[i] || s.to != track.knots[(i + 1) % count])
      return label_of(document, e) + ": does not lead from its knot to the next";
    if (s.turns < -kMaxTurns || s.turns > kMaxTurns) return label_of(document, e) + ": turns beyond the limit";
  }
  return {};
}

bool within_limits(const ClosingPlan& way) {
  bool within = true;
  ClosingPlan::fields([&](const Field& field, auto member) {
    const auto value = way.*member;
    if constexpr (std::is_same_v<decltype(value), const double>)
      within = within && value >= field.low && value <= field.high;
  });
  return within;
}

bool sound(const Section& section) {
  if (section.title.size() > kMaxNameBytes || !base::is_printable_utf8(section.title)) return false;
  if (!base::has_row(section.kind)) return false;
  return (section.kind == SectionKind::element ? within_limits(section.element) && !is_of_forces(section.element.kind)
                                               : section.element == Element{}) &&
         (section.kind == SectionKind::complete ? within_limits(section.closing) : section.closing == ClosingPlan{}) &&
         (section.kind == SectionKind::force ? !broken(section.force) : section.force == ForceProgram{});
}

// Each segment belongs to a section, and the segments of a section are neighbours.
Broken broken_sections(const Document& document) {
  const std::vector<SectionRun> runs = sections_of(document);
  for (const SectionRun& run : runs) {
    const Section* const section = document.entities.find<Section>(run.section);
    if (!section) return label_of(document, document.track.segments[run.first]) + ": in no section";
    if (!sound(*section)) return label_of(document, run.section) + ": title or parameters beyond the limits";
  }
  std::vector<Entity> seen;
  for (const SectionRun& run : runs) seen.push_back(run.section);
  std::ranges::sort(seen);
  if (const auto twice = std::ranges::adjacent_find(seen); twice != seen.end())
    return label_of(document, *twice) + ": its segments are not neighbours";
  if (document.entities.pool<Section>().size() != runs.size()) return "a section without segments";
  return {};
}

Broken broken_park(const Park& park) {
  if (park.plain()) return park == Park() ? Broken() : "a park without a land";
  if (!within(park.relief, 0.0, kMaxRelief) || !within(park.woods, 0.0, 1.0) ||
      !within(park.water, kLowestWater, kHighestWater))
    return "park beyond the limits";
  constexpr int kHighest = static_cast<int>(kHighestGround / kHeightStep);
  for (const auto& [place, tile] : park.tiles.map()) {
    if (!in_square(place) || tile->empty()) return "a tile of the park outside the square, or one that holds nothing";
    for (const std::int16_t height : tile->heights)
      if (height != GroundTile::kSeeded && (height < -kHighest || height > kHighest))
        return "height of the park beyond the limit";
  }
  return {};
}

// --- The hashes of document and motion. They depend on names, order and values, never on entity slots or data that a
// file does not hold. The order of the fields is fixed: scripts contain such hashes

// Returns the number of an entity; 0, which no name has, if it is dead.
std::uint32_t number_of(const Document& document, Entity e) {
  const EntityName* const name = document.entities.find<EntityName>(e);
  return name ? name->number : 0;
}

void add_extra(base::Hasher& hasher, const Document& document, Entity e) {
  const UnknownMembers* const extra = document.entities.find<UnknownMembers>(e);
  hasher.add(extra ? std::string_view(extra->json) : std::string_view());
}

std::vector<Entity> by_number(const Document& document, std::vector<Entity> entities) {
  std::sort(entities.begin(), entities.end(), [&](Entity a, Entity b) {
    const std::uint32_t x = number_of(document, a), y = number_of(document, b);
    return x != y ? x < y : a < b;
  });
  return entities;
}

template <class T>
void add_component(base::Hasher& hasher, const Document& document, const T& component) {
  add_fields(component, [&](const auto& value) {
    using Value = std::remove_cvref_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, Entity>) hasher.add(number_of(document, value));
    else if constexpr (std::is_same_v<Value, Colour>) hasher.add(value.rgb);
    else if constexpr (HasFields<Value>) add_component(hasher, document, value);
    else hasher.add(value);
  });
}

// Missing fittings add nothing, so that the hash of a plain segment is that of the first version of the format.
void add_fittings(base::Hasher& hasher, const Document& document, Entity segment) {
  Fittings::for_each([&]<class T>() {
    if (const T* const fitting = document.entities.find<T>(segment)) add_component(hasher, document, *fitting);
  });
}

// True if there are no explicit sections: all segments are one free section without a title. It adds nothing, so that
// tracks keep the hash from before sections existed.
bool undivided(const Document& document, const std::vector<SectionRun>& runs) {
  if (runs.empty()) return true;
  const Entity e = runs.front().section;
  const Section* const section = document.entities.find<Section>(e);
  return runs.size() == 1 && (!section || *section == Section{}) && !document.entities.find<UnknownMembers>(e);
}

// A document without a park has the hash of versions before parks.
void add_park(base::Hasher& hasher, const Park& park) {
  if (park == Park()) return;
  hasher.add(std::string_view(base::row_of(park.land).in_file));
  hasher.add(park.seed);
  for (const double value : {park.relief, park.woods, park.water}) hasher.add(value);
  hasher.add(park.tiles.map().size());
  for (const auto& [place, tile] : park.tiles.map()) {
    hasher.add(place.x), hasher.add(place.z);
    for (const std::int16_t height : tile->heights) hasher.add(height);
    hasher.bytes(tile->woods.data(), tile->woods.size());
  }
}

void add_force(base::Hasher& hasher, const Document& document, const ForceProgram& force) {
  add_component(hasher, document, force);
  for (const std::vector<ForceKey>& keys : force.channels) {
    hasher.add(keys.size());
    for (const ForceKey& key : keys)
      for (const double value : {key.at, key.value, key.slope, key.before, key.after}) hasher.add(value);
  }
}

void add_sections(base::Hasher& hasher, const Document& document) {
  const std::vector<SectionRun> runs = sections_of(document);
  if (undivided(document, runs)) return;
  hasher.add(runs.size());
  for (const SectionRun& run : runs) {
    const Section& s = section(document, run.section);
    hasher.add(number_of(document, run.section));
    hasher.add(run.count);
    add_component(hasher, document, s);
    hasher.add(kind_name(s));
    if (s.kind == SectionKind::element) {
      hasher.add(s.element.right);
      for (std::size_t i = 0; i < base::row_of(s.element.kind).parameters.size(); ++i) hasher.add(s.element.values[i]);
    }
    if (s.kind == SectionKind::complete) add_component(hasher, document, s.closing);
    if (s.kind == SectionKind::force) add_force(hasher, document, s.force);
    add_extra(hasher, document, run.section);
  }
}

}  // namespace

Entity first_cart(const Document& document) {
  Entity first = kNone;
  EntityName least;
  for (const Entity cart : document.entities.pool<Train>().entities()) {
    const EntityName name = name_of(document, cart);
    if (!first.valid() || name < least) first = cart, least = name;
    if (least.number == 1) break;  // there is no lower one
  }
  return first;
}

Entity find(const Document& document, EntityName name) {
  const Pool<EntityName>& names = document.entities.pool<EntityName>();
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names.items()[i] == name) return names.entities()[i];
  return kNone;
}

EntityName name_of(const Document& document, Entity entity) { return document.entities.get<EntityName>(entity); }

std::string label_of(const Document& document, Entity entity) {
  const EntityName* const name = document.entities.find<EntityName>(entity);
  return name ? to_text(*name) : "-";
}

const Knot& knot(const Document& document, Entity e) { return document.entities.get<Knot>(e); }
const Segment& segment(const Document& document, Entity e) { return document.entities.get<Segment>(e); }

curve::Cubic cubic_of(const Document& document, Entity segment_entity) {
  const Segment& s = segment(document, segment_entity);
  const Knot &from = knot(document, s.from), &to = knot(document, s.to);
  return {from.position, out_handle(from), in_handle(to), to.position};
}

glm::vec3 in_handle(const Knot& k) { return k.position - k.tangent * k.in_length; }
glm::vec3 out_handle(const Knot& k) { return k.position + k.tangent * k.out_length; }
float as_handle(double length) { return std::clamp(static_cast<float>(length), kMinHandle, kMaxHandle); }

KnotSegments neighbours(const Document& document, Entity knot_entity) {
  const Track& track = document.track;
  const auto index = index_of(track.knots, knot_entity);
  COASTER_CHECK(index, "the knot is on the track");
  KnotSegments result;
  if (*index > 0) result.before = track.segments[*index - 1];
  else if (track.closed) result.before = track.segments.back();
  if (*index < track.segments.size()) result.after = track.segments[*index];
  return result;
}

std::optional<std::size_t> index_of(const std::vector<Entity>& order, Entity e) {
  for (std::size_t i = 0; i < order.size(); ++i)
    if (order[i] == e) return i;
  return std::nullopt;
}

double exact_length(const Document& document) {
  double sum = 0;
  for (const Entity s : document.track.segments) sum += curve::arc_length(cubic_of(document, s));
  return sum;
}

void copy_fittings(const Document& original, Entity from, Document& document, Entity to) {
  Fittings::for_each([&]<class T>() {
    if (const T* const fitting = original.entities.find<T>(from)) document.entities.put(to, T(*fitting));
  });
}

std::string track_name(const std::string& name, const std::filesystem::path& file) {
  static const std::string kUnnamed = Document{}.name;
  return !file.empty() && (name.empty() || name == kUnnamed) ? file.stem().string() : name;
}

std::optional<std::string> broken_invariant(const Document& document) {
  if (!within(document.start_speed, -kMaxSpeed, kMaxSpeed)) return "start speed beyond the limit";
  if (!within(document.datum, -double{kMaxCoordinate}, double{kMaxCoordinate})) return "datum beyond the limit";
  if (Broken broken = broken_park(document.park)) return broken;
  if (Broken broken = broken_names(document)) return broken;
  if (Broken broken = broken_chain(document)) return broken;
  if (Broken broken = broken_sections(document)) return broken;
  for (const Entity e : document.track.knots)
    if (Broken broken = broken_knot(document, e)) return broken;
  const auto& carts = document.entities.pool<Train>();
  for (std::size_t i = 0; i < carts.size(); ++i) {
    const Train& cart = carts.items()[i];
    if (!document.entities.find<Segment>(cart.segment))
      return label_of(document, carts.entities()[i]) + ": on no segment";
    if (!(cart.fraction >= 0 && cart.fraction < 1))
      return label_of(document, carts.entities()[i]) + ": fraction not in [0,1)";
  }
  return {};
}

std::uint64_t hash(const Document& document) {
  base::Hasher hasher;
  hasher.add(std::string_view(document.name));
  add_component(hasher, document, document);
  add_park(hasher, document.park);
  hasher.add(document.track.closed);
  hasher.add(std::string_view(document.extra.json));
  hasher.add(document.track.knots.size());
  for (const Entity e : document.track.knots) {
    hasher.add(number_of(document, e));
    add_component(hasher, document, knot(document, e));
    add_extra(hasher, document, e);
  }
  hasher.add(document.track.segments.size());  // from and to follow from the order
  for (const Entity e : document.track.segments) {
    hasher.add(number_of(document, e));
    add_component(hasher, document, segment(document, e));
    add_fittings(hasher, document, e);
    add_extra(hasher, document, e);
  }
  add_sections(hasher, document);
  const auto& carts = document.entities.pool<Train>();
  hasher.add(carts.size());
  for (const Entity e : by_number(document, carts.entities())) {
    hasher.add(number_of(document, e));
    add_component(hasher, document, carts.get(e));
    add_extra(hasher, document, e);
  }
  return hasher.digest();
}

std::uint64_t hash(const Document& document, const Motion& motion) {
  base::Hasher hasher;
  const auto add = [&](const auto&... values) { (hasher.add(values), ...); };
  add(motion.state, motion.failure.kind, motion.carts.size());
  for (const Entity e : by_number(document, motion.carts.entities())) {
    const TrainMotion& cart = motion.carts.get(e);
    add(number_of(document, e), number_of(document, cart.segment), cart.s, cart.speed, cart.segment_length);
    add(cart.track_distance, cart.travelled, cart.laps, cart.reference_energy, cart.peak_kinetic, cart.work);
    add(cart.furthest, cart.carry, cart.still, cart.dwell, cart.braking);
    add(cart.timetable.valid, cart.timetable.front, cart.timetable.speed, cart.timetable.tick);
    if (cart.timetable.phase != 0) add(cart.timetable.phase);
  }
  return hasher.digest();
}

}  // namespace coaster::world
