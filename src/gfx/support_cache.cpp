#include "gfx/support_cache.h"

namespace coaster::gfx {

SupportCache::Synced SupportCache::sync(const sim::Supports* supports, const sim::Clock& clock,
                                        const std::vector<std::uint8_t>* near) {
  Synced synced;
  ++stamp_;
  Stopwatch watch{clock};
  if (supports) {
    for (const world::Entity segment : supports->order()) {
      if (near != nullptr && (*near)[segment.index] == 0) continue;
      const sim::SegmentSupports& wanted = *supports->of(segment);
      if (segment.index >= slots_.size()) slots_.resize(segment.index + 1);
      Slot& slot = slots_[segment.index];
      slot.seen = stamp_;
      if (slot.segment == segment && slot.build == wanted.build) continue;
      if (!slot.segment.valid()) held_.push_back(segment.index);
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
  std::erase_if(held_, [&](std::uint32_t index) {
    Slot& slot = slots_[index];
    if (slot.seen == stamp_) return false;
    mesh_.release(slot.mesh);
    slot = {};
    return true;
  });
  synced.cpu_seconds = watch.seconds;
  return synced;
}

}  // namespace coaster::gfx
