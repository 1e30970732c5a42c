// Queries of the ride: of the selected train, else of the first by name; 0 and "none" without a train.
#include <array>

#include "query/rows.h"

namespace coaster::query {
namespace {

// A train and its motion; null if there is none.
struct Riding {
  world::Entity entity;
  const world::CartMotion* motion = nullptr;
};
Riding cart_of(const edit::Session& session) {
  const auto& carts = session.motion.carts;
  if (const world::CartMotion* const selected = carts.find(session.settings.selected))
    return {session.settings.selected, selected};
  const world::Entity first = world::first_cart(session.document);
  return {first, carts.find(first)};
}

template <class Function>
Answer of_cart(const Context& context, Function function) {
  const Riding riding = cart_of(context.session);
  const bool there = riding.motion && context.session.derived.segments.contains(riding.motion->segment);
  return number(there ? function(riding.entity, *riding.motion) : 0.0);
}

Answer state(const Context& c, std::string_view) {
  return text(cart_of(c.session).motion ? base::name_of(c.session.motion.state) : "none");
}
Answer speed(const Context& c, std::string_view) {
  return of_cart(c, [](world::Entity, const world::CartMotion& cart) { return cart.speed; });
}
Answer cart_height(const Context& c, std::string_view) {
  return of_cart(c, [&](world::Entity, const world::CartMotion& cart) {
    return sim::rail_point(c.session.derived.shape(cart.segment), cart.s).height;
  });
}
Answer distance(const Context& c, std::string_view) {
  return of_cart(c, [](world::Entity, const world::CartMotion& cart) { return cart.track_distance; });
}
Answer travelled(const Context& c, std::string_view) {
  return of_cart(c, [](world::Entity, const world::CartMotion& cart) { return cart.travelled; });
}
Answer lap(const Context& c, std::string_view) {
  return of_cart(c, [](world::Entity, const world::CartMotion& cart) { return static_cast<double>(cart.laps); });
}
Answer energy(const Context& c, std::string_view) {
  return of_cart(c, [&](world::Entity e, const world::CartMotion& cart) {
    return sim::energy(c.session.document, c.session.derived, e, cart);
  });
}
Answer energy_drift(const Context& c, std::string_view) {
  return of_cart(c, [&](world::Entity e, const world::CartMotion& cart) {
    return sim::energy_drift(c.session.document, c.session.derived, e, cart);
  });
}
Answer g_up(const Context& c, std::string_view) {
  return of_cart(c, [&](world::Entity e, const world::CartMotion& cart) {
    return sim::felt(c.session.document, c.session.derived, e, cart).up;
  });
}
Answer g_side(const Context& c, std::string_view) {
  return of_cart(c, [&](world::Entity e, const world::CartMotion& cart) {
    return sim::felt(c.session.document, c.session.derived, e, cart).left;
  });
}
Answer g_forward(const Context& c, std::string_view) {
  return of_cart(c, [&](world::Entity e, const world::CartMotion& cart) {
    return sim::felt(c.session.document, c.session.derived, e, cart).forward;
  });
}
Answer cost(const Context& c, std::string_view) { return number(c.session.measuring.ride_cost.ns_per_tick); }
Answer segment(const Context& c, std::string_view) {
  const world::CartMotion* const cart = cart_of(c.session).motion;
  return text(cart ? world::label_of(c.session.document, cart->segment) : "none");
}
Answer carts(const Context& c, std::string_view) {
  return number(c.session.document.entities.pool<world::Cart>().size());
}

constexpr std::array kRideRows{
    Query{"carts", "", "", "Number of trains.", carts},
    Query{"ride.state", "", "", "stopped, running, paused, ended or failed; none without a train.", state},
    Query{"ride.speed", "", "m/s", "Speed along the track, negative backwards.", speed},
    Query{"ride.height", "", "m", "Height (y) of the rails under the train.", cart_height},
    Query{"ride.distance", "", "m", "Distance of the train along the track.", distance},
    Query{"ride.travelled", "", "m", "Distance travelled since the start; backwards counts negative.", travelled},
    Query{"ride.lap", "", "", "Whole laps since the start; backwards counts negative.", lap},
    Query{"ride.segment", "", "", "Segment under the train.", segment},
    Query{"ride.energy", "", "J/kg", "v^2/2 + g (y - datum).", energy},
    Query{"ride.cost", "", "ns",
          "Time of a tick of the live ride on this machine, all trains together; 0 before the first tick.", cost},
    Query{"ride.energy_drift", "", "", "|energy - energy at the start| / largest kinetic energy.", energy_drift},
    Query{"ride.g_up", "", "g", "Felt acceleration towards the rider's head; 1 at rest on level track.", g_up},
    Query{"ride.g_side", "", "g", "Felt acceleration to the rider's left.", g_side},
    Query{"ride.g_forward", "", "g", "Felt acceleration forwards.", g_forward},
};

}  // namespace

std::span<const Query> ride_rows() { return kRideRows; }

}  // namespace coaster::query
