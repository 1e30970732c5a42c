// Queries of the whole ride of the selected train, else of the first by name: simulated over the present track on
// demand, none without a ride.
#include <algorithm>
#include <array>
#include <cmath>

#include "query/rows.h"
#include "sim/study/riders.h"
#include "world/losses.h"

namespace coaster::query {
namespace {

const sim::Ghost* ghost_of(const Context& c) { return c.find.ride(); }

template <auto... path>
Answer rating(const Context& c, View) {
  return ghost_of(c) ? value_of(member_at(c.find.ratings(), path...)) : none(kNoRide);
}
template <sim::Extreme sim::Ratings::*member>
constexpr auto extreme = rating<member, &sim::Extreme::value>;
// The largest value of all cars, in either direction.
template <sim::RideValue value>
Answer most(const Context& c, View) {
  const sim::Riders* const riders = c.find.riders();
  return riders != nullptr ? number(std::abs(sim::most_of(riders->all(), value).value)) : none(kNoRide);
}

Answer lap_time(const Context& c, View) {
  const sim::Ghost* const ghost = ghost_of(c);
  return ghost && ghost->lap ? number(ghost->lap_time) : none(ghost ? "no lap completed" : kNoRide);
}
Answer envelope(const Context& c, View) { return ghost_of(c) ? number(c.find.overloads().size()) : none(kNoRide); }
Answer envelope_name(const Context& c, View) { return text(c.session.limits.name); }
Answer fail(const Context& c, View) { return value_of(c.session.motion.failure.kind); }
Answer fail_distance(const Context& c, View) {
  const world::Failure& failure = c.session.motion.failure;
  return failure.kind != world::FailureKind::none ? number(failure.distance) : none("the ride has not failed");
}
Answer ghost_end(const Context& c, View) {
  const sim::Ghost* const ghost = ghost_of(c);
  return ghost ? value_of(ghost->end) : none(kNoRide);
}
Answer losses(const Context& c, View) {
  const auto set = world::loss_set_of(c.session.document.resistance);
  return text(set ? base::name_of(*set) : "own");
}
template <auto member>
Answer of_cart(const Context& c, View argument) {
  return of_entity(c, argument, world::Kind::cart,
                   [&](world::Entity e) { return c.session.document.entities.get<world::Cart>(e).*member; });
}
Answer equipment(const Context& c, View argument) {
  const auto segment = entity_of(c, argument, world::Kind::segment);
  if (!segment) return segment.status();
  const auto* const found = c.session.document.entities.find<world::Equipment>(*segment);
  return found ? value_of(found->kind) : none("it has no equipment");
}

// Returns the number of segments with that equipment.
Answer equipped(const Context& c, View argument) {
  const auto kind = base::value_named<world::EquipmentKind>(argument);
  const auto& all = c.session.document.entities.pool<world::Equipment>().items();
  return number(std::count_if(all.begin(), all.end(), [&](const world::Equipment& e) { return e.kind == *kind; }));
}

std::vector<std::string> loss_sets() {
  std::vector<std::string> words = base::names_of<world::LossSet>();
  words.emplace_back("own");
  return words;
}

constexpr std::array kGhostRows{
    Query{"ride.lap_time", kNoArgument, "s", "Lap time of the simulated ride; none if it does not complete the lap.",
          lap_time, or_none()},
    Query{"ride.g_up_max", kNoArgument, "g", "Largest vertical felt g of the whole ride, low-passed, of all cars.",
          extreme<&sim::Ratings::up_most>, or_none()},
    Query{"ride.g_up_min", kNoArgument, "g", "Smallest vertical felt g of the whole ride, low-passed.",
          extreme<&sim::Ratings::up_least>, or_none()},
    Query{"ride.g_side_max", kNoArgument, "g", "Largest lateral felt g of the whole ride, low-passed, to either side.",
          extreme<&sim::Ratings::side_most>, or_none()},
    Query{"ride.g_forward_max", kNoArgument, "g", "Largest felt g forwards of the whole ride, low-passed.",
          extreme<&sim::Ratings::forward_most>, or_none()},
    Query{"ride.g_back_max", kNoArgument, "g", "Largest felt g backwards of the whole ride, low-passed.",
          extreme<&sim::Ratings::back_most>, or_none()},
    Query{"ride.road_load_max", kNoArgument, "kN", "Largest load of a car's road wheels in the whole ride, low-passed.",
          extreme<&sim::Ratings::road_most>, or_none()},
    Query{"ride.up_stop_load_max", kNoArgument, "kN", "Largest load of a car's up-stop wheels in the whole ride.",
          extreme<&sim::Ratings::up_stop_most>, or_none()},
    Query{"ride.side_load_max", kNoArgument, "kN", "Largest load of a car's side wheels in the whole ride.",
          extreme<&sim::Ratings::side_load_most>, or_none()},
    Query{"ride.jerk_max", kNoArgument, "g/s", "Largest jerk of the whole ride, of all cars.",
          most<sim::RideValue::jerk>, or_none()},
    Query{"ride.roll_rate_max", kNoArgument, "deg/s", "Largest roll rate of the whole ride, to either side.",
          most<sim::RideValue::roll_rate>, or_none()},
    Query{"ride.roll_acceleration_max", kNoArgument, "deg/s^2",
          "Largest roll acceleration of the whole ride, to either side.", most<sim::RideValue::roll_acceleration>,
          or_none()},
    Query{"ride.jolt_max", kNoArgument, "g", "Largest jolt of the whole ride, of all joints and cars.",
          extreme<&sim::Ratings::jolt_most>, or_none()},
    Query{"ride.speed_max", kNoArgument, "m/s", "Largest speed of the whole ride.", extreme<&sim::Ratings::top_speed>,
          or_none()},
    Query{"ride.envelope", kNoArgument, "", "Number of overloads: stretches where a g exceeds its limit for too long.",
          envelope, or_none()},
    Query{"envelope", kNoArgument, "", "Name of the force limits: data to edit, not a compliance check.", envelope_name,
          kText},
    Query{"ride.excitement", kNoArgument, "",
          "Excitement from 0 to 10: drops, speed, airtime, near misses, less jolts and overloads.",
          rating<&sim::Ratings::excitement>, or_none()},
    Query{"ride.intensity", kNoArgument, "", "Intensity by OpenRCT2's terms of g and drops.",
          rating<&sim::Ratings::intensity>, or_none()},
    Query{"ride.nausea", kNoArgument, "", "Nausea by OpenRCT2's terms of g and drops.", rating<&sim::Ratings::nausea>,
          or_none()},
    Query{"ride.airtime", kNoArgument, "s", "Time of the whole ride with vertical g below 0.",
          rating<&sim::Ratings::airtime>, or_none()},
    Query{"ride.drops", kNoArgument, "", "Number of descents of 3 m or more in the whole ride.",
          rating<&sim::Ratings::drops>, or_none()},
    Query{"ride.drop_max", kNoArgument, "m", "Height of the highest of these descents.",
          rating<&sim::Ratings::highest_drop>, or_none()},
    Query{"ride.height_max", kNoArgument, "m", "Largest height of the rails in the whole ride.",
          extreme<&sim::Ratings::highest>, or_none()},
    Query{"ride.near_misses", kNoArgument, "", "Times that riders pass close by other track or a support.",
          rating<&sim::Ratings::near_misses>, or_none()},
    Query{"ride.inversions", kNoArgument, "", "Number of inversions in the whole ride.",
          rating<&sim::Ratings::inversions>, or_none()},
    Query{"ride.ghost_end", kNoArgument, "",
          "Why the simulated ride does not complete the lap: none, stalled, rolled back, ran off the open end.",
          ghost_end, or_none(kOneOf<world::FailureKind>)},
    Query{"ride.fail", kNoArgument, "",
          "Why the ride stopped by itself: none, stalled, rolled back, ran off the open end, collided.", fail,
          or_none(kOneOf<world::FailureKind>)},
    Query{"ride.fail_distance", kNoArgument, "m", "Distance along the track where it stopped; none if it has not.",
          fail_distance, or_none()},
    Query{"rolling", kNoArgument, "", "Rolling friction, as a fraction of the weight.",
          of_document<&world::Document::resistance, &world::Resistance::rolling>},
    Query{"drag", kNoArgument, "1/m", "Drag.", of_document<&world::Document::resistance, &world::Resistance::drag>},
    Query{"losses",
          kNoArgument,
          "",
          "Named set of losses: frictionless, openfvd, kexedit, or own for other numbers.",
          losses,
          {Type::text, loss_sets}},
    Query{"heartline", kNoArgument, "m", "Height of the riders' hearts above the rails, for which forces are given.",
          of_document<&world::Document::heartline>},
    Query{"curve", kNoArgument, "", "What the track's curve is: rails or heartline.",
          of_document<&world::Document::curve>, kOneOf<world::TrackCurve>},
    Query{"cars", kCart, "", "Number of cars of a train.", of_cart<&world::Cart::cars>},
    Query{"car_length", kCart, "m", "Length of a car's body.", of_cart<&world::Cart::length>},
    Query{"car_mass", kCart, "kg", "Mass of a car with its riders.", of_cart<&world::Cart::mass>},
    Query{"equipment", kSegment, "", "Equipment of a segment: station, lift, launch, brake, block or none.", equipment,
          or_none(kOneOf<world::EquipmentKind>)},
    Query{"equipped", kWordOf<world::EquipmentKind>, "", "Number of segments with that equipment.", equipped},
};

}  // namespace

std::span<const Query> ghost_rows() { return kGhostRows; }

}  // namespace coaster::query
