// The session's own small functions: notices, ticks, a fresh session. Changing it is apply.cpp's.
#include "edit/session/session.h"

#include <cstdio>
#include <utility>

#include "edit/session/ride_watch.h"
#include "sim/study/ratings.h"

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

void advance_measurement(Session& session) { sim::measure_next(session.measurement, session.clock); }

world::Entity chosen_cart(const Session& session) {
  const bool selected = session.document.entities.find<world::Cart>(session.settings.selected) != nullptr;
  return selected ? session.settings.selected : world::first_cart(session.document);
}

const sim::Ghost* chosen_ride(const Session& session) {
  return session.ghosts.ride(session.document, session.derived, chosen_cart(session));
}

const sim::Ratings& chosen_ratings(const Session& session) {
  static const sim::Ratings kNone;
  const sim::Ghost* const ghost = chosen_ride(session);
  return ghost ? session.ratings.update(*ghost, session.ghosts.tables(session.document, session.derived),
                                        session.envelope.cutoff)
               : kNone;
}
const std::vector<sim::RedSpan>& chosen_red_spans(const Session& session) {
  static const std::vector<sim::RedSpan> kNone;
  const sim::Ghost* const ghost = chosen_ride(session);
  return ghost ? session.red.update(*ghost, session.envelope) : kNone;
}

const std::vector<sim::Conflict>& conflicts(const Session& session) {
  return session.conflicts.update(session.derived);
}

const std::vector<sim::Narrow>& narrow_parts(const Session& session, const world::Element& element) {
  (void)conflicts(session);
  return session.element_room.update(session.elements.plan(element, session.document), session.conflicts,
                                     session.derived);
}

std::string ride_report(const Session& session, const sim::Ghost& ghost) {
  const sim::Envelope& envelope = session.envelope;
  const sim::Ratings ratings =
      sim::rate(ghost, session.ghosts.tables(session.document, session.derived), envelope.cutoff);
  return sim::report_text(ghost, ratings, sim::red_spans(ghost, envelope), session.document.name);
}
std::string ride_csv(const Session& session, const sim::Ghost& ghost) {
  return sim::report_csv(ghost, session.ghosts.tables(session.document, session.derived));
}

std::string failure_text(const Session& session) {
  const world::Failure& failure = session.motion.failure;
  if (failure.kind == world::FailureKind::none) return {};
  char place[64];
  std::snprintf(place, sizeof place, " at %.1f m, %.1f m/s", failure.distance, failure.speed);
  return world::label_of(session.document, failure.cart) + " " + std::string(sim::text(failure.kind)) + place;
}

void advance(Session& session, int ticks) {
  if (ticks <= 0) return;
  const world::FailureKind before = session.motion.failure.kind;
  const bool timed = session.clock && session.motion.state == world::RideState::running;
  const double start = timed ? session.clock() : 0.0;
  // A challenge's ride is looked at tick by tick, so that its verdict does not depend on how many are asked for at
  // once.
  const bool watched = session.challenge && session.run.under_way && session.motion.state == world::RideState::running;
  for (int done = 0; done < ticks;) {
    const int some = watched && session.run.under_way ? 1 : ticks - done;
    const bool running = session.motion.state == world::RideState::running;
    sim::step(session.document, session.derived, session.settings.integrator, some, session.ghosts, session.motion);
    if (running) watch_ticks(session, some);
    done += some;
  }
  if (timed) {
    constexpr double kNewest = 0.1;
    const double ns = (session.clock() - start) * 1e9 / ticks;
    double& mean = session.ride_cost.ns_per_tick;
    mean = mean > 0 ? mean + kNewest * (ns - mean) : ns;
  }
  if (session.motion.failure.kind != before) notify(session, NoticeKind::warning, failure_text(session));
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
