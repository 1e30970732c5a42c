// A ring of timer queries.
#include "gfx/gpu_timer.h"

namespace coaster::gfx {

GpuTimer::GpuTimer(const Gl& gl) : gl_(&gl) {
  if (!gl.has_timers()) return;
  for (Object& query : ring_) query = generate<&Gl::GenQueries, &Gl::DeleteQueries>(gl);
}

void GpuTimer::begin() {
  for (; read_ < started_; ++read_) {
    const GLuint query = ring_[read_ % ring_.size()].id();
    GLuint there = GL_FALSE;
    gl_->GetQueryObjectuiv(query, GL_QUERY_RESULT_AVAILABLE, &there);
    if (there == GL_FALSE) break;
    GLuint64 nanoseconds = 0;
    gl_->GetQueryObjectui64v(query, GL_QUERY_RESULT, &nanoseconds);
    ms_ = static_cast<double>(nanoseconds) * 1e-6;
  }
  const GLuint next = ring_[started_ % ring_.size()].id();
  measuring_ = next != 0 && started_ - read_ < ring_.size();
  if (measuring_) gl_->BeginQuery(GL_TIME_ELAPSED, next);
}

void GpuTimer::end() {
  if (!measuring_) return;
  gl_->EndQuery(GL_TIME_ELAPSED);
  ++started_;
  measuring_ = false;
}

}  // namespace coaster::gfx
