#include "sim/solids/supports.h"

#include <algorithm>
#include <limits>

#include "sim/shape/rails.h"
#include "sim/solids/support_forms.h"
#include "sim/solids/track_mesh.h"

namespace coaster::sim {
namespace {

// Returns the desired spacing of supports on a segment.
double wanted_spacing(const SegmentShape& shape) {
  constexpr double kTight = 14;      // m of radius: at and below it spacing is smallest
  constexpr double kHighTrack = 25;  // m
  const double length = shape.arc.length();
  double turned = 0;
  glm::dvec3 last = shape.frame(0).forward;
  for (int i = 1; i <= kFrameIntervals; ++i) {
    const glm::dvec3 next = shape.frame(i).forward;
    turned += glm::length(next - last);
    last = next;
  }
  const double bent = std::min(1.0, kTight * turned / length);
  const double high = std::clamp(curve::point(shape.key.cubic, 0.5).y / kHighTrack - 0.5, 0.0, 0.5);
  return std::max(kMinSupportSpacing,
                  kMaxSupportSpacing - (kMaxSupportSpacing - kMinSupportSpacing) * std::max(bent, high));
}

// True if the feet of `bars` are at least kApart from those of the segment's other supports.
bool apart(std::span<const Bar> bars, std::span<const Bar> others) {
  constexpr float kApart = 1;  // m
  return std::none_of(bars.begin(), bars.end(), [&](const Bar& bar) {
    return bar.grounded && std::any_of(others.begin(), others.end(), [&](const Bar& other) {
             return other.grounded && glm::distance(bar.to, other.to) < kApart;
           });
  });
}

// Returns the box of all possible bars of the segment's supports with their clearance.
curve::Box reach_of(const curve::Box& box) {
  const float aside = kSupportReach + static_cast<float>(kEnvelopeRadius + kEnvelopeLift + kSpineDrop) + 1;
  curve::Box reach = widened(box, aside);
  reach.low.y = -std::numeric_limits<float>::infinity();
  return reach;
}

}  // namespace

SupportRow support_row(const SegmentShape& shape) {
  constexpr double kShortest = 0.05,
                   kMost = 1.7;  // m; largest spacing relative to the segment's length, for a support on each
  const double length = shape.arc.length();
  if (!(length > kShortest)) return {};
  double wanted = wanted_spacing(shape) / length;
  if (wanted <= kMost) return {static_cast<int>(std::clamp(1 / wanted + 0.62, 1.0, double{kMostSupports})), 1};
  int turns = 1;
  for (; wanted > kMost; wanted /= 2) turns *= 2;
  return {1, turns};
}

void Supports::drop_vanished(const Derived& derived) {
  for (std::size_t i = 0; i < entries_.size(); ++i)
    if (!derived.segments.contains(entries_.entities()[i])) moved_.push_back(entries_.items()[i].lane.box);
  entries_.keep_those_of(derived.segments);
}

void Supports::take_shapes(const Derived& derived) {
  const int most_rings = detail_.most_rings;
  for (const world::Entity segment : derived.order) {
    const SegmentShape& shape = derived.shape(segment);
    Entry* entry = entries_.find(segment);
    if (entry && entry->shape_build == shape.shape_build) continue;
    if (entry) moved_.push_back(entry->lane.box);
    else entry = &entries_.put(segment, Entry{});
    entry->shape_build = shape.shape_build;
    entry->stale = true;
    entry->lane = {rings_of(shape, most_rings), rails_box(shape)};
    entry->reach = reach_of(entry->lane.box);
    entry->row = support_row(shape);
    moved_.push_back(entry->lane.box);
  }
}

// Short segments have supports by their index in the track: if the index changed, other segments have one.
void Supports::take_turns() {
  for (std::size_t i = 0; i < order_.size(); ++i) {
    Entry& entry = entries_.get(order_[i]);
    const int count = entry.row.on(i);
    if (count != entry.count) entry.stale = true;
    entry.count = count;
  }
}

void Supports::mark_disturbed() {
  for (Entry& entry : entries_.items())
    entry.stale = entry.stale || std::any_of(moved_.begin(), moved_.end(),
                                             [&](const curve::Box& box) { return meet(entry.reach, box); });
}

void Supports::find_stale(const Derived& derived) {
  for (std::size_t i = 0; i < derived.order.size(); ++i) {
    Entry& entry = entries_.get(derived.order[i]);
    if (!entry.stale) continue;
    entry.stale = false;
    ++rebuilds_;
    const SegmentShape& shape = derived.shape_at(i);
    SegmentSupports found;
    found.places = entry.count;
    for (int k = 0; k < entry.count; ++k) {
      const double s = shape.arc.length() * (k + 0.5) / entry.count;
      const Ring at = ring_at(shape, s);
      const bool held = try_forms(at, [&](std::span<const Bar> bars) {
        const bool clear = apart(bars, found.bars) && std::all_of(bars.begin(), bars.end(), [&](const Bar& bar) {
                             return is_clear(derived, lanes_, bar, {i, s});
                           });
        if (clear) found.bars.insert(found.bars.end(), bars.begin(), bars.end());
        return clear;
      });
      if (held) found.holds.push_back(at);
    }
    found.build = found.bars == entry.found.bars && entry.found.build != 0 ? entry.found.build : ++last_build_;
    entry.found = std::move(found);
  }
}

void Supports::update(const Derived& derived) {
  rebuilds_ = 0;
  moved_.clear();
  if (const Detail detail = detail_of(derived); !(detail == detail_)) {
    const std::uint64_t last_build = last_build_;
    *this = {};  // recomputes everything
    detail_ = detail, last_build_ = last_build;
  }
  if (!detail_.parts) return;
  const bool reordered = order_ != derived.order || closed_ != derived.closed;
  if (reordered) {
    drop_vanished(derived);
    order_ = derived.order;
    closed_ = derived.closed;
  }
  take_shapes(derived);
  if (moved_.empty() && !reordered) return;
  take_turns();
  mark_disturbed();
  lanes_.clear();
  for (const world::Entity segment : order_) lanes_.push_back(&entries_.get(segment).lane);
  find_stale(derived);
  count_ = 0;
  for (const Entry& entry : entries_.items()) count_ += static_cast<int>(entry.found.holds.size());
}

const SegmentSupports* Supports::of(world::Entity segment) const {
  const Entry* const entry = entries_.find(segment);
  return entry ? &entry->found : nullptr;
}

}  // namespace coaster::sim
