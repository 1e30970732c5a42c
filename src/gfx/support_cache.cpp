#include "gfx/support_cache.h"

namespace coaster::gfx {

SupportCache::Synced SupportCache::sync(const sim::Supports* supports, const sim::Clock& clock) {
  Synced synced;
  ++stamp_;
  Stopwatch watch{clock};
  if (supports) {
    for (const world::Entity segment : supports->order()) {
      const sim::SegmentSupports& wanted = *supports->of(segment);
      if (segment.index >= slots_.size()) slots_.resize(segment.index + 1);
      Slot& slot = slots_[segment.index];
      slot.seen = stamp_;
      if (slot.segment == segment && slot.build == wanted.build) continue;
      slot.segment = segment, slot.build = wanted.build;
      if (wanted.bars.empty()) {
        if (slot.mesh != MeshPool::kNone) ++synced.uploads;
        mesh_.release(slot.mesh);
        continue;
      }
      watch.time([&] { sim::build_support_mesh(wanted, staged_); });
      mesh_.write(staged_, slot.mesh, watch);
      ++synced.uploads;
    }
  }
  for (Slot& slot : slots_) {
    if (slot.seen == stamp_ || !slot.segment.valid()) continue;
    mesh_.release(slot.mesh);
    slot = {};
  }
  synced.cpu_seconds = watch.seconds;
  return synced;
}

}  // namespace coaster::gfx
