// The cache of simulated rides, by a hash of their inputs.
#include <algorithm>

#include "base/hash.h"
#include "sim/ride/ghost.h"

namespace coaster::sim {

const RailTables& GhostMemo::tables(const world::Document& document, const Derived& derived) {
  tables_.update(derived, document.heartline);
  return tables_;
}

GhostMemo::Entry& GhostMemo::find(const world::Document& document, const Derived& derived, const GhostStart& start,
                                  const GhostLimits& limits) {
  tables(document, derived);
  equipment_ = equipment_spans(document, derived);
  base::Hasher hasher;
  hasher.add(tables_.serial()), hasher.add(limits.seconds), hasher.add(limits.stop_after_lap);
  world::add_all(hasher, start);
  world::add_all(hasher, document.resistance), hasher.add(document.rollback_fails);
  for (const EquipmentSpan& span : equipment_) {
    hasher.add(span.from), hasher.add(span.to);
    world::add_all(hasher, span.equipment);
  }
  const std::uint64_t key = hasher.digest();
  ++clock_;
  for (Entry& entry : entries_)
    if (entry.key == key) {
      entry.used = clock_;
      return entry;
    }
  if (entries_.size() < most_) entries_.emplace_back();  // used 0: the oldest
  Entry& entry = *std::min_element(entries_.begin(), entries_.end(),
                                   [](const Entry& a, const Entry& b) { return a.used < b.used; });
  ++simulations_;
  entry = {key, simulate(tables_, equipment_, document, start, limits, std::move(entry.ghost)), clock_, false, {}};
  entry.ghost.serial = simulations_;
  return entry;
}

const Ghost* GhostMemo::ride(const world::Document& document, const Derived& derived, world::Entity cart) {
  const world::Cart* const design = document.entities.find<world::Cart>(cart);
  if (!design || derived.order.empty()) return nullptr;
  return &find(document, derived, start_of(document, derived, *design), {}).ghost;
}

const Ghost& GhostMemo::from(const world::Document& document, const Derived& derived, const GhostStart& start) {
  return find(document, derived, start, {}).ghost;
}

const LapTable& GhostMemo::lap(const world::Document& document, const Derived& derived, const GhostStart& start) {
  Entry& entry = find(document, derived, start, {});
  if (!entry.has_lap) {
    const bool repeats = document.resistance == world::Resistance{} && equipment_.empty();
    entry.lap = repeats ? LapTable(entry.ghost) : LapTable();
    entry.has_lap = true;
  }
  return entry.lap;
}

void GhostMemo::keep(std::size_t rides) { most_ = std::clamp(rides, most_, kMostEntries * 16); }

}  // namespace coaster::sim
