#include "sim/ground/ground.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/check.h"
#include "base/parallel.h"
#include "sim/ground/noise.h"
#include "world/sections.h"

namespace coaster::sim {
namespace {

constexpr double kReach = 44;  // m, level distance from track up to which it may change the ground
constexpr double kTile = GroundPatch::kLength;
constexpr double kBend = 1.5;  // m, how much the edge of a cut is rounded

// Height of the bottom and the sides of a cut, over its bottom, by the level distance from the track. The sides become
// steeper, so that they come out of any hill within kReach.
double side_of_cut(double distance, double half_width) {
  const double out = std::fmax(distance - half_width, 0.0);
  return 0.75 * out + 0.02 * out * out;
}

// The smaller of two heights, rounded where they are nearly equal.
double smooth_min(double a, double b) {
  const double t = std::fmin(std::fmax(0.5 + 0.5 * (a - b) / kBend, 0.0), 1.0);
  return mixed(a, b, t) - kBend * t * (1 - t);
}

bool same(const TrackSample& a, const TrackSample& b) {
  return a.at == b.at && a.station == b.station && a.tunnel == b.tunnel && a.wish == b.wish;
}

// True if a segment may change ground within the largest square.
bool near_square(const curve::Cubic& c) {
  constexpr float kHalf = 0.5f * world::kGroundSquare + kReach;
  const glm::vec3 low = glm::min(glm::min(c.p0, c.p1), glm::min(c.p2, c.p3)),
                  high = glm::max(glm::max(c.p0, c.p1), glm::max(c.p2, c.p3));
  return low.x < kHalf && low.z < kHalf && high.x > -kHalf && high.z > -kHalf;
}

int tile_of(double x) { return static_cast<int>(std::floor(x / kTile)); }

}  // namespace

bool Ground::in_square(double x, double z) const {
  const double half = 0.5 * across_ * kTile;
  return x >= -half && x < half && z >= -half && z < half;
}

const GroundPatch* Ground::patch_at(world::TilePlace place) const {
  const int half = across_ / 2, x = place.x + half, z = place.z + half;
  if (x < 0 || z < 0 || x >= across_ || z >= across_) return nullptr;
  return &patches_[static_cast<std::size_t>(z * across_ + x)];
}

void Ground::take_square(const DerivedTrack& derived) {
  const double near = 0.5 * kUsualTiles * kTile - kReach;
  bool wide = false;
  for (const world::Entity segment : derived.order) {
    const curve::Cubic& c = derived.shape(segment).key.cubic;
    for (const glm::vec3 p : {c.p0, c.p3}) wide = wide || std::fabs(p.x) > near || std::fabs(p.z) > near;
  }
  for (const auto& [place, tile] : land_.park().tiles.map())
    wide = wide || place.x < -kUsualTiles / 2 || place.x >= kUsualTiles / 2 || place.z < -kUsualTiles / 2 ||
           place.z >= kUsualTiles / 2;
  const int across = wide ? world::kGroundTilesAcross : kUsualTiles;
  if (across == across_) return;
  land_build_ = build_ + 1;
  // Patches that lie in both squares are kept.
  std::vector<GroundPatch> patches(static_cast<std::size_t>(across * across));
  std::vector<std::uint8_t> stale(patches.size(), 2);
  for (int z = 0; z < across; ++z) {
    for (int x = 0; x < across; ++x) {
      const auto i = static_cast<std::size_t>(z * across + x);
      const world::TilePlace place{static_cast<std::int16_t>(x - across / 2),
                                   static_cast<std::int16_t>(z - across / 2)};
      if (const GroundPatch* const held = patch_at(place)) {
        patches[i] = *held;
        stale[i] = stale_[static_cast<std::size_t>(held - patches_.data())];
      }
      patches[i].place = place;
    }
  }
  patches_ = std::move(patches), stale_ = std::move(stale), across_ = across;
}

void Ground::mark_near(const TrackSample& sample) {
  each_patch_near(sample.at, kReach, [&](std::size_t i) { stale_[i] = std::max<std::uint8_t>(stale_[i], 1); });
}

// Updates the samples and the tunnels, and marks the patches near those that differ. Returns true if any does.
bool Ground::take_samples(const world::Document& document, const DerivedTrack& derived, bool all) {
  world::Pool<SegmentSamples> former = std::exchange(segments_, {});
  samples_.clear();
  for (std::size_t i = 0; i < derived.order.size(); ++i) {
    const world::Entity segment = derived.order[i];
    const SegmentShape& shape = derived.shape(segment);
    const SegmentSamples* const held = former.find(segment);
    const world::Entity section = world::segment(document, segment).section;
    SegmentSamples found;
    found.shape_build = shape.shape_build;
    found.wish = section.valid() ? world::section(document, section).earthwork : world::Earthwork::automatic;
    found.station = shape.fitted == world::EquipmentKind::station;
    const bool usable = held && !all && held->shape_build == found.shape_build && held->station == found.station;
    if (usable) found.samples = held->samples;
    else if (near_square(shape.key.cubic)) found.samples = samples_of(shape, land_);
    for (TrackSample& sample : found.samples) {
      sample.segment = i, sample.wish = found.wish;
      samples_.push_back(sample);
      samples_.back().distance += derived.starts[i];
    }
    segments_.put(segment, std::move(found));
  }
  tunnels_ = find_tunnels(samples_, room_, derived.closed);
  bool changed = false;
  const TrackSample* next = samples_.data();
  for (const world::Entity segment : derived.order) {
    SegmentSamples& now = segments_.get(segment);
    for (TrackSample& sample : now.samples) sample.tunnel = (next++)->tunnel;
    const SegmentSamples* const held = former.find(segment);
    if (held && std::ranges::equal(held->samples, now.samples, same)) continue;
    changed = true;
    for (const TrackSample& sample : now.samples) mark_near(sample);
    if (held)
      for (const TrackSample& sample : held->samples) mark_near(sample);
  }
  for (const world::Entity segment : former.entities()) {
    if (segments_.contains(segment)) continue;
    changed = true;
    for (const TrackSample& sample : former.get(segment).samples) mark_near(sample);
  }
  return changed;
}

void Ground::find_gates() {
  gates_.clear();
  for (const Tunnel& tunnel : tunnels_) {
    const TrackSample &first = samples_[tunnel.first], &last = samples_[tunnel.last];
    const auto gate = [&](const TrackSample& sample, double sign) {
      glm::dvec2 inwards = sign * glm::dvec2(sample.forward.x, sample.forward.z);
      const double length = glm::length(inwards);
      inwards = length > 1e-3 ? inwards / length : glm::dvec2(1, 0);
      gates_.push_back({sample.at - 1.2 * glm::dvec3(inwards.x, 0, inwards.y), inwards});
    };
    gate(first, 1), gate(last, -1);
  }
}

void Ground::update(const world::Document& document, const DerivedTrack& derived, const TrackRoom& room) {
  rebuilds_ = 0;
  if (document.park.plain()) {
    if (plain()) return;
    const std::uint64_t build = build_ + 1;  // no number is used twice
    *this = Ground();
    build_ = build;
    return;
  }
  const bool new_park = document.park != land_.park(), new_room = room != room_;
  bool new_wish = false;
  for (std::size_t i = 0; i < derived.order.size() && !new_wish; ++i) {
    const world::Entity section = world::segment(document, derived.order[i]).section;
    const SegmentSamples* const held = segments_.find(derived.order[i]);
    new_wish = held && section.valid() && world::section(document, section).earthwork != held->wish;
  }
  if (!new_park && !new_room && !new_wish && last_build_ == derived.last_build && order_ == derived.order) return;
  if (new_park) {
    const world::Park& former = land_.park();
    world::Park without = document.park, former_without = former;
    without.tiles = former_without.tiles = {};
    const bool strokes_only = without == former_without;
    if (!strokes_only) std::ranges::fill(stale_, std::uint8_t{2});
    // A vertex at a tile's lower sides belongs to the patches there, too.
    const auto mark = [&](world::TilePlace place) {
      for (int z = place.z - 1; z <= place.z; ++z)
        for (int x = place.x - 1; x <= place.x; ++x)
          if (const GroundPatch* const patch = patch_at({static_cast<std::int16_t>(x), static_cast<std::int16_t>(z)}))
            stale_[static_cast<std::size_t>(patch - patches_.data())] = 2;
    };
    if (strokes_only) {
      const auto &old = former.tiles.map(), &now = document.park.tiles.map();
      for (const auto& [place, tile] : now)
        if (const auto held = old.find(place); held == old.end() || held->second != tile) mark(place);
      for (const auto& [place, tile] : old)
        if (!now.contains(place)) mark(place);
    }
    land_ = Land(document.park), land_build_ = build_ + 1;
  }
  if (new_room) {
    room_ = room;
    for (std::uint8_t& stale : stale_) stale = std::max<std::uint8_t>(stale, 1);
  }
  take_square(derived);
  take_samples(document, derived, new_park || new_room);
  last_build_ = derived.last_build, order_ = derived.order, track_length_ = derived.length;
  find_gates();
  build_patches();
  ++build_;
}

// What cut() needs of a sample. Open track changes no land that is lower than the sides of its cut.
struct Ground::Digging {
  glm::dvec2 at{0};
  double floor = 0, half_width = 0;  // m, of an open cut
  double cover = 0;                  // m, least height over a tunnel
  double reach = 0;                  // m^2, of the level distance
  bool tunnel = false;
};

std::vector<Ground::Digging> Ground::digging_near(const GroundPatch& patch, std::span<const std::size_t> near) const {
  const double highest = double{*std::ranges::max_element(patch.land)};
  const bool any_tunnel = std::ranges::any_of(near, [&](std::size_t i) { return samples_[i].tunnel; });
  std::vector<Digging> list;
  for (const std::size_t i : near) {
    const TrackSample& sample = samples_[i];
    if (!sample.tunnel && sample.wish == world::Earthwork::none) continue;
    Digging dig{.at = {sample.at.x, sample.at.z}, .reach = kReach * kReach, .tunnel = sample.tunnel};
    dig.floor = sample.at.y - room_.below;
    dig.half_width = room_.beside + (sample.station ? 6.5 : 2.9);
    dig.cover = sample.at.y + room_.lift + room_.tube + 0.9;
    if (!any_tunnel) {  // else the nearest open track matters, however high
      if (dig.floor >= highest + kBend) continue;
      const double reach = dig.half_width + (highest + kBend - dig.floor) / 0.75;
      dig.reach = std::fmin(dig.reach, reach * reach);
    }
    list.push_back(dig);
  }
  return list;
}

void Ground::build_patch(GroundPatch& patch, bool new_land, std::span<const std::size_t> near) const {
  const int x0 = patch.place.x * world::kGroundTileCells, z0 = patch.place.z * world::kGroundTileCells;
  const auto each = [&](auto&& visit) {
    std::size_t v = 0;
    for (int z = 0; z < GroundPatch::kSide; ++z)
      for (int x = 0; x < GroundPatch::kSide; ++x) visit(v++, GroundVertex{x0 + x, z0 + z});
  };
  if (new_land) each([&](std::size_t v, GroundVertex at) { patch.land[v] = static_cast<float>(land_.vertex(at)); });
  patch.heights = patch.land;
  const std::vector<Digging> digging = digging_near(patch, near);
  if (!digging.empty())
    each([&](std::size_t v, GroundVertex at) { patch.heights[v] = cut(at, patch.land[v], digging); });
  const auto [low, high] = std::ranges::minmax_element(patch.heights);
  patch.low = *low, patch.high = *high;
}

void Ground::build_patches() {
  std::vector<std::size_t> stale;
  for (std::size_t i = 0; i < stale_.size(); ++i)
    if (stale_[i] != 0) stale.push_back(i);
  if (stale.empty()) return;
  std::vector<std::vector<std::size_t>> near(patches_.size());
  for (std::size_t s = 0; s < samples_.size(); ++s)
    each_patch_near(samples_[s].at, kReach, [&](std::size_t i) {
      if (stale_[i] != 0) near[i].push_back(s);
    });
  const std::uint64_t build = build_ + 1;
  base::in_parts(stale.size(), 1, base::cores(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t i = stale[k];
      build_patch(patches_[i], stale_[i] == 2, near[i]);
      patches_[i].build = build;
    }
  });
  for (const std::size_t i : stale) stale_[i] = 0;
  rebuilds_ = static_cast<int>(stale.size());
}

