// Queries of one seat during the whole ride of the selected train, else of the first by name: simulated over the
// present track on demand.
#include <array>
#include <utility>
#include <vector>

#include "query/rows.h"
#include "sim/study/riders.h"
#include "world/lab_view.h"

namespace coaster::query {
namespace {

// A position on the track and a seat that passes it.
struct Spot {
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
Spot spot_of(const Context& c, View word) {
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
Answer at_seat(const Context& c, View word) {
  const Spot spot = spot_of(c, word);
  const sim::Ghost* const ride = c.find.ride();
  std::optional<double> result;
  if (ride != nullptr)
    for (const sim::Rider& rider : c.find.riders()->cars(sim::cars_of(spot.seat, spot.car, ride->start.cars))) {
      const std::optional<double> here = sim::value_at(rider, spot.distance, value);
      if (here && (!result || (spot.least ? *here < *result : *here > *result))) result = here;
    }
  return result ? number(*result) : none(ride ? "the seat does not arrive there" : kNoRide);
}

}  // namespace

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

}  // namespace coaster::query
