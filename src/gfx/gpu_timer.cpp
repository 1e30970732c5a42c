// A ring of timer queries.
#include "gfx/gpu_timer.h"

namespace coaster::gfx {

GpuTimer::GpuTimer(const Gl& gl) : gl_(&gl) {
  able_ = gl.GenQueries && gl.DeleteQueries && gl.BeginQuery && gl.EndQuery && gl.GetQueryObjectuiv &&
          gl.GetQueryObjectui64v;
  if (!able_) return;
  for (Pending& pending : ring_) pending.query = generate<&Gl::GenQueries, &Gl::DeleteQueries>(gl);
}

void GpuTimer::begin() {
  if (!able_) return;
  take_results();
  begun_ = !ring_[next_].under_way;
  if (begun_) gl_->BeginQuery(GL_TIME_ELAPSED, ring_[next_].query.id());
}

void GpuTimer::end() {
  if (!begun_) return;
  gl_->EndQuery(GL_TIME_ELAPSED);
  ring_[next_].under_way = true;
  next_ = (next_ + 1) % ring_.size();
  begun_ = false;
}

void GpuTimer::take_results() {
  for (std::size_t i = 0; i < ring_.size() && ring_[oldest_].under_way; ++i) {
    GLuint there = GL_FALSE;
    gl_->GetQueryObjectuiv(ring_[oldest_].query.id(), GL_QUERY_RESULT_AVAILABLE, &there);
    if (there == GL_FALSE) return;
    GLuint64 nanoseconds = 0;
    gl_->GetQueryObjectui64v(ring_[oldest_].query.id(), GL_QUERY_RESULT, &nanoseconds);
    ms_ = static_cast<double>(nanoseconds) * 1e-6;
    ring_[oldest_].under_way = false;
    oldest_ = (oldest_ + 1) % ring_.size();
  }
}

}  // namespace coaster::gfx