// The height of a vertex: lowered beside open track; in a tunnel the hill, lowered behind its gates and at least as
// high as covers the tube.
float Ground::cut(GroundVertex vertex, float land, std::span<const Digging> near) const {
  const glm::dvec2 at = world::kGroundCell * glm::dvec2(vertex.x, vertex.z);
  const double none = std::numeric_limits<double>::max();
  double open = none, inside = none, cap = none, cover = -none;
  for (const Digging& dig : near) {
    const glm::dvec2 away = dig.at - at;
    const double square = glm::dot(away, away);
    if (square > dig.reach) continue;
    const double distance = std::sqrt(square);
    if (dig.tunnel) {
      inside = std::fmin(inside, distance);
      if (distance < room_.tube + 2.5) cover = std::fmax(cover, dig.cover);
    } else {
      open = std::fmin(open, distance);
      cap = std::fmin(cap, dig.floor + side_of_cut(distance, dig.half_width));
    }
  }
  double height = double{land};
  if (cap < height + kBend) height = smooth_min(height, cap);
  if (inside == none) return static_cast<float>(height);
  const double hill = std::fmax(std::fmin(double{land}, behind_gates(at)), cover);
  const double within = open == none ? 1.0 : smooth_step(0, 5, open - inside);
  return static_cast<float>(mixed(height, hill, within));
}

