#include "gfx/support_cache.h"

namespace coaster::gfx {

SupportCache::Synced SupportCache::sync(const sim::Supports* supports, const sim::Clock& clock) {
  Synced synced;
  ++stamp_;
  const double began = clock ? clock() : 0;
  double in_gl = 0;
  const auto gl_work = [&](const auto& work) {
    const double before = clock ? clock() : 0;
    work();
    if (clock) in_gl += clock() - before;
  };
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
        gl_work([&] { mesh_.release(slot.mesh); });
        continue;
      }
      sim::build_support_mesh(wanted, staged_);
      gl_work([&] { mesh_.fit(staged_, slot.mesh); });
      mesh_.settle(staged_, slot.mesh);
      gl_work([&] { mesh_.send(staged_, slot.mesh); });
      ++synced.uploads;
    }
  }
  for (Slot& slot : slots_) {
    if (slot.seen == stamp_ || !slot.segment.valid()) continue;
    gl_work([&] { mesh_.release(slot.mesh); });
    slot = {};
  }
  if (clock) synced.cpu_seconds = clock() - began - in_gl;
  return synced;
}

}  // namespace coaster::gfx
