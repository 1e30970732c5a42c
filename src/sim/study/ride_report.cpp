// The ride report, as text and as CSV.
#include "sim/study/ride_report.h"

#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "base/units.h"
#include "sim/study/seat.h"
#include "sim/study/wheel_loads.h"

namespace coaster::sim {
namespace {

template <class... Values>
void add(std::string& out, fmt::format_string<Values...> format, Values&&... values) {
  fmt::format_to(std::back_inserter(out), format, std::forward<Values>(values)...);
}

void add_extreme(std::string& out, const Figure& figure) {
  const Extreme& e = figure.at;
  add(out, "  {:<22} {:>8} {:<4} at {:7.1f} m, {:6.2f} s, car {}\n", figure.name,
      base::figure_text(e.value, 2, figure.unit), figure.unit, e.distance, e.seconds, e.car + 1);
}

}  // namespace

std::vector<Figure> report_figures(const Ratings& r, std::span<const Rider> riders) {
  return {{"top speed", "m/s", r.top_speed},
          {"highest", "m", r.highest},
          {"lowest", "m", r.lowest},
          {"most vertical", "g", r.up_most},
          {"least vertical", "g", r.up_least},
          {"most lateral", "g", r.side_most},
          {"most forwards", "g", r.forward_most},
          {"most backwards", "g", r.back_most},
          {"most on road wheels", "kN", r.road_most},
          {"most on up-stops", "kN", r.up_stop_most},
          {"most on side wheels", "kN", r.side_load_most},
          {"most jerk", "g/s", most_of(riders, RideValue::jerk)},
          {"most roll rate", "deg/s", most_of(riders, RideValue::roll_rate)},
          {"most roll acceleration", "deg/s^2", most_of(riders, RideValue::roll_acceleration)},
          {"largest jolt", "g", r.jolt_most}};
}

std::string report_text(const Ghost& ghost, const Ratings& r, std::span<const Rider> riders,
                        std::span<const RedSpan> red, const std::string& track_name) {
  std::string out = track_name + "\n";
  add(out, "  {:<22} {:8.2f} m\n", "length", r.length);
  add(out, "  {:<22} {:8.2f} s{}\n", ghost.lap ? "lap" : "time", r.seconds, ghost.lap ? "" : " (no complete lap)");
  if (ghost.end != world::FailureKind::none)
    add(out, "  {:<22} {} at {:.1f} m\n", "end", base::name_of(ghost.end), ghost.distance(ghost.samples.size() - 1));
  add(out, "  {:<22} {:8}, {} m apart\n", "cars", ghost.start.cars, static_cast<int>(std::lround(ghost.start.spacing)));
  for (const Figure& figure : report_figures(r, riders)) {
    const std::string_view name = figure.name;
    if (name == "most vertical" && !riders.empty())
      add(out, "  {:<22} low-passed at {:.3g} Hz, of all cars\n", "felt g", riders.front().cutoff);
    add_extreme(out, figure);
    if (name == "top speed") add(out, "  {:<22} {:8.2f} m/s\n", "mean speed", r.mean_speed);
  }
  add(out, "  {:<22} {:8.2f} s\n", "airtime", r.airtime);
  add(out, "  {:<22} {:8}, highest {:.2f} m\n", "drops", r.drops, r.highest_drop);
  add(out, "  {:<22} {:8}\n", "inversions", r.inversions);
  add(out, "  {:<22} {:8.2f}, intensity {:.2f}, nausea {:.2f} (docs/ride.md)\n", "excitement", r.excitement,
      r.intensity, r.nausea);
  add(out, "  {:<22} {:8} (force limits by duration; not a compliance check)\n", "overloads", red.size());
  for (const RedSpan& span : red)
    add(out, "    car {:2}, {:<22} {:>6} g, limit {:.2f} g, {:.2f}..{:.2f} s, {:.1f}..{:.1f} m\n", span.car + 1,
        base::row_of(span.axis).label, base::figure_text(signed_g(span.axis, span.worst), 2, "g"),
        signed_g(span.axis, span.allowed), span.from, span.to, span.from_distance, span.to_distance);
  return out;
}

std::string report_csv(const Ghost& ghost, std::span<const Rider> riders) {
  std::string out = "time_s,distance_m,speed_m_s,height_m,acceleration_m_s2";
  for (int car = 1; car <= ghost.start.cars; ++car)
    add(out,
        ",up_{0}_g,left_{0}_g,forward_{0}_g,road_front_{0}_kN,road_rear_{0}_kN,up_stop_front_{0}_kN,"
        "up_stop_rear_{0}_kN,side_left_{0}_kN,side_right_{0}_kN",
        car);
  for (int car = 1; car <= ghost.start.cars; ++car)
    add(out, ",jerk_up_{0}_g_s,jerk_left_{0}_g_s,jerk_forward_{0}_g_s,roll_rate_{0}_deg_s,roll_acceleration_{0}_deg_s2",
        car);
  out += '\n';
  const auto cars = static_cast<std::size_t>(ghost.start.cars);
  for (std::size_t k = 0; k * cars < ghost.forces.size(); ++k) {
    const std::size_t sample = ghost.sample_of(k);
    add(out, "{:.6f},{:.4f},{:.4f},{:.4f},{:.4f}", static_cast<double>(sample) * world::kTick, ghost.distance(sample),
        ghost.samples[sample].speed, riders[0].samples[k].height, ghost.samples[sample].acceleration);
    for (std::size_t car = 0; car < cars; ++car) {
      const Force& f = ghost.forces[k * cars + car];
      const WheelLoads loads = wheel_loads(ghost, k, static_cast<int>(car));
      const Wheels front = loads.of(WheelSet::front), rear = loads.of(WheelSet::rear);
      for (const double g : {f.up, f.left, f.forward}) add(out, ",{:.4f}", base::limited_figure(g, "g"));
      for (const double load : {front.road, rear.road, front.up_stop, rear.up_stop, loads.of(WheelSet::left).side,
                                loads.of(WheelSet::right).side})
        add(out, ",{:.4f}", base::limited_figure(load, "kN"));
    }
    for (const Rider& rider : riders) {
      const RiderSample& s = rider.samples[k];
      for (const double jerk : {s.jerk.up, s.jerk.left, s.jerk.forward})
        add(out, ",{:.4f}", base::limited_figure(jerk, "g/s"));
      add(out, ",{:.4f},{:.4f}", s.roll_rate, s.roll_acceleration);
    }
    out += '\n';
  }
  return out;
}

}  // namespace coaster::sim