// The height up to which a hill may rise at a place, so that it does not hang over a portal.
double Ground::behind_gates(glm::dvec2 at) const {
  double most = std::numeric_limits<double>::max();
  for (const TunnelGate& gate : gates_) {
    const double behind = gate.behind(at), aside = gate.aside(at);
    if (behind < -4 || behind > 34 || aside > 40) continue;
    most = std::fmin(most, gate.at.y + room_.lift + room_.tube + 1.8 + 0.85 * std::fmax(0.0, behind - 1) +
                               0.9 * std::fmax(0.0, aside - room_.tube - 2.6));
  }
  return most;
}

double Ground::height(double x, double z) const {
  if (plain()) return 0;
  if (!in_square(x, z)) return land_.height(x, z);
  const int half = across_ / 2;
  const int column = std::clamp(tile_of(x) + half, 0, across_ - 1), row = std::clamp(tile_of(z) + half, 0, across_ - 1);
  const GroundPatch& patch = patches_[static_cast<std::size_t>(row * across_ + column)];
  const int x0 = patch.place.x * world::kGroundTileCells, z0 = patch.place.z * world::kGroundTileCells;
  return height_between(x, z, [&](GroundVertex at) {
    return double{patch.height(std::clamp(at.x - x0, 0, GroundPatch::kSide - 1),
                               std::clamp(at.z - z0, 0, GroundPatch::kSide - 1))};
  });
}

