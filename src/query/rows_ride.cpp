// Queries of rides: of the selected train, else of the first by name; of its whole ride, simulated over the present
// track on demand; of one seat; and of the current challenge. None without a train.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "query/challenge_rules.h"
#include "query/rows.h"
#include "sim/study/riders.h"
#include "world/aid_settings.h"
#include "world/laboratory_settings.h"
#include "world/loss_presets.h"

namespace coaster::query {
namespace {

// A train and its motion; null if there is none.
struct TrainInMotion {
  world::Entity entity;
  const world::TrainMotion* motion = nullptr;
};
TrainInMotion cart_of(const edit::Session& session) {
  const auto& carts = session.motion.carts;
  if (const world::TrainMotion* const selected = carts.find(session.settings.selected))
    return {session.settings.selected, selected};
  const world::Entity first = world::first_cart(session.document);
  return {first, carts.find(first)};
}

template <class Function>
Answer of_cart(const QueryContext& context, Function function) {
  const TrainInMotion riding = cart_of(context.session);
  const bool there = riding.motion && context.session.derived.segments.contains(riding.motion->segment);
  return there ? value_of(function(riding.entity, *riding.motion)) : none(kNoTrain);
}

Answer state(const QueryContext& c, View) {
  return cart_of(c.session).motion ? value_of(c.session.motion.state) : none(kNoTrain);
}
template <auto member>
Answer of_motion(const QueryContext& c, View) {
  return of_cart(c, [](world::Entity, const world::TrainMotion& cart) { return static_cast<double>(cart.*member); });
}
Answer cart_height(const QueryContext& c, View) {
  return of_cart(c, [&](world::Entity, const world::TrainMotion& cart) {
    return sim::rail_point(c.session.derived.shape(cart.segment), cart.s).height;
  });
}
// Row of what a function returns for the train, or of what a path leads to from there.
template <auto function, auto... path>
Answer of_moving(const QueryContext& c, View) {
  return of_cart(c, [&](world::Entity e, const world::TrainMotion& cart) {
    return value_at(function(c.session.document, c.session.derived, e, cart), path...);
  });
}
template <double sim::LoadsByWheelKind::*kind>
Answer wheels(const QueryContext& c, View argument) {
  const auto set = base::value_named<sim::WheelSet>(argument);
  return of_cart(c, [&](world::Entity e, const world::TrainMotion& cart) {
    return sim::wheel_loads(c.session.document, c.session.derived, e, cart).of(*set).*kind;
  });
}
// Of the first car.
constexpr auto kFelt = [](const auto&... train) { return sim::felt(train...); };
constexpr auto kRolling = [](const auto&... train) { return sim::rolling(train...); };

// Jerk depends on earlier values, so it comes from the simulation of the whole ride.
Answer jerk(const QueryContext& c, View) {
  return of_cart(c, [&](world::Entity, const world::TrainMotion& cart) -> std::optional<double> {
    const sim::Riders* const riders = c.find.riders();
    if (riders == nullptr) return std::nullopt;
    return sim::value_at(riders->car(0), cart.track_distance, sim::RideValue::jerk);
  });
}
Answer cost(const QueryContext& c, View) {
  const double ns = c.session.measuring.ride_cost.ns_per_tick;
  return ns > 0 ? number(ns) : none("it was not measured");
}
Answer segment(const QueryContext& c, View) {
  const world::TrainMotion* const cart = cart_of(c.session).motion;
  return cart ? text(world::label_of(c.session.document, cart->segment)) : none(kNoTrain);
}
Answer carts(const QueryContext& c, View) { return number(c.session.document.entities.pool<world::Train>().size()); }

constexpr Query kRideRows[]{
    {"carts", "", "Number of trains.", carts},
    {"ride.state", "", "stopped, running, paused, ended or failed; none without a train.", state,
     or_none(kOneOf<world::RideState>)},
    {"ride.speed", "m/s", "Speed along the track, negative backwards.", of_motion<&world::TrainMotion::speed>,
     or_none()},
    {"ride.height", "m", "Height (y) of the rails under the train.", cart_height, or_none()},
    {"ride.distance", "m", "Distance of the train along the track.", of_motion<&world::TrainMotion::track_distance>,
     or_none()},
    {"ride.travelled", "m", "Distance travelled since the start; backwards counts negative.",
     of_motion<&world::TrainMotion::travelled>, or_none()},
    {"ride.lap", "", "Whole laps since the start; backwards counts negative.", of_motion<&world::TrainMotion::laps>,
     or_none()},
    {"ride.segment", "", "Segment under the train.", segment, or_none(kText)},
    {"ride.energy", "J/kg", "v^2/2 + g (y - datum).", of_moving<sim::energy>, or_none()},
    {"ride.cost", "ns",
     "Time of a tick of the live ride on this machine, all trains together; none before the first tick.", cost,
     of_view(or_none())},
    {"ride.energy_drift", "", "|energy - energy at the start| / largest kinetic energy.", of_moving<sim::energy_drift>,
     or_none()},
    {"ride.g_up", "g", "Felt g towards the rider's head, not low-passed; 1 at rest on level track.",
     of_moving<kFelt, &sim::FeltAcceleration::up>, or_none()},
    {"ride.g_side", "g", "Felt g to the rider's left, not low-passed.", of_moving<kFelt, &sim::FeltAcceleration::left>,
     or_none()},
    {"ride.g_forward", "g", "Felt g forwards, not low-passed.", of_moving<kFelt, &sim::FeltAcceleration::forward>,
     or_none()},
    {"wheels.road", kWordOf<sim::WheelSet>, "kN", "Load of the first car's road wheels: the rails push them up.",
     wheels<&sim::LoadsByWheelKind::road>, or_none()},
    {"wheels.up_stop", kWordOf<sim::WheelSet>, "kN",
     "Load of the first car's up-stop wheels: the rails push them down.", wheels<&sim::LoadsByWheelKind::up_stop>,
     or_none()},
    {"wheels.side", kWordOf<sim::WheelSet>, "kN", "Load of the first car's side wheels: the rails push them outwards.",
     wheels<&sim::LoadsByWheelKind::side>, or_none()},
    {"ride.jerk", "g/s", "Change of the low-passed felt g per second where the train is, in the whole ride.", jerk,
     or_none()},
    {"ride.roll_rate", "deg/s", "Rate at which the first car rolls about the rails. Positive to the right.",
     of_moving<kRolling, &sim::CarRoll::rate, glm::degrees<double>>, or_none()},
    {"ride.roll_acceleration", "deg/s^2", "Change of the roll rate per second.",
     of_moving<kRolling, &sim::CarRoll::acceleration, glm::degrees<double>>, or_none()},
};

template <auto... path>
Answer rating(const QueryContext& c, View) {
  return c.find.ride() ? value_at(c.find.ratings(), path...) : none(kNoRide);
}
template <sim::Extreme sim::Ratings::*member>
constexpr auto extreme = rating<member, &sim::Extreme::value>;
// The largest value of all cars, in either direction.
template <sim::RideValue value>
Answer most(const QueryContext& c, View) {
  const sim::Riders* const riders = c.find.riders();
  return riders != nullptr ? number(std::abs(sim::most_of(riders->all(), value).value)) : none(kNoRide);
}

Answer lap_time(const QueryContext& c, View) {
  const sim::SimulatedRide* const simulated = c.find.ride();
  return simulated && simulated->lap ? number(simulated->lap_time) : none(simulated ? "no lap completed" : kNoRide);
}
Answer envelope(const QueryContext& c, View) {
  return c.find.ride() ? number(c.find.overloads().size()) : none(kNoRide);
}
Answer fail_distance(const QueryContext& c, View) {
  const world::RideFailure& failure = c.session.motion.failure;
  return failure.kind != world::FailureKind::none ? number(failure.distance) : none("the ride has not failed");
}
Answer why_ended(const QueryContext& c, View) { return c.find.ride() ? value_of(c.find.ride()->end) : none(kNoRide); }
constexpr View kOwn = "own";
Answer losses(const QueryContext& c, View) {
  const auto set = world::loss_set_of(c.session.document.resistance);
  return text(set ? base::name_of(*set) : kOwn);
}
Answer equipment(const QueryContext& c, View argument) {
  const auto segment = entity_of(c, argument, world::EntityKind::segment);
  if (!segment) return segment.status();
  const auto* const found = c.session.document.entities.find<world::Equipment>(*segment);
  return found ? value_of(found->kind) : none("it has no equipment");
}

// Returns the number of segments with that equipment.
Answer equipped(const QueryContext& c, View argument) {
  const auto kind = base::value_named<world::EquipmentKind>(argument);
  const auto& all = c.session.document.entities.pool<world::Equipment>().items();
  return number(std::count_if(all.begin(), all.end(), [&](const world::Equipment& e) { return e.kind == *kind; }));
}

Answer paint_colour(const QueryContext& c, View argument) {
  return text(world::to_text(c.session.document.paint.of(*base::value_named<world::PaintPart>(argument))));
}
template <base::Named E, const std::string_view& other>
std::vector<std::string> names_and() {
  std::vector<std::string> words = base::names_of<E>();
  words.emplace_back(other);
  return words;
}
constexpr Query kSimulatedRows[]{
    {"ride.lap_time", "s", "Lap time of the simulated ride; none if it does not complete the lap.", lap_time,
     or_none()},
    {"ride.g_up_max", "g", "Largest vertical felt g of the whole ride, low-passed, of all cars.",
     extreme<&sim::Ratings::up_most>, or_none()},
    {"ride.g_up_min", "g", "Smallest vertical felt g of the whole ride, low-passed.", extreme<&sim::Ratings::up_least>,
     or_none()},
    {"ride.g_side_max", "g", "Largest lateral felt g of the whole ride, low-passed, to either side.",
     extreme<&sim::Ratings::side_most>, or_none()},
    {"ride.g_forward_max", "g", "Largest felt g forwards of the whole ride, low-passed.",
     extreme<&sim::Ratings::forward_most>, or_none()},
    {"ride.g_back_max", "g", "Largest felt g backwards of the whole ride, low-passed.",
     extreme<&sim::Ratings::back_most>, or_none()},
    {"ride.road_load_max", "kN", "Largest load of a car's road wheels in the whole ride, low-passed.",
     extreme<&sim::Ratings::road_most>, or_none()},
    {"ride.up_stop_load_max", "kN", "Largest load of a car's up-stop wheels in the whole ride.",
     extreme<&sim::Ratings::up_stop_most>, or_none()},
    {"ride.side_load_max", "kN", "Largest load of a car's side wheels in the whole ride.",
     extreme<&sim::Ratings::side_load_most>, or_none()},
    {"ride.jerk_max", "g/s", "Largest jerk of the whole ride, of all cars.", most<sim::RideValue::jerk>, or_none()},
    {"ride.roll_rate_max", "deg/s", "Largest roll rate of the whole ride, to either side.",
     most<sim::RideValue::roll_rate>, or_none()},
    {"ride.roll_acceleration_max", "deg/s^2", "Largest roll acceleration of the whole ride, to either side.",
     most<sim::RideValue::roll_acceleration>, or_none()},
    {"ride.jolt_max", "g", "Largest jolt of the whole ride, of all joints and cars.", extreme<&sim::Ratings::jolt_most>,
     or_none()},
    {"ride.speed_max", "m/s", "Largest speed of the whole ride.", extreme<&sim::Ratings::top_speed>, or_none()},
    {"ride.envelope", "", "Number of overloads: stretches where a g exceeds its limit for too long.", envelope,
     or_none()},
    {"envelope", "", "Name of the force limits: data to edit, not a compliance check.",
     of_session<&edit::Session::limits, &edit::ForceLimits::name>, kText},
    {"ride.excitement", "", "Excitement from 0 to 10: drops, speed, airtime, near misses, less jolts and overloads.",
     rating<&sim::Ratings::excitement>, or_none()},
    {"ride.intensity", "", "Intensity by OpenRCT2's terms of g and drops.", rating<&sim::Ratings::intensity>,
     or_none()},
    {"ride.nausea", "", "Nausea by OpenRCT2's terms of g and drops.", rating<&sim::Ratings::nausea>, or_none()},
    {"ride.airtime", "s", "Time of the whole ride with vertical g below 0.", rating<&sim::Ratings::airtime>, or_none()},
    {"ride.drops", "", "Number of descents of 3 m or more in the whole ride.", rating<&sim::Ratings::drops>, or_none()},
    {"ride.drop_max", "m", "Height of the highest of these descents.", rating<&sim::Ratings::highest_drop>, or_none()},
    {"ride.height_max", "m", "Largest height of the rails in the whole ride.", extreme<&sim::Ratings::highest>,
     or_none()},
    {"ride.near_misses", "",
     "Times that riders pass close by other track, a support, earth, water, a tree or a tunnel's mouth.",
     rating<&sim::Ratings::near_misses>, or_none()},
    {"ride.tunnels", "", "Tunnels that the ride passes.", rating<&sim::Ratings::tunnels>, or_none()},
    {"ride.in_tunnels", "m", "Length of track in these tunnels.", rating<&sim::Ratings::in_tunnels>, or_none()},
    {"ride.surroundings", "", "Share of the ride, 0 to 1, on which earth, water or trees are within 6 m of the riders.",
     rating<&sim::Ratings::close>, or_none()},
    {"ride.inversions", "", "Number of inversions in the whole ride.", rating<&sim::Ratings::inversions>, or_none()},
    {"ride.ghost_end", "",
     "Why the simulated ride does not complete the lap: none, stalled, rolled back, ran off the open end.", why_ended,
     or_none(kOneOf<world::FailureKind>)},
    {"ride.fail", "", "Why the ride stopped by itself: none, stalled, rolled back, ran off the open end, collided.",
     of_session<&edit::Session::motion, &world::Motion::failure, &world::RideFailure::kind>,
     or_none(kOneOf<world::FailureKind>)},
    {"ride.fail_distance", "m", "Distance along the track where it stopped; none if it has not.", fail_distance,
     or_none()},
    {"rolling", "", "Rolling friction, as a fraction of the weight.",
     of_document<&world::Document::resistance, &world::Losses::rolling>},
    {"drag", "1/m", "Drag.", of_document<&world::Document::resistance, &world::Losses::drag>},
    {"losses", "", "Named set of losses: frictionless, openfvd, kexedit, or own for other numbers.", losses,
     texts(names_and<world::LossSet, kOwn>)},
    {"heartline", "m", "Height of the riders' hearts above the rails, for which forces are given.",
     of_document<&world::Document::heartline>},
    {"curve", "", "What the track's curve is: rails or heartline.", of_document<&world::Document::curve>,
     kOneOf<world::TrackCurve>},
    {"kind", "", "Kind of coaster: steel, wooden, inverted, mine or kiddie.", of_document<&world::Document::kind>,
     kOneOf<world::CoasterKind>},
    {"paint", "", "Palette of the track's paint: own for the kind's usual one, mixed for other colours.",
     of_document<&world::Document::paint, palette_name>, texts(names_and<world::Palette, kMixed>)},
    {"paint.colour", kWordOf<world::PaintPart>, "", "Colour of a part's paint, #d9452f; own without one.", paint_colour,
     kText},
    {"cars", kCart, "", "Number of cars of a train.", of_train<&world::Train::cars>},
    {"car_length", kCart, "m", "Length of a car's body.", of_train<&world::Train::length>},
    {"car_mass", kCart, "kg", "Mass of a car with its riders.", of_train<&world::Train::mass>},
    {"equipment", kSegment, "", "Equipment of a segment: station, lift, launch, brake, block or none.", equipment,
     or_none(kOneOf<world::EquipmentKind>)},
    {"equipped", kWordOf<world::EquipmentKind>, "", "Number of segments with that equipment.", equipped},
};

// A position on the track and a seat that passes it.
struct SeatPosition {
  double distance = 0;  // m along the track
  world::Seat seat{};
  int car = 1;         // of Seat::car
  bool least = false;  // of several cars the smallest value, else the largest
};

constexpr std::string_view kLeast = "least", kMost = "most";
constexpr std::array kSingleSeats{world::Seat::front, world::Seat::middle, world::Seat::back};
std::vector<std::string> seats() {
  std::vector<std::string> words;
  for (const world::Seat seat : kSingleSeats) words.emplace_back(base::name_of(seat));
  words.emplace_back(kLeast), words.emplace_back(kMost);
  return words;
}
constexpr ArgumentPart kDistanceSeat[]{
    {.usage = "DISTANCE", .number = true},
    {.usage = "SEAT", .words = seats, .most = world::kMaxCars, .before = '/', .optional = true}};

// Parses "62.5", "62.5/back", "62.5/3", "62.5/least". Without a seat: the setting's.
SeatPosition spot_of(const QueryContext& c, View word) {
  const std::size_t slash = word.find('/');
  const double distance = *base::parse_double(word.substr(0, slash));
  const world::LabView& lab = *c.session.settings.lab;
  if (slash == View::npos) return {distance, lab.seat, lab.seat_car};
  const View seat = word.substr(slash + 1);
  for (const world::Seat one : kSingleSeats)
    if (seat == base::name_of(one)) return {distance, one};
  if (seat == kLeast || seat == kMost) return {distance, world::Seat::all, 1, seat == kLeast};
  return {distance, world::Seat::car, static_cast<int>(*base::parse_int(seat))};
}

template <sim::RideValue value>
Answer at_seat(const QueryContext& c, View word) {
  const SeatPosition spot = spot_of(c, word);
  const sim::SimulatedRide* const ride = c.find.ride();
  std::optional<double> result;
  if (ride != nullptr)
    for (const sim::Rider& rider : c.find.riders()->cars(sim::cars_of(spot.seat, spot.car, ride->start.cars))) {
      const std::optional<double> here = sim::value_at(rider, spot.distance, value);
      if (here && (!result || (spot.least ? *here < *result : *here > *result))) result = here;
    }
  return result ? number(*result) : none(ride ? "the seat does not arrive there" : kNoRide);
}

constexpr View kNoChallenge = "there is no challenge";

Answer active(const QueryContext& c, View) { return yes_no(c.session.game.challenge.has_value()); }
template <class Counts>
Answer count(const QueryContext& c, Counts counts) {
  if (!c.session.game.challenge) return none(kNoChallenge);
  const auto rules = read_rules(c.session.game.challenge->file, c.session.game.challenge->path);
  if (!rules) return rules.status();
  return number(std::count_if(rules->begin(), rules->end(), counts));
}
Answer goals(const QueryContext& c, View) { return count(c, must_hold); }
Answer met(const QueryContext& c, View) {
  return count(c, [&](const ParsedRule& rule) { return must_hold(rule) && look_at(c.find, rule).holds; });
}
Answer passed(const QueryContext& c, View) {
  return yes_no(c.session.game.challenge && c.session.game.challenge->medal > 0);
}
template <auto... path>
Answer of_challenge(const QueryContext& c, View) {
  return c.session.game.challenge ? value_at(*c.session.game.challenge, path...) : none(kNoChallenge);
}
template <auto member>
Answer of_card(const QueryContext& c, View) {
  return c.session.game.result ? value_at(*c.session.game.result, member) : none("no ride has ended");
}
Answer rides(const QueryContext& c, View) { return number(c.session.game.result ? c.session.game.result->serial : 0); }
Answer challenge_deviation(const QueryContext& c, View) {
  if (!c.session.game.challenge) return none(kNoChallenge);
  const double deviation = c.find.deviation();
  return std::isfinite(deviation) ? number(deviation) : none(kNoSegment);
}

Answer card_shows(const QueryContext& c, View) {
  return yes_no(c.session.settings.aids->show_card && c.session.game.show_result && c.session.game.result);
}
constexpr Query kGameRows[]{
    {"challenge.active", "", "on during a challenge.", active, kSwitch},
    {"challenge.name", "", "Name of the challenge, none without one.",
     of_challenge<&edit::ActiveChallenge::file, &exchange::ChallengeFile::name>, or_none(kText)},
    {"challenge.goals", "", "Number of goals and limits of the challenge.", goals, or_none()},
    {"challenge.met", "", "Number of them that hold now; rules about the ride use the simulated ride.", met, or_none()},
    {"challenge.passed", "", "on if the challenge has been passed since it was started.", passed, kSwitch},
    {"challenge.medal", "", "Best medal since it was started: 0 none, 1 bronze, 2 silver, 3 gold.",
     of_challenge<&edit::ActiveChallenge::medal>, or_none()},
    {"challenge.judged", "", "Number of judgements since it was started.", of_challenge<&edit::ActiveChallenge::judged>,
     or_none()},
    {"challenge.failure", "", "Why the last judgement failed; empty if it passed or there was none.",
     of_challenge<&edit::ActiveChallenge::last, &edit::ChallengeVerdict::reason>, or_none(kText)},
    {"challenge.hints", "", "Number of hints shown.", of_challenge<&edit::ActiveChallenge::hints>, or_none()},
    {"challenge.deviation", "m",
     "Largest distance between the track and the challenge's start track, independent of their knots; none without "
     "either.",
     challenge_deviation, or_none()},
    {"card.shows", "", "on while a score card is shown.", card_shows, kSwitch},
    {"card.end", "", "How the last ride ended: lap, open end, time, failed; none before the first.",
     of_card<&edit::RideResult::end>, or_none(kOneOf<edit::RideEnd>)},
    {"card.reason", "", "Why it ended, if not with a lap.", of_card<&edit::RideResult::reason>, or_none(kText)},
    {"card.seconds", "s", "Duration of the last ride.", of_card<&edit::RideResult::seconds>, or_none()},
    {"card.rides", "", "Number of rides that ended since the track was opened.", rides},
};

}  // namespace

std::span<const Query> ride_rows() { return kRideRows; }
std::span<const Query> simulated_rows() { return kSimulatedRows; }

std::span<const Query> rider_rows() {
  static const std::vector<Query> rows = [] {
    std::vector<Query> made;
    const auto add = [&]<std::size_t... I>(std::index_sequence<I...>) {
      (made.push_back({sim::kRideValues[I].name, kDistanceSeat, sim::kRideValues[I].unit, sim::kRideValues[I].help,
                       at_seat<static_cast<sim::RideValue>(I)>, or_none()}),
       ...);
    };
    add(std::make_index_sequence<sim::kRideValueCount>());
    return made;
  }();
  return rows;
}

std::span<const Query> game_rows() { return kGameRows; }

}  // namespace coaster::query
