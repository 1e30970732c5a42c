#include "sim/ground/land_mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "base/parallel.h"
#include "sim/ground/land_paint.h"
#include "sim/ground/noise.h"
#include "sim/ground/tunnel_mesh.h"

namespace coaster::sim {
namespace {

constexpr int kPatchCells = world::kGroundTileCells;
constexpr auto kCellSide = static_cast<float>(world::kGroundCell);  // m
constexpr int kSkyReach = 12;                                       // cells up to which land takes light of the sky
constexpr float kSunReach = 370;                                    // m up to which land casts shadows
constexpr double kEarthReach = 5;                                   // m
constexpr float kCrownReach = 7;                                    // m
constexpr std::uint32_t kEarthNoise = 34;

std::uint64_t mixed_key(std::uint64_t key, std::uint64_t value) {
  key = (key ^ value) * 0x9e3779b97f4a7c15u;
  return key ^ (key >> 29);
}
std::uint64_t mixed_key(std::uint64_t key, glm::dvec3 at) {
  for (const double value : {at.x, at.y, at.z}) key = mixed_key(key, std::bit_cast<std::uint64_t>(value));
  return key;
}

float smooth(float a, float b, float x) { return static_cast<float>(smooth_step(a, b, x)); }

// The part of the sky that a vertex sees, 0..1, by the steepest slopes around it.
float open_sky(const LandField& field, int x, int z) {
  constexpr int kSteps[] = {1, 2, 4, 7, kSkyReach};
  constexpr int kWays[8][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
  const float here = field.height(x, z);
  float open = 0;
  for (int way = 0; way < 8; ++way) {
    const float length = kCellSide * (way % 2 == 0 ? 1.0f : 1.41421356f);
    float steepest = 0;
    for (const int step : kSteps) {
      const float rise = field.height(x + step * kWays[way][0], z + step * kWays[way][1]) - here;
      steepest = std::max(steepest, rise / (length * static_cast<float>(step)));
    }
    open += 1 / (1 + steepest * steepest);
  }
  return open / 8;
}

// The height at a place in cells, smoothly between the vertices.
float smooth_height(const LandField& field, float x, float z) {
  const float left = std::floor(x), low = std::floor(z);
  const int i = static_cast<int>(left), j = static_cast<int>(low);
  return glm::mix(glm::mix(field.height(i, j), field.height(i + 1, j), x - left),
                  glm::mix(field.height(i, j + 1), field.height(i + 1, j + 1), x - left), z - low);
}
constexpr int kNearSteps = 12;  // of a ray to the sun, for which the nearest vertex is too coarse

// Marches towards the sun from a place, with x and z in cells: how much of its light arrives, softer with the distance
// of what hides it.
float sunlight(const LandField& field, glm::vec3 from, glm::vec3 sun, float highest, bool with_crowns) {
  const float level = std::sqrt(sun.x * sun.x + sun.z * sun.z);
  if (level < 1e-3f || sun.y <= 0) return 1;
  const float start = from.y, rise = sun.y / level;
  const glm::vec2 way = glm::vec2(sun.x, sun.z) / (level * kCellSide);  // cells per metre
  float run = 0, lit = 1, crowns = 0;
  for (int i = 0; i < 64 && lit > 0; ++i) {
    run += kCellSide * (1 + 0.06f * static_cast<float>(i));
    const float ray = start + rise * run;
    if (ray > highest + 7 || run > kSunReach) break;
    const float x = from.x + run * way.x, z = from.z + run * way.y;
    const std::size_t at = field.at(static_cast<int>(std::lround(x)), static_cast<int>(std::lround(z)));
    const float land = i < kNearSteps ? smooth_height(field, x, z) : field.heights[at];
    const float over = ray - land, wood = static_cast<float>(field.wood[at]) / 255;
    lit = std::min(lit, glm::clamp(0.5f + over / (0.6f + 0.05f * run), 0.0f, 1.0f));
    if (with_crowns && wood > 0.2f && over < kCrownReach) crowns += 0.22f * wood * (over < 1 ? 0.3f : 1.0f);
  }
  return std::max(lit - std::min(crowns, 0.75f), 0.0f);
}

}  // namespace

LandFinish land_finish(glm::vec3 normal, glm::vec3 paint, float ambient) {
  LandFinish finish;
  for (int i = 0; i < 3; ++i) {
    finish.normal[static_cast<std::size_t>(i)] = static_cast<std::int8_t>(std::lround(127 * normal[i]));
    finish.paint[static_cast<std::size_t>(i)] = byte_of(std::sqrt(std::max(paint[i], 0.0f)));
  }
  finish.paint[3] = byte_of(ambient);
  return finish;
}

void VertexRect::add(int x, int z) {
  x0 = std::min(x0, x), z0 = std::min(z0, z), x1 = std::max(x1, x), z1 = std::max(z1, z);
}
void VertexRect::add(const VertexRect& other) {
  if (other.empty()) return;
  add(other.x0, other.z0);
  add(other.x1, other.z1);
}
VertexRect VertexRect::within(const VertexRect& other) const {
  return {std::max(x0, other.x0), std::max(z0, other.z0), std::min(x1, other.x1), std::min(z1, other.z1)};
}

std::size_t LandField::at(int x, int z) const {
  return static_cast<std::size_t>(std::clamp(z, 0, across) * side() + std::clamp(x, 0, across));
}

VertexRect LandMesh::rect_of(std::size_t patch) const {
  const int tiles = field_.across / kPatchCells, i = static_cast<int>(patch);
  const int x = i % tiles * kPatchCells, z = i / tiles * kPatchCells;
  return {x, z, x + kPatchCells, z + kPatchCells};
}

std::pair<const LandPatch*, std::size_t> LandMesh::nearest(double x, double z) const {
  const auto vertex = [&](double v) {
    return std::clamp(static_cast<int>(std::floor(v / world::kGroundCell + 0.5)) + field_.across / 2, 0, field_.across);
  };
  const int column = vertex(x), row = vertex(z), tiles = field_.across / kPatchCells;
  const int px = std::min(column / kPatchCells, tiles - 1), pz = std::min(row / kPatchCells, tiles - 1);
  return {&patches_[static_cast<std::size_t>(pz * tiles + px)],
          static_cast<std::size_t>((row - pz * kPatchCells) * LandPatch::kSide + column - px * kPatchCells)};
}

LandLight LandMesh::light_at(double x, double z) const {
  if (patches_.empty()) return {};
  const auto [patch, vertex] = nearest(x, z);
  return patch->light[vertex];
}

const LandFinish& LandMesh::finish_at(double x, double z) const {
  const auto [patch, vertex] = nearest(x, z);
  return patch->finish[vertex];
}

glm::vec3 LandMesh::place(std::size_t patch, std::size_t vertex) const {
  const VertexRect rect = rect_of(patch);
  const int x = rect.x0 + static_cast<int>(vertex) % LandPatch::kSide,
            z = rect.z0 + static_cast<int>(vertex) / LandPatch::kSide;
  const glm::vec2 at = kCellSide * (glm::vec2(x, z) - field_.half());
  return {at.x, field_.height(x, z), at.y};
}

std::vector<LandVertex> LandMesh::vertices(std::size_t patch) const {
  std::vector<LandVertex> made;
  for (const LandFinish& finish : patches_[patch].finish) made.push_back({place(patch, made.size()), finish});
  return made;
}

std::vector<std::uint16_t> LandMesh::triangles(std::size_t patch) const {
  const VertexRect rect = rect_of(patch);
  std::vector<std::uint16_t> indices;
  auto open = patches_[patch].open.begin();
  for (int z = 0; z < kPatchCells; ++z) {
    for (int x = 0; x < kPatchCells; ++x) {
      if (open != patches_[patch].open.end() && *open == z * kPatchCells + x) {
        ++open;
        continue;
      }
      const auto a = static_cast<std::uint16_t>(z * LandPatch::kSide + x);
      const auto b = static_cast<std::uint16_t>(a + 1), c = static_cast<std::uint16_t>(a + LandPatch::kSide),
                 d = static_cast<std::uint16_t>(c + 1);
      const auto height = [&](int dx, int dz) { return field_.height(rect.x0 + x + dx, rect.z0 + z + dz); };
      if (std::fabs(height(0, 0) - height(1, 1)) <= std::fabs(height(1, 0) - height(0, 1)))
        indices.insert(indices.end(), {a, c, d, a, d, b});
      else indices.insert(indices.end(), {a, c, b, b, c, d});
    }
  }
  return indices;
}

float LandMesh::sun_over(glm::vec3 place) const {
  if (!sun_shines_ || patches_.empty()) return 1;
  const glm::vec3 from(place.x / kCellSide + field_.half(), place.y, place.z / kCellSide + field_.half());
  return sunlight(field_, from, sun_, highest_, false);
}

void LandMesh::reset(const Ground& ground) {
  field_.across = ground.tiles_across() * kPatchCells;
  const auto all = static_cast<std::size_t>(field_.side() * field_.side());
  field_.heights.assign(all, 0);
  field_.wood.assign(all, 0);
  field_.earth.assign(all, 0);
  patches_.assign(ground.patches().size(), {});
  constexpr std::size_t kVertices = std::size_t{LandPatch::kSide} * LandPatch::kSide;
  for (std::size_t i = 0; i < patches_.size(); ++i) {
    patches_[i].corner = ground.patches()[i].corner();
    patches_[i].finish.resize(kVertices);
    patches_[i].light.resize(kVertices);
  }
  keys_.assign(patches_.size(), {});
  lamp_keys_.assign(patches_.size(), 0);
  lamps_.clear();
  stale_.assign(patches_.size(), {});
  for (std::size_t i = 0; i < patches_.size(); ++i) stale_[i] = {rect_of(i), true, true};
  reset_ = ++build_;
}

// What each patch depends on, besides the heights of its neighbours.
std::vector<LandMesh::Key> LandMesh::keys_of(const Ground& ground, const Plants* plants) const {
  std::vector<Key> keys(patches_.size());
  const auto mark = [&](glm::dvec3 at, double reach, glm::dvec3 value) {
    ground.each_patch_near(at, reach, [&](std::size_t i) { keys[i].track = mixed_key(keys[i].track, value); });
  };
  for (const TrackSample& sample : ground.samples())
    if (!sample.tunnel) mark(sample.at, kEarthReach, sample.at);
  for (const TunnelGate& gate : ground.gates())
    mark(gate.at, 10, gate.at + glm::dvec3(gate.inwards.x, 1, gate.inwards.y));
  for (std::size_t i = 0; i < keys.size(); ++i) {
    keys[i].ground = ground.patches()[i].build;
    if (plants == nullptr) continue;
    ground.each_patch_around(i,
                             [&](std::size_t k) { keys[i].plants = mixed_key(keys[i].plants, plants->build_of(k)); });
  }
  return keys;
}

// Copies a patch's heights to the field and returns where they differ.
VertexRect LandMesh::take_heights(const GroundPatch& patch, const VertexRect& rect) {
  VertexRect changed;
  for (int z = rect.z0; z <= rect.z1; ++z) {
    for (int x = rect.x0; x <= rect.x1; ++x) {
      float& held = field_.heights[field_.at(x, z)];
      const float height = patch.height(x - rect.x0, z - rect.z0);
      if (held != height) changed.add(x, z);
      held = height;
    }
  }
  return changed;
}

// Finds the shade of crowns and earth under low track for a patch, and returns where they differ.
VertexRect LandMesh::take_cover(const Ground& ground, const Plants* plants, std::size_t patch) {
  constexpr int kSide = LandPatch::kSide;
  const VertexRect rect = rect_of(patch);
  std::array<float, std::size_t{kSide} * kSide> wood{}, earth{};
  const glm::vec2 corner = kCellSide * (glm::vec2(rect.x0, rect.z0) - field_.half());
  const auto near = [&](glm::vec2 at, float reach, auto&& visit) {
    const glm::vec2 from = (at - reach - corner) / kCellSide, to = (at + reach - corner) / kCellSide;
    for (int z = std::max(static_cast<int>(std::ceil(from.y)), 0);
         z <= std::min(static_cast<int>(to.y), kPatchCells) && to.y >= 0; ++z)
      for (int x = std::max(static_cast<int>(std::ceil(from.x)), 0);
           x <= std::min(static_cast<int>(to.x), kPatchCells) && to.x >= 0; ++x)
        visit(static_cast<std::size_t>(z * kSide + x), corner + kCellSide * glm::vec2(x, z));
  };
  const auto shade = [&](const Plant& plant) {
    if (plant.kind == PlantKind::rock) return;
    const bool tree = plant.kind != PlantKind::bush;
    const float reach = (tree ? 4.5f : 2.0f) * plant.size, much = tree ? 0.55f : 0.4f;
    const glm::vec2 foot(plant.foot.x, plant.foot.z);
    near(foot, reach,
         [&](std::size_t i, glm::vec2 at) { wood[i] += much * (1 - smooth(1, reach, glm::distance(at, foot))); });
  };
  if (plants != nullptr)
    ground.each_patch_around(patch, [&](std::size_t i) { std::ranges::for_each(plants->of(i), shade); });
  const std::uint32_t seed = park_.seed + kEarthNoise;
  for (const TrackSample& sample : ground.samples()) {
    if (sample.tunnel) continue;
    const glm::vec2 foot(static_cast<float>(sample.at.x), static_cast<float>(sample.at.z));
    near(foot, static_cast<float>(kEarthReach), [&](std::size_t i, glm::vec2 at) {
      const float height = field_.height(rect.x0 + static_cast<int>(i) % kSide, rect.z0 + static_cast<int>(i) / kSide);
      const float uneven = 0.8f * static_cast<float>(noise(double{at.x} / 3, double{at.y} / 3, seed));
      const float away =
          glm::distance(at, foot) + uneven + 4 * smooth(3, 8, static_cast<float>(sample.at.y) - 2 - height);
      earth[i] = std::max(earth[i], 1 - smooth(1.6f, 3.4f, away));
    });
  }
  VertexRect changed;
  for (int z = rect.z0; z <= rect.z1; ++z) {
    for (int x = rect.x0; x <= rect.x1; ++x) {
      const auto i = static_cast<std::size_t>((z - rect.z0) * kSide + x - rect.x0);
      const std::size_t at = field_.at(x, z);
      const std::uint8_t shaded = byte_of(wood[i]), bare = byte_of(earth[i]);
      if (shaded != field_.wood[at] || bare != field_.earth[at]) changed.add(x, z);
      field_.wood[at] = shaded, field_.earth[at] = bare;
    }
  }
  return changed;
}

// Marks vertices that must be computed again.
void LandMesh::mark(const VertexRect& rect) {
  for (std::size_t i = 0; i < patches_.size(); ++i) stale_[i].vertices.add(rect.within(rect_of(i)));
}

// Marks the patches whose sunlight may have changed with what is within the rectangle, up to `above` m over the lowest
// land.
void LandMesh::mark_shaded(const VertexRect& rect, float above) {
  if (rect.empty() || !sun_shines_) return;
  const float level = std::sqrt(sun_.x * sun_.x + sun_.z * sun_.z);
  VertexRect shaded = rect.grown(2);
  if (level > 1e-3f) {
    const float length = std::min(above * level / std::max(sun_.y, 1e-3f), kSunReach) / kCellSide;
    const int x = static_cast<int>(-sun_.x / level * length), z = static_cast<int>(-sun_.z / level * length);
    shaded.add(VertexRect{rect.x0 + x, rect.z0 + z, rect.x1 + x, rect.z1 + z}.grown(2));
  }
  for (std::size_t i = 0; i < patches_.size(); ++i)
    if (!shaded.within(rect_of(i)).empty()) stale_[i].light = true;
}

void LandMesh::mark_lamps(std::span<const Lamp> lamps) {
  if (std::ranges::equal(lamps, lamps_)) return;
  lamps_.assign(lamps.begin(), lamps.end());
  for (std::size_t i = 0; i < patches_.size(); ++i) {
    const VertexRect rect = rect_of(i);
    const glm::vec2 low = kCellSide * (glm::vec2(rect.x0, rect.z0) - field_.half()) - kLampReach,
                    high = kCellSide * (glm::vec2(rect.x1, rect.z1) - field_.half()) + kLampReach;
    std::uint64_t key = 0;
    for (const Lamp& lamp : lamps)
      if (lamp.at.x > low.x && lamp.at.x < high.x && lamp.at.z > low.y && lamp.at.z < high.y)
        key = mixed_key(key, glm::dvec3(lamp.at) + double{lamp.strength});
    if (std::exchange(lamp_keys_[i], key) != key) stale_[i].light = true;
  }
}

void LandMesh::build(const Ground& ground, std::size_t patch) {
  const VertexRect all = rect_of(patch), rect = stale_[patch].vertices;
  LandPatch& made = patches_[patch];
  for (int z = rect.z0; z <= rect.z1; ++z) {
    for (int x = rect.x0; x <= rect.x1; ++x) {
      const std::size_t at = field_.at(x, z);
      const float height = field_.heights[at], wood = static_cast<float>(field_.wood[at]) / 255;
      const glm::vec3 normal =
          glm::normalize(glm::vec3(field_.height(x - 1, z) - field_.height(x + 1, z), 2 * kCellSide,
                                   field_.height(x, z - 1) - field_.height(x, z + 1)));
      const auto vertex = static_cast<std::size_t>((z - all.z0) * LandPatch::kSide + x - all.x0);
      const glm::vec3 at_vertex = place(patch, vertex);
      const glm::vec3 paint = land_paint(park_, {double{at_vertex.x}, double{at_vertex.z}, height, normal.y, wood,
                                                 static_cast<float>(field_.earth[at]) / 255});
      made.finish[vertex] = land_finish(normal, paint, (0.30f + 0.70f * open_sky(field_, x, z)) * (1 - 0.35f * wood));
    }
  }
  made.low = ground.patches()[patch].low, made.high = ground.patches()[patch].high;
  if (!stale_[patch].open) return;
  made.open.clear();
  for (int z = 0; z < kPatchCells; ++z) {
    for (int x = 0; x < kPatchCells; ++x) {
      const int column = all.x0 + x - field_.across / 2, row = all.z0 + z - field_.across / 2;
      if (is_open(ground, {column, row})) made.open.push_back(static_cast<std::uint16_t>(z * kPatchCells + x));
    }
  }
}

void LandMesh::bake(std::size_t patch) {
  const VertexRect all = rect_of(patch);
  LandPatch& made = patches_[patch];
  std::vector<const Lamp*> near;
  const glm::vec2 middle = kCellSide * (0.5f * glm::vec2(all.x0 + all.x1, all.z0 + all.z1) - field_.half());
  for (const Lamp& lamp : lamps_)
    if (glm::all(glm::lessThan(glm::abs(glm::vec2(lamp.at.x, lamp.at.z) - middle),
                               glm::vec2(kLampReach + 0.5f * kCellSide * kPatchCells))))
      near.push_back(&lamp);
  for (int z = all.z0; z <= all.z1; ++z) {
    for (int x = all.x0; x <= all.x1; ++x) {
      const auto i = static_cast<std::size_t>((z - all.z0) * LandPatch::kSide + x - all.x0);
      LandLight& light = made.light[i];
      light.sun =
          sun_shines_ ? byte_of(sunlight(field_, {x, field_.height(x, z) + 0.2f, z}, sun_, highest_, true)) : 255;
      float sum = 0;
      const std::array<std::int8_t, 4>& n = made.finish[i].normal;
      const glm::vec3 normal = glm::vec3(n[0], n[1], n[2]) / 127.0f;
      for (const Lamp* lamp : near) sum += lamp_light(*lamp, place(patch, i), normal);
      light.lamp = byte_of(0.5f * sum);
    }
  }
}

void LandMesh::update(const Ground& ground, const Plants* plants, glm::vec3 sun, bool sun_shines,
                      std::span<const Lamp> lamps) {
  const world::Park& park = ground.land().park();
  const bool other = park.land != park_.land || park.seed != park_.seed || park.water != park_.water;
  if (other || field_.across != ground.tiles_across() * kPatchCells) park_ = park, reset(ground);
  if (sun != sun_ || sun_shines != sun_shines_) {
    sun_ = sun, sun_shines_ = sun_shines;
    for (Stale& stale : stale_) stale.light = true;
  }
  // First what lies on the field, then what follows from it.
  const std::vector<Key> keys = keys_of(ground, plants);
  std::vector<std::pair<VertexRect, float>> shaded;
  for (std::size_t i = 0; i < patches_.size(); ++i) {
    if (keys[i] == keys_[i]) continue;
    if (keys[i].ground != keys_[i].ground || keys[i].track != keys_[i].track) stale_[i].open = true;
    const float above = std::max(patches_[i].high, ground.patches()[i].high);
    const VertexRect moved = take_heights(ground.patches()[i], rect_of(i)), covered = take_cover(ground, plants, i);
    keys_[i] = keys[i];
    mark(moved.grown(kSkyReach));
    mark(covered);
    if (!moved.empty()) shaded.emplace_back(moved, above);
    if (!covered.empty()) shaded.emplace_back(covered, above + kCrownReach);
  }
  lowest_ = highest_ = 0;
  for (const GroundPatch& patch : ground.patches())
    lowest_ = std::min(lowest_, patch.low), highest_ = std::max(highest_, patch.high);
  for (const auto& [rect, above] : shaded) mark_shaded(rect, above - lowest_);
  mark_lamps(lamps);
  std::vector<std::size_t> work;
  for (std::size_t i = 0; i < patches_.size(); ++i)
    if (!stale_[i].vertices.empty() || stale_[i].open || stale_[i].light) work.push_back(i);
  if (work.empty()) return;
  ++build_;
  base::in_parts(work.size(), 1, base::cores(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      const std::size_t i = work[k];
      if (!stale_[i].vertices.empty() || stale_[i].open) build(ground, i), patches_[i].build = build_;
      if (stale_[i].light || !stale_[i].vertices.empty()) bake(i), patches_[i].light_build = build_;
      stale_[i] = {};
    }
  });
}

}  // namespace coaster::sim
