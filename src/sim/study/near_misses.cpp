#include "sim/study/near_misses.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "base/interrupted.h"
#include "sim/solids/track_mesh.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

constexpr double kStep = 2;               // m, of chords and samples
constexpr double kLeastCell = 8;          // m, of cells; as wide as longer chords
constexpr double kMostChordsInAll = 2e5;  // longer tracks have longer chords
constexpr double kSpineDrop = 0.3;        // m below the rails

// A chord of track or a bar of a support.
struct Thing {
  dvec3 from, to;
  double reach;       // m, from its axis to a head that it nearly misses
  double begin, end;  // m along the track; of a bar: of the segment that it holds
  bool support;
};

// Things by the cells that they touch: chords in space, since track may be as high as it is long; bars, which are as
// high as the track that they hold, in plan.
class Cells {
 public:
  explicit Cells(double width) : width_(width) {}
  void add(const Thing& thing) {
    const dvec3 low = glm::min(thing.from, thing.to) - thing.reach, high = glm::max(thing.from, thing.to) + thing.reach;
    const int bottom = thing.support ? kAllHeights : cell(low.y), top = thing.support ? kAllHeights : cell(high.y);
    for (int x = cell(low.x); x <= cell(high.x); ++x)
      for (int z = cell(low.z); z <= cell(high.z); ++z)
        for (int y = bottom; y <= top; ++y) entries_.emplace_back(x, z, y, things_.size());
    things_.push_back(thing);
  }
  void sort() { std::sort(entries_.begin(), entries_.end()); }
  template <class Visit>
  void visit(dvec3 place, const Visit& visit) const {
    const int x = cell(place.x), z = cell(place.z);
    for (const int y : {kAllHeights, cell(place.y)})
      for (auto i = std::lower_bound(entries_.begin(), entries_.end(), Entry(x, z, y, 0));
           i != entries_.end() && std::tie(std::get<0>(*i), std::get<1>(*i), std::get<2>(*i)) == std::tie(x, z, y); ++i)
        visit(things_[std::get<3>(*i)]);
  }

 private:
  using Entry = std::tuple<int, int, int, std::size_t>;  // x, z, y, index of the thing
  static constexpr int kAllHeights = std::numeric_limits<int>::min();
  int cell(double v) const { return static_cast<int>(std::floor(v / width_)); }
  double width_;  // m
  std::vector<Thing> things_;
  std::vector<Entry> entries_;
};

Cells cells_of(const Derived& derived, const Supports* supports, double step) {
  Cells cells(std::max(kLeastCell, step));
  for (std::size_t i = 0; i < derived.order.size(); ++i) {
    const SegmentShape& shape = derived.shape_at(i);
    const double length = shape.arc.length();
    const int chords = std::max(1, static_cast<int>(std::ceil(length / step)));
    dvec3 before(0);
    for (int k = 0; k <= chords && !base::interrupted(); ++k) {
      const dvec3 here = ring_at(shape, length * k / chords).place(0, -kSpineDrop);
      if (k > 0)
        cells.add({before, here, kNearTrack, derived.starts[i] + length * (k - 1) / chords,
                   derived.starts[i] + length * k / chords, false});
      before = here;
    }
    const SegmentSupports* const held = supports != nullptr ? supports->of(derived.order[i]) : nullptr;
    if (held == nullptr) continue;
    for (const Bar& bar : held->bars)
      cells.add({dvec3(bar.from), dvec3(bar.to), kNearBar + double{std::max(bar.from_radius, bar.to_radius)},
                 derived.starts[i], derived.starts[i + 1], true});
  }
  cells.sort();
  return cells;
}

}  // namespace

NearMisses near_misses(const Ghost& ghost, const Derived& derived, const Supports* supports) {
  NearMisses found;
  if (derived.order.empty() || ghost.samples.empty()) return found;
  const double step = std::max(kStep, derived.length / kMostChordsInAll);
  const Cells cells = cells_of(derived, supports, step);
  const auto apart = [&](const Thing& thing, double at) {
    const double gap = std::max({0.0, thing.begin - at, at - thing.end});
    return derived.closed ? std::min({gap, thing.begin + derived.length - at, at + derived.length - thing.end}) : gap;
  };
  constexpr double kNever = -std::numeric_limits<double>::infinity();
  double next = 0, last_track = kNever, last_support = kNever;
  for (std::size_t i = 0; i < ghost.samples.size() && !base::interrupted(); ++i) {
    const GhostSample& sample = ghost.samples[i];
    if (sample.travelled < next) continue;
    if (ghost.closed && sample.travelled > derived.length) break;
    next = sample.travelled + kStep;
    if (sample.speed < kSlowestMiss) continue;
    const double at = ghost.distance(i);
    const TrackPlace place = place_at(derived, at);
    const dvec3 head = ring_at(derived.shape_at(place.index), place.s).place(0, kHead);
    bool by_track = false, by_support = false;
    cells.visit(head, [&](const Thing& thing) {
      bool& near = thing.support ? by_support : by_track;
      near =
          near || (apart(thing, at) > kMissApart && distance_between(thing.from, thing.to, head, head) < thing.reach);
    });
    if (by_track && sample.travelled - last_track > kMissApart) ++found.track;
    if (by_support && sample.travelled - last_support > kMissApart) ++found.supports;
    if (by_track) last_track = sample.travelled;
    if (by_support) last_support = sample.travelled;
  }
  return found;
}

}  // namespace coaster::sim