std::uint64_t Ground::build_under(const curve::Box& box) const {
  if (plain()) return 0;
  const double edge = 0.5 * across_ * kTile;
  const auto tile = [&](float x) { return tile_of(std::clamp(double{x}, -edge, edge - 1)) + across_ / 2; };
  const bool beyond =
      !in_square(double{box.low.x}, double{box.low.z}) || !in_square(double{box.high.x}, double{box.high.z});
  std::uint64_t build = beyond ? land_build_ : 0;
  for (int z = tile(box.low.z); z <= tile(box.high.z); ++z)
    for (int x = tile(box.low.x); x <= tile(box.high.x); ++x)
      build = std::max(build, patches_[static_cast<std::size_t>(z * across_ + x)].build);
  return build;
}

const Tunnel* Ground::tunnel_at(double distance) const {
  for (const Tunnel& tunnel : tunnels_) {
    const double behind = distance - tunnel.from;
    if ((behind >= 0 && behind <= tunnel.length) || behind + track_length_ <= tunnel.length) return &tunnel;
  }
  return nullptr;
}

std::optional<double> Ground::meet(glm::dvec3 origin, glm::dvec3 direction, double most) const {
  return meet_heights(origin, direction, most, [&](double x, double z) { return height(x, z); });
}

}  // namespace coaster::sim
