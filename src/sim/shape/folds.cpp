// Finds folds, where 1 - h k up <= 0 (rails.h), by samples, the minima between them, and bisection; and tight bends.
#include "sim/shape/folds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "base/bits.h"
#include "base/numerics.h"
#include "curve/tight_places.h"
#include "sim/shape/rails.h"

namespace coaster::sim {
namespace {

constexpr int kSamples = 64;     // intervals per segment
constexpr double kGentle = 0.2;  // height times curvature: segments below it at all samples have no fold

struct OffsetLine {
  const SegmentShape& shape;
  double height;
  double along(double t) const { return offset_point(shape, shape.arc.distance(t), height).along; }
};

// Returns the position of the minimum of a function with one minimum between a and b, by golden sections.
double least_between(const OffsetLine& line, double a, double b) {
  constexpr double kGolden = 0.6180339887498949;
  double c = b - kGolden * (b - a), d = a + kGolden * (b - a), at_c = line.along(c), at_d = line.along(d);
  for (int i = 0; i < 30; ++i) {
    if (at_c < at_d) b = d, d = c, at_d = at_c, c = b - kGolden * (b - a), at_c = line.along(c);
    else a = c, c = d, at_c = at_d, d = a + kGolden * (b - a), at_d = line.along(d);
  }
  return at_c < at_d ? c : d;
}

// Returns the border between a position that folds and one that does not.
double border(const OffsetLine& line, double folds, double clear) {
  return base::bisect({folds, clear}, 30, [&](double t) { return line.along(t) <= 0; }).low;
}

bool gentle(const OffsetLine& line) {
  for (int i = 0; i <= kSamples; ++i)
    if (std::abs(line.height) * curve::curvature(line.shape.key.cubic, static_cast<double>(i) / kSamples) > kGentle)
      return false;
  return true;
}

// Adds the fold from t0 to t1, with its tightest position; distances along the segment.
void add_fold(const OffsetLine& line, double t0, double t1, double tightest, std::vector<Fold>& out) {
  const curve::ArcLengthMap& arc = line.shape.arc;
  const double bend = (1 - line.along(tightest)) / std::abs(line.height);
  out.push_back({arc.distance(t0), arc.distance(t1), arc.distance(tightest), 1 / bend,
                 glm::vec3(offset_point(line.shape, arc.distance(tightest), line.height).position)});
}

std::vector<Fold> folds_of(const SegmentShape& shape, double height) {
  const OffsetLine line{shape, height};
  std::vector<Fold> out;
  if (height == 0 || !(shape.arc.length() > 0) || gentle(line)) return out;
  struct Sample {
    double t, along;
  };
  std::vector<Sample> samples;
  for (int i = 0; i <= kSamples; ++i) {
    const double t = static_cast<double>(i) / kSamples;
    samples.push_back({t, line.along(t)});
  }
  const std::vector<Sample> even = samples;
  for (std::size_t i = 1; i + 1 < even.size(); ++i) {
    if (!(even[i].along <= even[i - 1].along && even[i].along <= even[i + 1].along)) continue;
    const double t = least_between(line, even[i - 1].t, even[i + 1].t);
    samples.push_back({t, line.along(t)});
  }
  std::ranges::sort(samples, {}, &Sample::t);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples[i].along > 0) continue;
    const std::size_t first = i;
    std::size_t tightest = i;
    for (; i < samples.size() && samples[i].along <= 0; ++i)
      if (samples[i].along < samples[tightest].along) tightest = i;
    const double from = first > 0 ? border(line, samples[first].t, samples[first - 1].t) : 0.0,
                 to = i < samples.size() ? border(line, samples[i - 1].t, samples[i].t) : 1.0;
    add_fold(line, from, to, samples[tightest].t, out);
  }
  return out;
}

