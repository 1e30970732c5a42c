// Captures runs of changed slots and measures each vertex.
#include "gfx/curve_deviation.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace coaster::gfx {

CurveDeviation::Result CurveDeviation::update(GpuCurves& curves, curve::EvaluatedBy stage, const TrackCache& track,
                                              const sim::Derived& derived) {
  if (stage != stage_ || derived.steps != steps_) known_.clear(), able_ = true;
  stage_ = stage, steps_ = derived.steps;
  const std::span<const TrackCache::Placed> placed = track.placed();
  known_.resize(placed.size());
  const auto changed = [&](std::size_t k) { return placed[k].segment.valid() && known_[k].placed != placed[k]; };
  int room = std::max(kBudget / (steps_ + 1), 1);  // segments
  for (std::size_t k = 0; able_ && room > 0 && k < placed.size(); ++k) {
    if (!changed(k)) continue;
    CurveSlots run{track.control_buffer(), int(k), 1, steps_};
    while (run.count < room && k + 1 < placed.size() && changed(k + 1)) ++run.count, ++k;
    room -= run.count;
    able_ = measure(curves, run, derived, placed);
  }
  Result result;
  for (std::size_t k = 0; k < placed.size(); ++k) {
    if (!placed[k].segment.valid()) continue;
    if (changed(k)) ++result.pending;
    else result.metres = std::max(result.metres, known_[k].metres);
  }
  return result;
}

// Fills records_; those that the driver did not write keep a slot of -1.
bool CurveDeviation::read(GpuCurves& curves, const CurveSlots& slots) {
  records_.assign(GpuCurves::captured_count(stage_, slots), {glm::vec3(0), 0, -1});
  const auto bytes = GLsizeiptr(records_.size() * sizeof(GpuCurves::Captured));
  gl_->BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer_.id());
  gl_->BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, bytes, records_.data(), GL_DYNAMIC_READ);
  bool done = curves.capture(stage_, slots);
  if (done) {
    const void* const written = gl_->MapBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, bytes, GL_MAP_READ_BIT);
    done = written != nullptr;
    if (done) {
      std::memcpy(records_.data(), written, std::size_t(bytes));
      done = gl_->UnmapBuffer(GL_TRANSFORM_FEEDBACK_BUFFER) == GL_TRUE;
    }
  }
  gl_->BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
  return done;
}

bool CurveDeviation::measure(GpuCurves& curves, const CurveSlots& slots, const sim::Derived& derived,
                             std::span<const TrackCache::Placed> placed) {
  if (!read(curves, slots)) return false;
  std::vector<double> worst(std::size_t(slots.count), 0.0);  // squared
  std::vector<int> seen(std::size_t(slots.count), 0);
  for (const GpuCurves::Captured& record : records_) {
    const int slot = int(record.slot), number = int(record.number);
    if (slot < 0 || slot >= slots.count || number < 0 || number > slots.steps) return false;
    const curve::Cubic& cubic = derived.shape(placed[std::size_t(slots.first + slot)].segment).key.cubic;
    const glm::dvec3 off = glm::dvec3(record.place) - curve::point_long_double(cubic, double(number) / slots.steps);
    double& most = worst[std::size_t(slot)];
    most = std::max(most, glm::dot(off, off));
    ++seen[std::size_t(slot)];
  }
  if (std::count(seen.begin(), seen.end(), int(records_.size()) / slots.count) != slots.count) return false;
  for (int i = 0; i < slots.count; ++i) {
    const auto slot = std::size_t(slots.first + i);
    known_[slot] = {placed[slot], std::sqrt(worst[std::size_t(i)])};
  }
  return true;
}

}  // namespace coaster::gfx
