// State of the laboratory's pages between frames: cached studies and the choices of each page. The Host owns it.
#pragma once

#include <array>
#include <tuple>
#include <vector>

#include "base/kept.h"
#include "curve/arc_length_study.h"
#include "curve/continuity.h"
#include "sim/study/advice.h"
#include "sim/study/live_errata.h"
#include "sim/study/rounding.h"
#include "ui/lab/page_parts.h"
#include "ui/lab/ride_plots.h"
#include "world/force.h"

namespace coaster::ui {

struct JointRow {
  world::Entity knot;
  world::Name name;
  curve::Joint joint;
  std::optional<double> step;  // g, at the fastest passage of the whole ride; nothing without one
  double jolt = 0;             // g, in the whole ride
};
struct JointList {
  std::vector<JointRow> rows;        // in track order
  std::vector<std::size_t> by_jolt;  // indices of rows, largest jolt first
};

// Curvature and torsion of one segment by arc length.
struct BendStudy {
  std::vector<double> s, curvature, torsion;  // m, 1/m, 1/m (NaN at a cusp, or without a Frenet frame)
  std::vector<double> flips;                  // m, where the normal flips
};

struct BasisStudy {
  std::vector<double> t;
  std::vector<std::vector<double>> y;  // values of B_0 .. B_n
};
struct ErrorStudy {
  std::vector<double> t, mm;
  double bound = 0, largest = 0, seam = 0;  // mm
};

// Results of one arc-length method for the segment and the track.
struct LengthRow {
  double length = 0, error = 0;  // m, for the segment
  std::int64_t evaluations = 0;
  double microseconds = 0;  // 0: not measured
  std::vector<double> work = {}, relative_error = {};
  bool track_known = false;
  double track_length = 0, track_error = 0;  // m
};
using LengthStudy = std::vector<LengthRow>;
// Sums over the first `next` segments, by method.
struct TrackLengths {
  std::vector<double> lengths, errors;  // m
  std::size_t next = 0;
};

// The ends of the axes of a force section's plot.
struct ForceEnds {
  double from = 0, to = 1;             // m
  double low = 0, high = 1;            // of the channel
  double felt_low = 0, felt_high = 1;  // g at the right edge
};

// The edited key of a force section in the force graph, and its state during a drag.
struct ForceKeys {
  world::Name section;  // the section that these choices belong to
  world::ForceChannel channel = world::ForceChannel::vertical;
  std::optional<std::size_t> key;  // selected
  std::optional<double> inserted;  // position of a new key, selected once it exists
  int side = 0;                    // held part: 0 the key, below 0 its handle before it, above 0 its handle after it
  bool gesture = false;
  bool undone = false;                              // the drag was undone, and the mouse button is still down
  world::ForceKey from;                             // the key at the start of the drag
  ForceEnds axes;                                   // during a drag
  std::vector<double> place, asked, actual, knobs;  // data of the plot
};

struct LabCache {
  int degree = 3;  // degree of the basis functions shown
  base::Kept<int, BasisStudy> basis;
  int compared = -1;  // row of the second evaluator; -1: none
  // Keyed by the segment's build, evaluator and steps.
  base::Kept<std::tuple<std::uint64_t, int, int>, ErrorStudy> error, other_error;
  base::Kept<std::tuple<std::uint64_t, int>, LengthStudy> lengths;  // by the segment's build and steps
  // By the last build, order and steps.
  base::Kept<std::tuple<std::uint64_t, std::vector<world::Entity>, int>, TrackLengths> track_lengths;
  bool lengths_of_track = false;
  bool show_errors = false;  // where there is no space for both: errors instead of times
  std::string csv = "measurements.csv";

  // Keyed by the last build, the order of the segments, whether the track is closed, the ride's serial (0 without one)
  // and the cutoff.
  base::Kept<std::tuple<std::uint64_t, std::vector<world::Entity>, bool, std::uint64_t, double>, JointList> joints;
  bool joints_by_jolt = true;
  // Keyed by the segment's build, the last build of all, steps and speed (m/s).
  base::Kept<std::tuple<std::uint64_t, std::uint64_t, int, double>, std::array<sim::Erratum, sim::kErrata.size()>>
      errata;
  base::Kept<std::uint64_t, BendStudy> bend;  // by the segment's build

  // Keyed by the serials of ride and envelope, the first and the last car, and whether it is over time.
  base::Kept<std::tuple<std::uint64_t, std::uint64_t, int, int, bool>, SeatStudy> seat;
  std::array<sim::RideValue, 2> force_plots{sim::RideValue::vertical, sim::RideValue::speed};
  bool forces_over_time = false;
  std::array<bool, 4> graph_hidden{};  // hidden curves of the force graph
  ForceKeys keys;
  int red_chosen = -1;
  std::optional<sim::Advice> advice;  // for the selected overload
  bool advised = false;               // true once it was requested
};

}  // namespace coaster::ui
