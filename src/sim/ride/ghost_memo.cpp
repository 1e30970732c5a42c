// The cache of simulated rides, by their inputs.
#include <algorithm>

#include "sim/ride/ghost.h"

namespace coaster::sim {

const RailTables& GhostMemo::tables(const world::Document& document, const Derived& derived) {
  tables_.update(derived, world::riders_height(document));
  return tables_;
}

GhostMemo::Entry& GhostMemo::find(const world::Document& document, const Derived& derived, const GhostStart& start) {
  tables(document, derived);
  Key key{tables_.serial(), start, document.resistance, document.rollback_fails, equipment_spans(document, derived)};
  ++clock_;
  for (Entry& entry : entries_)
    if (entry.key == key) {
      entry.used = clock_;
      return entry;
    }
  if (entries_.size() < most_) entries_.emplace_back();  // used 0: the oldest
  Entry& entry = *std::min_element(entries_.begin(), entries_.end(),
                                   [](const Entry& a, const Entry& b) { return a.used < b.used; });
  Ghost ghost = simulate(tables_, key.equipment, document, start, {}, std::move(entry.ghost));
  ghost.serial = ++simulations_;
  entry = {std::move(key), std::move(ghost), clock_, false, {}};
  return entry;
}

const Ghost* GhostMemo::ride(const world::Document& document, const Derived& derived, world::Entity cart) {
  const world::Cart* const design = document.entities.find<world::Cart>(cart);
  if (!design || derived.order.empty()) return nullptr;
  return &find(document, derived, start_of(document, derived, *design)).ghost;
}

const Ghost& GhostMemo::from(const world::Document& document, const Derived& derived, const GhostStart& start) {
  return find(document, derived, start).ghost;
}

const LapTable& GhostMemo::lap(const world::Document& document, const Derived& derived, const GhostStart& start) {
  Entry& entry = find(document, derived, start);
  if (!entry.has_lap) {
    const bool repeats = entry.key.resistance == world::Resistance{} && entry.key.equipment.empty();
    entry.lap = repeats ? LapTable(entry.ghost) : LapTable();
    entry.has_lap = true;
  }
  return entry.lap;
}

void GhostMemo::keep(std::size_t rides) { most_ = std::clamp(rides, most_, kMostEntries * 16); }

}  // namespace coaster::sim
