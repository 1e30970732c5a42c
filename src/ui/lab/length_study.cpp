// The numbers of the Lengths page: of one segment at once, of the whole track a part in each frame.
#include <algorithm>
#include <array>
#include <vector>

#include "ui/lab/cache.h"
#include "world/evaluation.h"

namespace coaster::ui {
namespace {

using curve::ArcLengthMethod;
using curve::Cubic;
using curve::LengthDemand;

LengthDemand demand_of(const ArcLengthMethod& method, int steps) { return {steps, method.usual_tolerance}; }

// Seconds of one measurement: the median of three batches, each of as many as fill 50 us, at most 64.
double seconds_of(const ArcLengthMethod& method, const Cubic& cubic, const LengthDemand& demand,
                  const sim::Clock& clock) {
  if (!clock) return 0;
  std::array<double, 3> batches{};
  volatile double sink = 0;  // so that no measurement can be left out
  for (double& batch : batches) {
    const double began = clock();
    int runs = 0;
    double spent = 0;
    do {
      sink = sink + method.measure(cubic, demand).length;
      ++runs;
      spent = clock() - began;
    } while (spent < 50e-6 && runs < 64);
    batch = spent / runs;
  }
  std::sort(batches.begin(), batches.end());
  return batches[1];
}

LengthStudy study_of(const Cubic& cubic, int steps, const sim::Clock& clock) {
  const LengthDemand demand{steps, 1e-12};
  LengthStudy study;
  for (const curve::LengthComparison& one : curve::compare_lengths(cubic, demand)) {
    const ArcLengthMethod& method = base::row_of(one.method);
    study.rows.push_back(
        {one.length, one.error, one.evaluations, seconds_of(method, cubic, demand_of(method, steps), clock) * 1e6});
  }
  for (const curve::Convergence& one : curve::convergence(cubic)) {
    LengthRow& row = study.rows[static_cast<std::size_t>(one.method)];
    for (const curve::ConvergencePoint& point : one.points) {
      row.work.push_back(static_cast<double>(point.evaluations));
      row.relative_error.push_back(point.relative_error);
    }
  }
  return study;
}

// Adds some segments to the sums; done when all are in.
void advance(TrackLengths& track, const sim::Derived& derived, int steps) {
  constexpr std::size_t kSegmentsAFrame = 32;
  const std::size_t end = std::min(derived.order.size(), track.next + kSegmentsAFrame);
  std::vector<Cubic> cubics;
  for (; track.next < end; ++track.next) cubics.push_back(derived.shape(derived.order[track.next]).key.cubic);
  track.lengths.resize(curve::arc_length_methods().size());
  track.errors.resize(track.lengths.size());
  for (const curve::LengthComparison& one : curve::compare_lengths(cubics, {steps, 1e-12})) {
    track.lengths[static_cast<std::size_t>(one.method)] += one.length;
    track.errors[static_cast<std::size_t>(one.method)] += one.error;
  }
}

}  // namespace

const LengthStudy& kept_lengths(Ui& ui, const Probe& probe) {
  const edit::Session& session = ui.session();
  const sim::Derived& derived = session.derived;
  const int steps = session.settings.evaluation->steps;
  LabCache& lab = ui.lab;
  const auto key = std::tuple(probe.shape->shape_build, steps);
  if (!lab.lengths.key || *lab.lengths.key != key) {
    lab.lengths.value =
        study_of(probe.shape->key.cubic, steps, ui.state.scripted ? sim::Clock{} : session.measuring.clock);
    lab.lengths.key = key;
  }
  (void)lab.track_lengths.get({derived.last_build, derived.order, steps}, [] { return TrackLengths{}; });
  TrackLengths& track = lab.track_lengths.value;
  if (track.next < derived.order.size()) advance(track, derived, steps);
  const bool known = track.next == derived.order.size();
  for (std::size_t i = 0; i < lab.lengths.value.rows.size(); ++i) {
    LengthRow& row = lab.lengths.value.rows[i];
    row.track_known = known;
    row.track_length = track.lengths[i];
    row.track_error = track.errors[i];
  }
  return lab.lengths.value;
}

}  // namespace coaster::ui
