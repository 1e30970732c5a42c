// Parts of the laboratory besides its layers: the colouring of the track, and the pages of its strip. Tables of names;
// ui builds the pages.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "base/enum_names.h"

namespace coaster::world {

// The colouring of the track.
enum class Colouring : std::uint8_t {
  plain,
  speed,
  height,
  vertical,
  lateral,
  longitudinal,
  up_stop,
  jerk,
  roll_rate,
  roll_acceleration,
  curvature,
  error
};

struct ColouringRow {
  std::string_view name;   // in scripts and recordings: "colour speed"
  std::string_view label;  // in the panel and over the legend
  std::string_view unit;
  std::string_view help;
  bool of_ride = false;  // needs a simulation of the whole ride
};
inline constexpr ColouringRow kColourings[] = {
    {"plain", "Plain", "", "Painted steel."},
    {"speed", "Speed", "m/s", "Speed of the simulated ride.", true},
    {"height", "Height", "m", "Height above the ground."},
    {"vertical", "Vertical g", "g", "Presses riders into the seat. 1 at rest, below 0 in airtime.", true},
    {"lateral", "Lateral g", "g", "Pushes riders sideways.", true},
    {"longitudinal", "Longitudinal g", "g", "Pushes riders into the backrest. Below 0 into the lap bar.", true},
    {"up_stop", "Up-stop load", "kN", "Load of a car's up-stop wheels. Above 0 where riders are lifted.", true},
    {"jerk", "Jerk", "g/s", "How fast the felt g changes.", true},
    {"roll_rate", "Roll rate", "deg/s", "How fast the cars roll about the rails, to either side.", true},
    {"roll_acceleration", "Roll acceleration", "deg/s^2", "How fast the roll rate changes.", true},
    {"curvature", "Curvature", "1/m", "1 / radius of the osculating circle."},
    {"error", "Evaluator error", "mm", "Distance of the selected evaluator's vertices from the exact curve."},
};
constexpr std::span<const ColouringRow> rows_of(Colouring) { return kColourings; }

// The seat whose ride is plotted.
enum class Seat : std::uint8_t { front, middle, back, all, car };
inline constexpr base::NameRow kSeats[] = {
    {"front", "Front car", "Riders of the first car."},
    {"middle", "Middle car", "Riders of the middle car; of an even number, the one behind the middle."},
    {"back", "Back car", "Riders of the last car."},
    {"all", "All cars", "The band between the least and the most that any car's riders feel."},
    {"car", "Car", "Riders of the car with the number of seat_car."}};
constexpr std::span<const base::NameRow> rows_of(Seat) { return kSeats; }

// The pages of the laboratory's strip: PAGE(name, label, help). `name` is the enumerator and the word of scripts ("page
// weights"); ui/lab builds the page in a function NAME_page().
#define COASTER_LAB_PAGES(PAGE)                                                                                   \
  PAGE(construction, "Construction", "De Casteljau's construction of the curve point at the probe.")              \
  PAGE(weights, "Weights", "The Bernstein basis: the weight of each control point in the curve point.")           \
  PAGE(hodograph, "Hodograph", "The derivative B'(t) as a curve, and the parametric speed.")                      \
  PAGE(error, "Error", "Rounding error of the selected evaluator along the segment, in millimetres.")             \
  PAGE(lengths, "Lengths", "Every arc-length method on the segment and on the track, and its convergence.")       \
  PAGE(frames, "Frames", "Frames along the track, curvature, torsion, and where Frenet-Serret fails.")            \
  PAGE(joints, "Joints", "Continuity at the joints, what riders feel there, and buttons that repair it.")         \
  PAGE(errata, "Errata", "Wrong claims of the 2012 paper and the correct values for the segment.")                \
  PAGE(measurements, "Measurements", "Time and error of every evaluator, measured on this machine.")              \
  PAGE(forces, "Forces", "Speed, height and g over the whole ride, overloads, and ratings, before it is ridden.") \
  PAGE(riders, "Riders", "g, jerk, roll, speed and height of any seat over the whole ride, with one cursor.")

enum class LabPage : std::uint8_t {
#define COASTER_ENUMERATOR(name, label, help) name,
  COASTER_LAB_PAGES(COASTER_ENUMERATOR)
#undef COASTER_ENUMERATOR
};

inline constexpr base::NameRow kLabPages[] = {
#define COASTER_ROW(name, label, help) {#name, label, help},
    COASTER_LAB_PAGES(COASTER_ROW)
#undef COASTER_ROW
};
constexpr std::span<const base::NameRow> rows_of(LabPage) { return kLabPages; }

}  // namespace coaster::world
