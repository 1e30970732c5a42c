// Chooses the pieces of the track that a picture and a shadow map draw.
#include <algorithm>
#include <iterator>
#include <utility>

#include "gfx/swept_track.h"

namespace coaster::gfx {
namespace {

constexpr std::size_t kMostRunsOfKind = 96;  // of one kind

}  // namespace

void SweptTrack::sort() {
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    if (!rows_[kind].moved) continue;
    rows_[kind].moved = false;
    grouped_ = false;
    std::vector<Id>& order = rows_[kind].order;
    order.clear();
    for (Id id = 0; id < segments_.size(); ++id)
      if (segments_[id].pieces[kind].size > 0) order.push_back(id);
    std::sort(order.begin(), order.end(),
              [&](Id a, Id b) { return segments_[a].pieces[kind].first < segments_[b].pieces[kind].first; });
  }
  if (!std::exchange(grouped_, true)) group();
}

void SweptTrack::group() {
  constexpr std::uint32_t kMostPieces = 64;  // in a part
  near_.clear();
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    std::vector<Part>& parts = parts_[kind];
    parts.clear();
    for (const Id id : rows_[kind].order) {
      const Segment& segment = segments_[id];
      const Range place = segment.pieces[kind];
      if (!segment.far) {
        parts.push_back({place, id});
        if (kind == kFarTubes) near_.push_back(id);
        continue;
      }
      const glm::vec3 low = segment.middle - segment.radius, high = segment.middle + segment.radius;
      const bool joins = !parts.empty() && parts.back().near == kNone &&
                         place.first + place.size - parts.back().place.first <= kMostPieces;
      if (!joins) {
        parts.push_back({place, kNone, low, high});
        continue;
      }
      Part& part = parts.back();
      part.place.size = place.first + place.size - part.place.first;
      part.low = glm::min(part.low, low), part.high = glm::max(part.high, high);
    }
  }
}

// Makes the part of a far segment contain it. A group() makes it smaller again.
void SweptTrack::widen_part(const Segment& segment) {
  std::vector<Part>& parts = parts_[kFarTubes];
  const auto first = [](const Part& part) { return part.place.first; };
  const auto after = std::ranges::upper_bound(parts, segment.pieces[kFarTubes].first, {}, first);
  if (after == parts.begin()) return;
  Part& part = *std::prev(after);
  part.low = glm::min(part.low, segment.middle - segment.radius);
  part.high = glm::max(part.high, segment.middle + segment.radius);
}

std::size_t SweptTrack::part_count() const {
  std::size_t count = 0;
  for (const std::vector<Part>& parts : parts_) count += parts.size();
  return count;
}

// Collects runs of shown parts that are adjacent in a buffer; the gaps between them hold empty pieces.
void SweptTrack::gather(Runs& runs, const auto& shows_far) const {
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    runs[kind].clear();
    bool open = false;
    for (const Part& part : parts_[kind]) {
      const bool show = part.near == kNone ? shows_far(part) : (shown_[part.near] >> kind & 1) != 0;
      if (show && !open) runs[kind].push_back(part.place);
      if (show) runs[kind].back().size = part.place.first + part.place.size - runs[kind].back().first;
      open = show;
    }
  }
}

void SweptTrack::choose(const Reach& reach) {
  shown_.resize(segments_.size());
  for (const Id id : near_) {
    const Segment& segment = segments_[id];
    const float metres = glm::distance(eye_, segment.middle) - segment.radius;
    shown_[id] = static_cast<std::uint8_t>(metres > reach.full ? 1 << kFarTubes : 1 << kTubes | 1 << kCaps);
    if (metres <= reach.ties) shown_[id] |= 1 << kTies;
  }
  gather(chosen_, [](const Part&) { return true; });
}

void SweptTrack::look_from(glm::vec3 eye, Reach reach) {
  if (eye == eye_ && reach == reach_) return;
  eye_ = eye, reach_ = reach;
  sort();
  constexpr int kMostHalvings = 12;
  for (int halvings = 0;; ++halvings, reach.full /= 2, reach.ties /= 2) {
    if (halvings == kMostHalvings) reach = {-1, -1};
    choose(reach);
    const bool few_runs = std::all_of(chosen_.begin(), chosen_.end(),
                                      [](const std::vector<Range>& runs) { return runs.size() <= kMostRunsOfKind; });
    if (halvings == kMostHalvings || (few_runs && triangles() <= kTriangleBudget)) return;
  }
}

Cast SweptTrack::cast(const glm::mat4& light, float texel_metres, bool unseen) {
  sort();
  const bool full = texel_metres < 8 * static_cast<float>(sim::kRailRadius);
  const auto kinds = static_cast<std::uint8_t>(full ? 1 << kTubes | 1 << kCaps | 1 << kTies : 1 << kFarTubes);
  shown_.resize(segments_.size());
  for (const Id id : near_)
    shown_[id] = reaches(light, segments_[id].middle, segments_[id].radius) ? kinds : std::uint8_t{0};
  gather(cast_, [&](const Part& part) {
    return reaches(light, 0.5f * (part.low + part.high), 0.5f * glm::distance(part.low, part.high));
  });
  for (std::vector<Range>& runs : cast_)
    if (runs.size() > kMostRunsOfKind)
      runs = {Range{runs.front().first, runs.back().first + runs.back().size - runs.front().first}};
  if (!unseen) draw(cast_);
  return {draw_calls(cast_), triangles(cast_)};
}

}  // namespace coaster::gfx
