#include "sim/solids/supports.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "base/interrupted.h"
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

// Finds the segments near enough to be met by supports of near ones: all, if everything is near. Returns whether they
// are others than before, or have other indices.
bool Supports::gather(const Derived& derived, const NearTrack& near) {
  if (near.everywhere()) {
    if (near_.empty() && order_ == derived.order) return false;
    near_.clear(), order_ = derived.order;
    places_.resize(order_.size());
    std::iota(places_.begin(), places_.end(), std::size_t{0});
    return true;
  }
  if (near_ == near.indices() && build_ == derived.last_build) return false;
  near_ = near.indices();
  places_.clear(), order_.clear();
  if (near_.empty()) return true;
  constexpr float kMargin = 1;  // m
  curve::Box room = rails_box(derived.shape_at(near_.front()));
  for (const std::size_t i : near_) {
    const curve::Box box = rails_box(derived.shape_at(i));
    room = {glm::min(room.low, box.low), glm::max(room.high, box.high)};
  }
  room = widened(reach_of(room), kMargin + static_cast<float>(std::abs(derived.shape_at(near_.front()).key.rails)));
  (void)all_near(derived.tree, room, [&](std::size_t i) {
    places_.push_back(i);
    return true;
  });
  std::sort(places_.begin(), places_.end());
  for (const std::size_t i : places_) order_.push_back(derived.order[i]);
  return true;
}

// Notes the track that moved; track that only came near or went away has not.
void Supports::take_shapes(const Derived& derived) {
  ++stamp_;
  const bool still = std::exchange(build_, derived.last_build) == derived.last_build;
  for (std::size_t k = 0; k < order_.size(); ++k) {
    const SegmentShape& shape = derived.shape_at(places_[k]);
    Entry* entry = entries_.find(order_[k]);
    const bool known = entry != nullptr && entry->shape_build == shape.shape_build;
    if (entry == nullptr) entry = &entries_.put(order_[k], Entry{});
    else if (!known) moved_.push_back(entry->lane.box);
    entry->stamp = stamp_;
    if (known) continue;
    entry->shape_build = shape.shape_build;
    entry->stale = true;
    entry->lane = {rings_of(shape, detail_.most_rings), rails_box(shape)};
    entry->reach = reach_of(entry->lane.box);
    entry->row = support_row(shape);
    if (!still) moved_.push_back(entry->lane.box);
  }
}

void Supports::drop_others(const Derived& derived) {
  std::vector<world::Entity> others;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (entries_.items()[i].stamp == stamp_) continue;
    others.push_back(entries_.entities()[i]);
    const Entry& entry = entries_.items()[i];
    const SegmentShape* const shape = derived.segments.find(others.back());
    if (shape == nullptr || shape->shape_build != entry.shape_build) moved_.push_back(entry.lane.box);
  }
  for (const world::Entity segment : others) entries_.erase(segment);
}

// The supports of a segment that is not near are found again when it is: what moves near them may be unknown.
void Supports::forget_far() {
  std::size_t n = 0;
  for (std::size_t k = 0; k < order_.size(); ++k) {
    while (n < near_.size() && near_[n] < places_[k]) ++n;
    if (n == near_.size() || near_[n] != places_[k]) entries_.get(order_[k]).stale = true;
  }
}

// Short segments have supports by their index in the track: if the index changed, other segments have one.
void Supports::take_turns() {
  for (std::size_t k = 0; k < order_.size(); ++k) {
    Entry& entry = entries_.get(order_[k]);
    const int count = entry.row.on(places_[k]);
    if (count != entry.count) entry.stale = true;
    entry.count = count;
  }
}

void Supports::mark_disturbed() {
  for (Entry& entry : entries_.items())
    entry.stale = entry.stale || std::any_of(moved_.begin(), moved_.end(),
                                             [&](const curve::Box& box) { return meet(entry.reach, box); });
}

void Supports::find_if_stale(const Derived& derived, std::size_t index) {
  Entry& entry = entries_.get(derived.order[index]);
  if (!std::exchange(entry.stale, false)) return;
  ++rebuilds_;
  if (lanes_.empty()) {
    lanes_.resize(derived.order.size());
    for (std::size_t k = 0; k < order_.size(); ++k) lanes_[places_[k]] = &entries_.get(order_[k]).lane;
  }
  const SegmentShape& shape = derived.shape_at(index);
  SegmentSupports found;
  found.places = entry.count;
  for (int k = 0; k < entry.count; ++k) {
    const double s = shape.arc.length() * (k + 0.5) / entry.count;
    const Ring at = ring_at(shape, s);
    const bool held = try_forms(at, [&](std::span<const Bar> bars) {
      const bool clear = apart(bars, found.bars) && std::all_of(bars.begin(), bars.end(), [&](const Bar& bar) {
                           return is_clear(derived, lanes_, bar, {index, s});
                         });
      if (clear) found.bars.insert(found.bars.end(), bars.begin(), bars.end());
      return clear;
    });
    if (held) found.holds.push_back(at);
  }
  found.build = found.bars == entry.found.bars && entry.found.build != 0 ? entry.found.build : ++last_build_;
  entry.found = std::move(found);
}

void Supports::update(const Derived& derived, const NearTrack& near) {
  rebuilds_ = 0;
  moved_.clear(), lanes_.clear();
  if (const Detail detail = near.detail(detail_of(derived)); !(detail == detail_)) {
    const std::uint64_t last_build = last_build_;
    *this = {};  // recomputes everything
    detail_ = detail, last_build_ = last_build;
  }
  if (!detail_.parts) return;  // count_ is 0
  const bool closes = std::exchange(closed_, derived.closed) != derived.closed;
  const bool others = gather(derived, near) || closes;
  take_shapes(derived);
  if (others) drop_others(derived);
  if (others && !near.everywhere()) forget_far();
  if (!moved_.empty() || others) {
    take_turns();
    mark_disturbed();
  } else if (near.everywhere()) {
    return;
  }
  count_ = 0;
  const auto find = [&](std::size_t index) {
    find_if_stale(derived, index);
    count_ += static_cast<int>(entries_.get(derived.order[index]).found.holds.size());
  };
  for (const std::size_t index : near.everywhere() ? places_ : near_)
    if (!base::interrupted()) find(index);
}

const SegmentSupports* Supports::of(world::Entity segment) const {
  const Entry* const entry = entries_.find(segment);
  return entry ? &entry->found : nullptr;
}

}  // namespace coaster::sim
