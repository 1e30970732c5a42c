// Supports on the GPU: a solid for each segment that has any, written again only where they were found to be others.
// Apart from the track's own buffers, so that these are written for what moved alone.
#pragma once

#include <cstdint>
#include <vector>

#include "gfx/mesh_pool.h"
#include "sim/solids/supports.h"

namespace coaster::gfx {

class SupportCache {
 public:
  explicit SupportCache(const Gl& gl) : mesh_(gl) {}

  struct Synced {
    int uploads = 0;         // segments whose supports were written
    double cpu_seconds = 0;  // on preparing them, outside GL; 0 without a clock
  };
  // null: none are drawn. Cost while nothing changes: a comparison for each segment.
  Synced sync(const sim::Supports* supports, const sim::Clock& clock);

  MeshPool& mesh() { return mesh_; }
  const MeshPool& mesh() const { return mesh_; }

 private:
  struct Slot {
    world::Entity segment;
    std::uint64_t build = 0, seen = 0;
    MeshPool::Id mesh = MeshPool::kNone;
  };
  MeshPool mesh_;
  std::vector<Slot> slots_;  // by the entity's index
  std::uint64_t stamp_ = 0;  // of the sync in progress
  sim::Mesh staged_;         // kept for its capacity
};

}  // namespace coaster::gfx
