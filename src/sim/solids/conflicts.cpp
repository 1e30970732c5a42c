#include "sim/solids/conflicts.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/bits.h"
#include "base/cancellable_job.h"
#include "sim/shape/rails.h"
#include "sim/solids/clearance.h"
#include "sim/solids/track_mesh.h"

namespace coaster::sim {
namespace {

// What two stretches of track of a kind need between them.
struct NeededRoom {
  ClearanceTube train, track;
  explicit NeededRoom(const DerivedTrack& derived)
      : train(form_of(derived.made.kind).train), track(form_of(derived.made.kind).track) {}
  double apart() const { return train.radius + track.radius; }  // m between the line of a train and that of track
  // m: rails farther apart never conflict
  double reach() const { return apart() + std::abs(train.lift) + std::abs(track.lift); }
};

// Returns the shorter distance along the rails from the end of one stretch to the start of another, m; negative if they
// overlap.
double between_stretches(const DerivedTrack& derived, double from, double to, double other_from, double other_to) {
  const double onward = other_from - to;
  return derived.closed ? std::min(onward, from + derived.length - other_to) : onward;
}

// Returns how many of the next chords, of at most `longest` m, certainly come closer by less than `metres`.
std::size_t chords_within(double metres, double longest) {
  return static_cast<std::size_t>(metres / std::max(longest, 1e-6));
}

double length_of(const LinePoint& p, const LinePoint& q) {
  return static_cast<double>(glm::distance(p.position, q.position));
}

glm::dvec3 lifted(glm::vec3 position, glm::vec3 up, double by) { return glm::dvec3(position) + by * glm::dvec3(up); }

// Returns by how much two chords, p to q and r to t, of at most `lengths` m together, are out of reach of each other,
// m; negative if they may conflict.
double beyond_reach(const NeededRoom& room, const LinePoint& p, const LinePoint& q, const LinePoint& r,
                    const LinePoint& t, double lengths) {
  constexpr double kRounding = 0.05;  // m, rounding of float coordinates at the limits of coordinates
  const double apart = 0.5 * static_cast<double>(glm::distance(p.position + q.position, r.position + t.position));
  return apart - 0.5 * lengths - room.reach() - kRounding;
}

// Returns the clearance that a train on one chord lacks from the other; 0 or less if it has enough.
double missing_between(const NeededRoom& room, const LinePoint& p, const LinePoint& q, const LinePoint& r,
                       const LinePoint& t) {
  const auto distance = [&](double one, double other) {
    return distance_between(lifted(p.position, p.up, one), lifted(q.position, q.up, one),
                            lifted(r.position, r.up, other), lifted(t.position, t.up, other));
  };
  return room.apart() -
         std::min(distance(room.train.lift, room.track.lift), distance(room.track.lift, room.train.lift));
}

// Returns the segments that may have new neighbours, ascending: those between a common start and a common end of both
// orders, one on each side of them, and both ends of the track, which may have been joined or cut.
std::vector<std::size_t> rearranged(const std::vector<world::Entity>& before, const std::vector<world::Entity>& now) {
  std::vector<std::size_t> indices;
  if (now.empty()) return indices;
  const auto [was, is] = std::mismatch(before.begin(), before.end(), now.begin(), now.end());
  const auto last =
      std::mismatch(before.rbegin(), std::make_reverse_iterator(was), now.rbegin(), std::make_reverse_iterator(is))
          .second;
  const auto first = is - now.begin(), end = last.base() - now.begin();
  indices.push_back(0);
  for (auto i = std::max<std::ptrdiff_t>(first - 1, 0); i < std::min<std::ptrdiff_t>(end + 1, std::ssize(now)); ++i)
    indices.push_back(static_cast<std::size_t>(i));
  indices.push_back(now.size() - 1);
  return indices;
}

}  // namespace

void Conflicts::Entry::take(const SegmentShape& shape) {
  constexpr double kMostChords = 1000;
  build = shape.shape_build;
  box = rails_box(shape);
  places.clear();
  const double length = shape.arc.length();
  const int chords = static_cast<int>(std::clamp(std::ceil(length / kConflictStep), 1.0, kMostChords));
  places.reserve(static_cast<std::size_t>(chords) + 1);
  for (int k = 0; k <= chords; ++k) {
    const double s = length * k / chords;
    const Ring ring = ring_at(shape, s);
    places.push_back({glm::vec3(ring.position), glm::vec3(ring.frame.up), static_cast<float>(s)});
  }
  longest = 0;
  for (std::size_t k = 1; k < places.size(); ++k) longest = std::max(longest, length_of(places[k - 1], places[k]));
}

// Takes the order of the track. Returns the segments that are new or have new neighbours.
std::vector<std::size_t> Conflicts::take_order(const DerivedTrack& derived) {
  std::vector<std::size_t> changed = rearranged(order_, derived.order);
  entries_.keep_those_of(derived.segments);
  entries_.reserve(derived.order.size());
  for (std::size_t i = 0; i < derived.order.size(); ++i) {
    Entry& entry = entries_.obtain(derived.order[i]);
    entry.index = i;
    if (entry.build != derived.shape_at(i).shape_build) changed.push_back(i);
  }
  order_ = derived.order;
  return changed;
}

// Begins a search of the changed segments, and of those that the last one did not reach.
void Conflicts::take_changes(const DerivedTrack& derived) {
  std::vector<world::Entity> left;
  for (; next_ < waiting_.size(); ++next_) left.push_back(order_[waiting_[next_]]);
  std::vector<std::size_t> changed;
  if (const auto changes = derived.changes_since(last_build_))
    for (const ShapeChange& change : *changes) changed.push_back(change.index);
  else changed = take_order(derived);
  last_build_ = derived.last_build;
  stale_.assign(derived.order.size(), false);
  waiting_.clear(), next_ = 0;
  spread(derived, changed);
  for (const world::Entity segment : left)
    if (const Entry* const entry = entries_.find(segment)) wait_for(entry->index);
  std::sort(waiting_.begin(), waiting_.end());
  std::erase_if(hits_, [&](const Hit& hit) {
    const Entry *const a = entries_.find(hit.a), *const b = entries_.find(hit.b);
    return !a || !b || stale_[a->index] || stale_[b->index];
  });
}

void Conflicts::wait_for(std::size_t index) {
  if (!stale_[index]) waiting_.push_back(index);
  stale_[index] = true;
}

// Adds the segments whose verdict may change: whether two positions are one stretch depends on everything between them.
void Conflicts::spread(const DerivedTrack& derived, std::span<const std::size_t> changed) {
  const std::size_t count = derived.order.size();
  std::vector<bool> is_changed(count);
  for (const std::size_t i : changed) is_changed[i] = true, wait_for(i);
  for (const std::size_t i : changed) {
    for (const std::size_t step : {std::size_t{1}, count - 1}) {
      std::size_t k = i;
      for (double away = 0; away <= kSameStretch;) {
        if (!derived.closed && (step == 1 ? k + 1 == count : k == 0)) break;
        k = (k + step) % count;
        if (k == i || is_changed[k]) break;
        wait_for(k);
        away += derived.starts[k + 1] - derived.starts[k];
      }
    }
  }
}

// Returns the entry of a segment, up to date.
const Conflicts::Entry& Conflicts::entry(const DerivedTrack& derived, std::size_t index) {
  Entry& entry = entries_.get(derived.order[index]);
  if (const SegmentShape& shape = derived.shape_at(index); entry.build != shape.shape_build) entry.take(shape);
  return entry;
}

// Checks two segments, a not after b in the track; adds at most `most` hits and returns their number.
std::size_t Conflicts::look_at(const DerivedTrack& derived, world::Entity a, world::Entity b, std::size_t most) {
  const Entry &first = entries_.get(a), &second = entries_.get(b);
  const NeededRoom room(derived);
  const double first_start = derived.starts[first.index], second_start = derived.starts[second.index];
  std::size_t count = 0;
  for (std::size_t i = 0; i + 1 < first.places.size(); ++i) {
    const LinePoint &p = first.places[i], &q = first.places[i + 1];
    for (std::size_t k = a == b ? i + 1 : 0; k + 1 < second.places.size(); ++k) {
      const LinePoint &r = second.places[k], &t = second.places[k + 1];
      if (between_stretches(derived, first_start + double{p.s}, first_start + double{q.s}, second_start + double{r.s},
                            second_start + double{t.s}) < kSameStretch)
        continue;
      if (const double beyond = beyond_reach(room, p, q, r, t, first.longest + second.longest); beyond > 0) {
        k += chords_within(beyond, second.longest);
        continue;
      }
      const double missing = missing_between(room, p, q, r, t);
      if (!(missing > 0)) continue;
      hits_.push_back({a, b, i, k, missing});
      if (++count == most) return count;
    }
  }
  return count;
}

void Conflicts::look_around(const DerivedTrack& derived, std::size_t index) {
  const world::Entity segment = derived.order[index];
  const curve::Box box = widened(entry(derived, index).box, static_cast<float>(NeededRoom(derived).reach()));
  const auto off_curve = static_cast<float>(std::abs(derived.shape(segment).key.rails));
  const std::size_t most = kMostHits * entry(derived, index).places.size();
  std::size_t count = 0;
  all_near(derived.tree, widened(box, off_curve), [&](std::size_t other) {
    if ((stale_[other] && other < index) || !meet(entry(derived, other).box, box)) return true;
    count +=
        look_at(derived, derived.order[std::min(index, other)], derived.order[std::max(index, other)], most - count);
    return count < most;
  });
}

// Consecutive hits on both stretches are one conflict.
void Conflicts::gather(const DerivedTrack& derived) {
  found_.clear();
  const auto place = [&](world::Entity segment, std::size_t i) -> const LinePoint& {
    return entries_.get(segment).places[i];
  };
  const auto start = [&](world::Entity segment, std::size_t i) {
    return derived.starts[entries_.get(segment).index] + double{place(segment, i).s};
  };
  std::sort(hits_.begin(), hits_.end(), [&](const Hit& x, const Hit& y) {
    const double a = start(x.a, x.i), b = start(y.a, y.i);
    return a != b ? a < b : start(x.b, x.k) < start(y.b, y.k);
  });
  struct Open {
    std::size_t conflict;
    double last;  // last position on its other stretch
  };
  std::vector<Open> open;
  for (const Hit& hit : hits_) {
    const double from = start(hit.a, hit.i), to = start(hit.a, hit.i + 1), other = start(hit.b, hit.k);
    std::erase_if(open, [&](const Open& one) { return from - found_[one.conflict].to >= kSameStretch; });
    auto mine = std::find_if(open.begin(), open.end(),
                             [&](const Open& one) { return std::abs(other - one.last) < 2 * kSameStretch; });
    if (mine == open.end()) {
      mine = open.insert(mine, {found_.size(), other});
      found_.push_back({.from = from, .other_from = other});
    }
    Conflict& conflict = found_[mine->conflict];
    const double other_to = start(hit.b, hit.k + 1);
    conflict.to = std::max(conflict.to, to);
    conflict.other_from = std::min(conflict.other_from, other),
    conflict.other_to = std::max(conflict.other_to, other_to);
    mine->last = other;
    if (hit.missing <= conflict.missing) continue;
    conflict.missing = hit.missing;
    conflict.at = 0.5 * (from + to);
    conflict.other = 0.5 * (other + other_to);
    conflict.at_place = 0.5f * (place(hit.a, hit.i).position + place(hit.a, hit.i + 1).position);
    conflict.other_place = 0.5f * (place(hit.b, hit.k).position + place(hit.b, hit.k + 1).position);
  }
}

const std::vector<Conflict>& Conflicts::update(const DerivedTrack& derived, std::size_t most) {
  looked_at_ = 0;
  const bool changed = last_build_ != derived.last_build || !base::same_bits(order_, derived.order);
  if (changed) take_changes(derived);
  else if (is_complete()) return found_;
  const std::size_t end = std::min(waiting_.size(), next_ + std::min(most, waiting_.size()));
  base::in_parts(end - next_, 64, base::cores(), [&, first = next_](std::size_t from, std::size_t to) {
    for (std::size_t k = from; k < to; ++k) (void)entry(derived, waiting_[first + k]);
  });
  for (; next_ < end && !base::interrupted(); ++next_, ++looked_at_) look_around(derived, waiting_[next_]);
  if (!base::interrupted()) gather(derived);
  return found_;
}

std::vector<LineConflict> Conflicts::against(const DerivedTrack& derived, std::span<const LinePoint> line,
                                             const LineConditions& terms) const {
  std::vector<LineConflict> out;
  const NeededRoom room(derived);
  const double reach = room.reach() + terms.margin, whole = line.empty() ? 0.0 : double{line.back().s};
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const LinePoint &p = line[i], &q = line[i + 1];
    const double length = length_of(p, q);
    LineConflict narrow{double{p.s}, double{q.s}, 0};
    const auto compare = [&](const LinePoint& r, const LinePoint& t, double at) {
      const double missing = missing_between(room, r, t, p, q) + terms.margin;
      if (missing > narrow.missing) narrow.missing = missing, narrow.other = at;
    };
    for (std::size_t k = 0; k < i && double{p.s} - double{line[k + 1].s} >= kSameStretch; ++k)
      if (beyond_reach(room, line[k], line[k + 1], p, q, length + length_of(line[k], line[k + 1])) <= terms.margin)
        compare(line[k], line[k + 1], -1);
    const curve::Box box =
        widened({glm::min(p.position, q.position), glm::max(p.position, q.position)}, static_cast<float>(reach));
    const auto off_curve = static_cast<float>(derived.order.empty() ? 0.0 : std::abs(derived.shape_at(0).key.rails));
    all_near(derived.tree, widened(box, off_curve), [&](std::size_t index) {
      const Entry& entry = entries_.get(derived.order[index]);
      const double start = derived.starts[index];
      for (std::size_t k = 0; k + 1 < entry.places.size(); ++k) {
        const LinePoint &r = entry.places[k], &t = entry.places[k + 1];
        if (derived.length - start - double{t.s} + double{p.s} < kSameStretch) continue;
        if (terms.comes_home && whole - double{q.s} + start + double{r.s} < kSameStretch) continue;
        if (const double beyond = beyond_reach(room, r, t, p, q, entry.longest + length) - terms.margin; beyond > 0)
          k += chords_within(beyond, entry.longest);
        else compare(r, t, start + double{r.s});
      }
      return true;
    });
    if (!(narrow.missing > 0)) continue;
    if (out.empty() || out.back().to != narrow.from) {
      out.push_back(narrow);
      continue;
    }
    LineConflict& last = out.back();
    last.to = narrow.to;
    if (narrow.missing > last.missing) last.missing = narrow.missing, last.other = narrow.other;
  }
  return out;
}

double worst(std::span<const LineConflict> parts) {
  double most = 0;
  for (const LineConflict& part : parts) most = std::max(most, part.missing);
  return most;
}

// --- Track under water

std::vector<FloodedTrack> flooded_track(const Ground& ground) {
  std::vector<FloodedTrack> found;
  bool before = false;
  for (const TrackSample& sample : ground.samples()) {
    const double depth = ground.water() - sample.at.y;
    const bool wet = depth > 0 && !sample.tunnel && ground.height(sample.at.x, sample.at.z) < ground.water();
    if (wet && !before) found.push_back({sample.distance, sample.distance, 0, {}});
    before = wet;
    if (!wet) continue;
    FloodedTrack& stretch = found.back();
    stretch.to = sample.distance;
    if (depth > stretch.depth) stretch.depth = depth, stretch.place = glm::vec3(sample.at);
  }
  return found;
}

}  // namespace coaster::sim
