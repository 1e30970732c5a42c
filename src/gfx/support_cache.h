// Supports on the GPU: one solid per segment that has any, rewritten only if it changed. Separate from the track's
// buffers, so that these are written only for moved track.
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
    double cpu_seconds = 0;  // time to prepare them, outside GL; 0 without a clock
  };
  // null: draws none. If nothing changed, costs one comparison for each segment that may have supports.
  // `near`: by the index of a segment's entity, whether its supports are held; null: all are.
  Synced sync(const sim::Supports* supports, const sim::Clock& clock, const std::vector<std::uint8_t>* near = nullptr);

  MeshPool& mesh() { return mesh_; }
  const MeshPool& mesh() const { return mesh_; }

 private:
  struct Slot {
    world::Entity segment;
    std::uint64_t build = 0, seen = 0;
    MeshPool::Id mesh = MeshPool::kNone;
  };
  MeshPool mesh_;
  std::vector<Slot> slots_;          // by the entity's index
  std::vector<std::uint32_t> held_;  // those with a segment
  std::uint64_t stamp_ = 0;          // of the current sync
  sim::Mesh staged_;                 // kept for its capacity
};

}  // namespace coaster::gfx
