// The session's own small functions: notices, ticks, a fresh session. Changing it is apply.cpp's.
#include "edit/session.h"

#include <utility>

namespace coaster::edit {

void notify(Session& session, NoticeKind kind, std::string text) {
  constexpr std::size_t kMost = 32;
  std::vector<Notice>& notices = session.notices;
  const std::uint64_t serial = ++session.notice_serial;
  // A drag along a limit says the same at every move: renewed instead of repeated.
  if (!notices.empty() && notices.back().kind == kind && notices.back().text == text) {
    notices.back().serial = serial;
    return;
  }
  if (notices.size() == kMost) notices.erase(notices.begin());
  notices.push_back({kind, std::move(text), serial});
}

bool dirty(const Session& session) {
  if (!session.document_hash) session.document_hash = world::hash(session.document);
  return *session.document_hash != session.saved_hash;
}

void advance_measurement(Session& session) {
  sim::measure_next(session.measurement, session.clock);
}

void advance(Session& session, int ticks) {
  if (ticks <= 0) return;
  sim::step(session.document, session.derived, session.settings.integrator, ticks, session.motion);
  session.tick += static_cast<std::uint64_t>(ticks);
}

Session make_session(sim::Clock clock) {
  Session session;
  session.clock = std::move(clock);
  session.saved_hash = world::hash(session.document);
  sim::derive(session.document, session.settings, session.clock, session.derived);
  return session;
}

}  // namespace coaster::edit
