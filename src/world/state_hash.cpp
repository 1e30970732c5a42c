// The hashes of document and motion. They depend on names, order and values, never on entity slots or data that a file
// does not hold. The order of the fields is fixed: scripts contain such hashes.
#include <algorithm>
#include <type_traits>
#include <vector>

#include "base/hash.h"
#include "world/element_rows.h"
#include "world/motion.h"
#include "world/sections.h"

namespace coaster::world {
namespace {

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