// Appends a segment's folds to those of the track before it; a fold across a joint is one.
void append(const std::vector<Fold>& found, double start, std::vector<Fold>& all) {
  constexpr double kMeet = 1e-9;  // m
  for (Fold fold : found) {
    fold.from += start, fold.to += start, fold.at += start;
    if (all.empty() || fold.from - all.back().to > kMeet) {
      all.push_back(fold);
      continue;
    }
    const double from = all.back().from;
    if (fold.radius > all.back().radius) all.back().to = fold.to;
    else fold.from = from, all.back() = fold;
  }
}

}  // namespace

std::vector<Fold> folds_of(const DerivedTrack& derived, double height) {
  std::vector<Fold> all;
  for (std::size_t i = 0; i < derived.order.size(); ++i)
    append(folds_of(derived.shape_at(i), height), derived.starts[i], all);
  return all;
}

std::string fold_text(const Fold& fold, double height) {
  return fmt::format("at {:.1f} m, where the curve's radius of {:.2f} m is below the height of {:.2f} m", fold.at,
                     fold.radius, std::abs(height));
}

std::vector<Fold> rail_folds(const SegmentShape& shape) { return folds_of(shape, shape.key.rails); }

const std::vector<Fold>& Folds::update(const DerivedTrack& derived) {
  if (last_build_ == derived.last_build && base::same_bits(order_, derived.order)) return all_;
  const auto changes = derived.changes_since(std::exchange(last_build_, derived.last_build));
  if (!changes && !base::same_bits(order_, derived.order)) {
    order_ = derived.order;
    entries_.assign(order_.size(), {});
    folded_.clear();
  }
  const auto take = [&](std::size_t i) {
    const SegmentShape& shape = derived.shape_at(i);
    if (entries_[i].build == shape.shape_build) return;
    entries_[i] = {shape.shape_build, find_(shape)};
    if (entries_[i].found.empty()) folded_.erase(i);
    else folded_.insert(i);
  };
  if (changes)
    for (const ShapeChange& change : *changes) take(change.index);
  else
    for (std::size_t i = 0; i < order_.size(); ++i) take(i);
  all_.clear();
  for (const std::size_t i : folded_) append(entries_[i].found, derived.starts[i], all_);
  return all_;
}

std::vector<TightBend> tight_bends_of(const SegmentShape& shape) {
  const curve::Cubic& cubic = shape.key.cubic;
  std::vector<TightBend> bends;
  double apart = curve::radius_at(cubic, 0);
  for (const curve::TightPlace& place : curve::tight_places(cubic, kLeastRadius)) {
    const double at = shape.arc.distance(place.t);
    const TightBend bend{at, at, at, place.radius, glm::vec3(rails_point(shape, place.t))};
    const bool joined = apart < kLeastRadius;
    apart = place.apart;
    if (!joined || (!bends.empty() && place.reversal)) bends.push_back(bend);
    else if (bends.empty()) bends.push_back(bend), bends.back().from = 0;
    else if (bend.radius < bends.back().radius) bends.back() = {bends.back().from, at, at, bend.radius, bend.place};
  }
  if (!bends.empty() && apart < kLeastRadius) bends.back().to = shape.arc.length();
  return bends;
}

std::vector<TightBend> tight_bends_of(const DerivedTrack& derived) { return Folds(tight_bends_of).update(derived); }

const TightBend& tightest(std::span<const TightBend> bends) {
  return *std::ranges::min_element(bends, {}, &TightBend::radius);
}

std::string tight_text(std::span<const TightBend> bends) {
  if (bends.empty()) return {};
  const TightBend& worst = tightest(bends);
  const std::string what =
      worst.radius > 0 ? fmt::format("a radius of {:.3g} m", worst.radius) : "the direction reverses";
  return fmt::format("{} tight bend{}: {} at {:.1f} m", bends.size(), bends.size() == 1 ? "" : "s", what, worst.at);
}

double least_radius(const DerivedTrack& derived) {
  double least = std::numeric_limits<double>::infinity();
  for (const world::Entity segment : derived.order)
    for (const curve::TightPlace& place : curve::tight_places(derived.shape(segment).key.cubic, least))
      least = std::min(least, place.radius);
  return least;
}

}  // namespace coaster::sim
