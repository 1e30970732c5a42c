// Commands on the ride.
#include <algorithm>
#include <cmath>

#include "edit/change.h"

namespace coaster::edit {
namespace {

using base::Status;
using world::RideState;

constexpr int kMaxStepTicks = 100'000;

Status rideable(const Session& session) {
  if (session.document.track.segments.empty())
    return refused("the track has no segments: append knots first");
  if (session.document.entities.pool<world::Cart>().size() == 0)
    return refused("there is no cart: add one first");
  return {};
}

// The cart with the lowest number.
world::Entity first_cart(const world::Document& document) {
  const auto& carts = document.entities.pool<world::Cart>().entities();
  return *std::min_element(carts.begin(), carts.end(), [&](world::Entity a, world::Entity b) {
    return world::name_of(document, a) < world::name_of(document, b);
  });
}

}  // namespace

Status perform(Session& session, Change&, const RideStart&) {
  const Status status = rideable(session);
  if (!status) return status;
  if (session.motion.state == RideState::ended) sim::reset(session.document, session.derived, session.motion);
  session.motion.state = RideState::running;
  return {};
}

Status perform(Session& session, Change&, const RidePause&) {
  const Status status = rideable(session);
  if (!status) return status;
  if (session.motion.state == RideState::stopped || session.motion.state == RideState::ended)
    return refused("the ride is not running");
  session.motion.state = RideState::paused;
  return {};
}

Status perform(Session& session, Change&, const RideStop&) {
  const Status status = rideable(session);
  if (!status) return status;
  sim::reset(session.document, session.derived, session.motion);
  return {};
}

Status perform(Session& session, Change& change, const RideStep& command) {
  const Status status = rideable(session);
  if (!status) return status;
  if (session.motion.state == RideState::running) return refused("the ride is running: pause it first");
  if (session.motion.state == RideState::ended) return refused("the ride has ended: stop or start it first");
  const int ticks = change.clamp("ticks", command.ticks, 1, kMaxStepTicks);
  session.motion.state = RideState::running;
  sim::step(session.document, session.derived, session.settings.integrator, ticks, session.motion);
  if (session.motion.state == RideState::running) session.motion.state = RideState::paused;
  return {};
}

Status perform(Session& session, Change& change, const RideSeek& command) {
  const Status status = rideable(session);
  if (!status) return status;
  if (!std::isfinite(command.to)) return refused("expected a finite distance");
  const double distance = session.derived.closed
                              ? command.to
                              : change.clamp("distance", command.to, 0.0, session.derived.length, "m");
  sim::seek(session.document, session.derived, first_cart(session.document), distance, session.motion);
  // Stopped means at the start, ended at the end: a cart put elsewhere is neither.
  if (session.motion.state != RideState::running) session.motion.state = RideState::paused;
  return {};
}

}  // namespace coaster::edit
