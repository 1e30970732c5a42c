// Queries of the ride: of the selected train, else of the first by name; none without a train.
#include <array>

#include "query/rows.h"
#include "sim/study/riders.h"
#include "sim/study/wheel_loads.h"

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
  return there ? value_of(function(riding.entity, *riding.motion)) : none(kNoTrain);
}

Answer state(const Context& c, View) {
  return cart_of(c.session).motion ? value_of(c.session.motion.state) : none(kNoTrain);
}
template <auto member>
Answer of_motion(const Context& c, View) {
  return of_cart(c, [](world::Entity, const world::CartMotion& cart) { return static_cast<double>(cart.*member); });
}
Answer cart_height(const Context& c, View) {
  return of_cart(c, [&](world::Entity, const world::CartMotion& cart) {
    return sim::rail_point(c.session.derived.shape(cart.segment), cart.s).height;
  });
}
// sim::energy or sim::energy_drift.
template <auto function>
Answer energy(const Context& c, View) {
  return of_cart(c, [&](world::Entity e, const world::CartMotion& cart) {
    return function(c.session.document, c.session.derived, e, cart);
  });
}
template <float sim::Felt::*axis>
Answer felt(const Context& c, View) {
  return of_cart(c, [&](world::Entity e, const world::CartMotion& cart) {
    return double{sim::felt(c.session.document, c.session.derived, e, cart).*axis};
  });
}
template <double sim::Wheels::*kind>
Answer wheels(const Context& c, View argument) {
  const auto set = base::value_named<sim::WheelSet>(argument);
  return of_cart(c, [&](world::Entity e, const world::CartMotion& cart) {
    return sim::wheel_loads(c.session.document, c.session.derived, e, cart).of(*set).*kind;
  });
}
template <double sim::Rolling::*member>
Answer roll(const Context& c, View) {
  return of_cart(c, [&](world::Entity e, const world::CartMotion& cart) {
    return glm::degrees(sim::rolling(c.session.document, c.session.derived, e, cart).*member);
  });
}
// Jerk depends on earlier values, so it comes from the simulation of the whole ride.
Answer jerk(const Context& c, View) {
  return of_cart(c, [&](world::Entity, const world::CartMotion& cart) -> std::optional<double> {
    const sim::Riders* const riders = c.find.riders();
    if (riders == nullptr) return std::nullopt;
    return sim::value_at(riders->car(0), cart.track_distance, sim::RideValue::jerk);
  });
}
Answer cost(const Context& c, View) {
  const double ns = c.session.measuring.ride_cost.ns_per_tick;
  return ns > 0 ? number(ns) : none("it was not measured");
}
Answer segment(const Context& c, View) {
  const world::CartMotion* const cart = cart_of(c.session).motion;
  return cart ? text(world::label_of(c.session.document, cart->segment)) : none(kNoTrain);
}
Answer carts(const Context& c, View) { return number(c.session.document.entities.pool<world::Cart>().size()); }

constexpr std::array kRideRows{
    Query{"carts", kNoArgument, "", "Number of trains.", carts},
    Query{"ride.state", kNoArgument, "", "stopped, running, paused, ended or failed; none without a train.", state,
          or_none(kOneOf<world::RideState>)},
    Query{"ride.speed", kNoArgument, "m/s", "Speed along the track, negative backwards.",
          of_motion<&world::CartMotion::speed>, or_none()},
    Query{"ride.height", kNoArgument, "m", "Height (y) of the rails under the train.", cart_height, or_none()},
    Query{"ride.distance", kNoArgument, "m", "Distance of the train along the track.",
          of_motion<&world::CartMotion::track_distance>, or_none()},
    Query{"ride.travelled", kNoArgument, "m", "Distance travelled since the start; backwards counts negative.",
          of_motion<&world::CartMotion::travelled>, or_none()},
    Query{"ride.lap", kNoArgument, "", "Whole laps since the start; backwards counts negative.",
          of_motion<&world::CartMotion::laps>, or_none()},
    Query{"ride.segment", kNoArgument, "", "Segment under the train.", segment, or_none(kText)},
    Query{"ride.energy", kNoArgument, "J/kg", "v^2/2 + g (y - datum).", energy<sim::energy>, or_none()},
    Query{"ride.cost", kNoArgument, "ns",
          "Time of a tick of the live ride on this machine, all trains together; none before the first tick.", cost,
          of_view(or_none())},
    Query{"ride.energy_drift", kNoArgument, "", "|energy - energy at the start| / largest kinetic energy.",
          energy<sim::energy_drift>, or_none()},
    Query{"ride.g_up", kNoArgument, "g", "Felt g towards the rider's head, not low-passed; 1 at rest on level track.",
          felt<&sim::Felt::up>, or_none()},
    Query{"ride.g_side", kNoArgument, "g", "Felt g to the rider's left, not low-passed.", felt<&sim::Felt::left>,
          or_none()},
    Query{"ride.g_forward", kNoArgument, "g", "Felt g forwards, not low-passed.", felt<&sim::Felt::forward>, or_none()},
    Query{"wheels.road", kWordOf<sim::WheelSet>, "kN", "Load of the first car's road wheels: the rails push them up.",
          wheels<&sim::Wheels::road>, or_none()},
    Query{"wheels.up_stop", kWordOf<sim::WheelSet>, "kN",
          "Load of the first car's up-stop wheels: the rails push them down.", wheels<&sim::Wheels::up_stop>,
          or_none()},
    Query{"wheels.side", kWordOf<sim::WheelSet>, "kN",
          "Load of the first car's side wheels: the rails push them outwards.", wheels<&sim::Wheels::side>, or_none()},
    Query{"ride.jerk", kNoArgument, "g/s",
          "Change of the low-passed felt g per second where the train is, in the whole ride.", jerk, or_none()},
    Query{"ride.roll_rate", kNoArgument, "deg/s",
          "Rate at which the first car rolls about the rails. Positive to the right.", roll<&sim::Rolling::rate>,
          or_none()},
    Query{"ride.roll_acceleration", kNoArgument, "deg/s^2", "Change of the roll rate per second.",
          roll<&sim::Rolling::acceleration>, or_none()},
};

}  // namespace

std::span<const Query> ride_rows() { return kRideRows; }

}  // namespace coaster::query
