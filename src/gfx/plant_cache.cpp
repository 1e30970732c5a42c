#include "gfx/plant_cache.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace coaster::gfx {
namespace {

constexpr auto kTile = static_cast<float>(sim::GroundPatch::kLength);
constexpr float kMostSunk = 8;     // m, as in shaders/park_plant.vert
constexpr float kCrownMiddle = 5;  // m over the foot

// Returns the height of a patch's land as it is drawn in cells of 8 m.
float coarse_height(const sim::LandMesh& land, std::size_t patch, glm::vec3 at) {
  constexpr int kStep = 4;
  constexpr auto kCell = static_cast<float>(kStep * world::kGroundCell);
  const glm::vec2 from = (glm::vec2(at.x, at.z) - land.patches()[patch].corner) / kCell;
  constexpr int kLast = world::kGroundTileCells / kStep - 1;
  const int x = std::clamp(static_cast<int>(from.x), 0, kLast), z = std::clamp(static_cast<int>(from.y), 0, kLast);
  const auto height = [&](int dx, int dz) {
    return land.place(patch, static_cast<std::size_t>((z + dz) * kStep * sim::LandPatch::kSide + (x + dx) * kStep)).y;
  };
  const glm::vec2 t = from - glm::vec2(x, z);
  return std::min(glm::mix(glm::mix(height(0, 0), height(1, 0), t.x), glm::mix(height(0, 1), height(1, 1), t.x), t.y),
                  glm::mix(0.5f * (height(0, 0) + height(1, 1)), 0.5f * (height(1, 0) + height(0, 1)), 0.5f));
}

}  // namespace

PlantCache::PlantCache(const Gl& gl) : gl_(&gl), vertices_(gl), indices_(gl), instances_(gl), grass_(gl) {}

std::int64_t PlantCache::sync(const sim::Plants& plants, const sim::LandMesh& land) {
  if (array_.id() == 0) {
    std::vector<sim::LandVertex> vertices;
    std::vector<std::uint16_t> indices;
    const auto add = [&](const sim::PlantModel& model) {
      const Range range{static_cast<std::uint32_t>(indices.size()), static_cast<std::uint32_t>(model.indices.size())};
      for (const std::uint16_t index : model.indices)
        indices.push_back(static_cast<std::uint16_t>(vertices.size() + index));
      vertices.insert(vertices.end(), model.vertices.begin(), model.vertices.end());
      return range;
    };
    for (std::size_t kind = 0; kind < sim::kPlantKinds; ++kind)
      for (std::size_t level = 0; level < sim::kPlantLevels; ++level)
        models_[kind][level] =
            add(sim::plant_model(static_cast<sim::PlantKind>(kind), static_cast<sim::PlantLevel>(level)));
    for (std::size_t kind = 0; kind < sim::kMeadowKinds; ++kind) meadow_[kind] = add(sim::meadow_model(kind));
    vertices_.fill(vertices);
    indices_.fill(indices);
    array_ = make_vertex_array(*gl_);
    gl_->BindVertexArray(array_.id());
    land_attributes(*gl_, vertices_.id());
    gl_->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
    gl_->BindVertexArray(0);
  }
  if (held_.size() != plants.patches()) held_.clear(), held_.resize(plants.patches());
  instances_.reserve(held_.size() * kMost);
  std::int64_t bytes = 0;
  for (std::size_t i = 0; i < held_.size(); ++i) {
    const std::uint64_t light = land.patches()[i].light_build;
    if (held_[i].plants == plants.build_of(i) && held_[i].light == light) continue;
    if (held_[i].plants != plants.build_of(i)) ++version_;
    held_[i].plants = plants.build_of(i), held_[i].light = light;
    write(i, plants.of(i), land);
    bytes += static_cast<std::int64_t>(std::min(plants.of(i).size(), kMost) * sizeof(Instance));
  }
  return bytes;
}

void PlantCache::write(std::size_t patch, std::span<const sim::Plant> plants, const sim::LandMesh& land) {
  Held& held = held_[patch];
  held.box = box_of(land.patches()[patch], kPlantHeight);
  const auto group_of = [&](const sim::Plant& plant) {
    const glm::vec3 from = static_cast<float>(kGroups) / kTile * (plant.foot - held.box.low);
    return static_cast<std::size_t>(std::clamp(static_cast<int>(from.z), 0, kGroups - 1) * kGroups +
                                    std::clamp(static_cast<int>(from.x), 0, kGroups - 1));
  };
  std::vector<const sim::Plant*> sorted;
  for (const sim::Plant& plant : plants.first(std::min(plants.size(), kMost))) sorted.push_back(&plant);
  std::ranges::stable_sort(sorted, {}, [&](const sim::Plant* plant) {
    return static_cast<std::size_t>(plant->kind) * kAllGroups + group_of(*plant);
  });
  std::vector<Instance> instances;
  std::size_t next = 0;
  for (std::size_t kind = 0; kind < sim::kPlantKinds; ++kind) {
    for (std::size_t group = 0; group < kAllGroups; ++group) {
      held.begins[kind][group] = static_cast<std::uint16_t>(next);
      while (next < sorted.size() && static_cast<std::size_t>(sorted[next]->kind) == kind &&
             group_of(*sorted[next]) == group) {
        const sim::Plant& plant = *sorted[next++];
        const bool tree = plant.kind == sim::PlantKind::conifer || plant.kind == sim::PlantKind::broadleaf;
        const sim::LandLight there = land.light_at(double{plant.foot.x}, double{plant.foot.z});
        const float sun = land.sun_over(plant.foot + glm::vec3(0, tree ? kCrownMiddle * plant.size : 0.5f, 0));
        Instance& made = instances.emplace_back();
        made.foot = plant.foot, made.size = plant.size;
        made.turn = {static_cast<std::int8_t>(std::lround(127 * plant.turn.x)),
                     static_cast<std::int8_t>(std::lround(127 * plant.turn.y)), 0, 0};
        made.look = {sim::byte_of(plant.tint), sim::byte_of(sun), there.lamp,
                     sim::byte_of((plant.foot.y - coarse_height(land, patch, plant.foot)) / kMostSunk)};
      }
    }
    held.begins[kind][kAllGroups] = static_cast<std::uint16_t>(next);
  }
  instances_.write(patch * kMost, instances);
}

// Takes instances from `first` on from the bound buffer.
void PlantCache::link(std::size_t first) const {
  const std::size_t offset = first * sizeof(Instance);
  float_attribute(*gl_, 4, 4, sizeof(Instance), offset, 1);
  byte_attribute(*gl_, 5, 2, GL_BYTE, sizeof(Instance), offset + offsetof(Instance, turn), 1);
  byte_attribute(*gl_, 6, 4, GL_UNSIGNED_BYTE, sizeof(Instance), offset + offsetof(Instance, look), 1);
}

// Draws neighbours of one kind at a level.
void PlantCache::draw_run(std::size_t patch, std::size_t kind, sim::PlantLevel level, std::size_t begin,
                          std::size_t end, bool unseen, Drawn& drawn) const {
  if (begin >= end) return;
  const Range& model = models_[kind][static_cast<std::size_t>(level)];
  ++drawn.draw_calls;
  drawn.triangles += std::int64_t{model.size / 3} * static_cast<std::int64_t>(end - begin);
  if (unseen) return;
  link(patch * kMost + begin);
  gl_->DrawElementsInstanced(GL_TRIANGLES, GLsizei(model.size), GL_UNSIGNED_SHORT,
                             reinterpret_cast<const void*>(std::size_t{model.first} * sizeof(std::uint16_t)),
                             GLsizei(end - begin));
}

PlantCache::Drawn PlantCache::draw(std::size_t patch, glm::vec3 eye, float near, bool unseen) const {
  Drawn drawn;
  const Held& held = held_[patch];
  if (!unseen) {
    gl_->BindVertexArray(array_.id());
    gl_->BindBuffer(GL_ARRAY_BUFFER, instances_.id());
  }
  std::array<float, kAllGroups> metres{};
  const glm::vec3 side = (held.box.high - held.box.low) / static_cast<float>(kGroups);
  for (std::size_t group = 0; group < kAllGroups; ++group) {
    Box box = held.box;
    box.low.x += side.x * static_cast<float>(group % kGroups), box.high.x = box.low.x + side.x;
    box.low.z += side.z * static_cast<float>(group / kGroups), box.high.z = box.low.z + side.z;
    metres[group] = distance_to(box, eye);
  }
  for (std::size_t kind = 0; kind < sim::kPlantKinds; ++kind) {
    const bool tree = kind <= static_cast<std::size_t>(sim::PlantKind::broadleaf);
    const float reach = tree ? sim::kPlantReach.back() : sim::kUndergrowthReach;
    std::size_t group = 0;
    while (group < kAllGroups) {
      if (metres[group] > reach) {
        ++group;
        continue;
      }
      const sim::PlantLevel level = sim::plant_level(metres[group] / near);
      std::size_t end = group;
      while (end < kAllGroups && metres[end] <= reach && sim::plant_level(metres[end] / near) == level) ++end;
      draw_run(patch, kind, level, held.begins[kind][group], held.begins[kind][end], unseen, drawn);
      group = end;
    }
  }
  return drawn;
}

PlantCache::Drawn PlantCache::draw_grass(const sim::LandMesh& land, const sim::Ground& ground,
                                         const glm::mat4& view_projection, glm::vec3 eye, bool unseen) {
  std::array<std::vector<Instance>, sim::kMeadowKinds> kinds;
  for (const sim::MeadowPlant& plant : sim::meadow_around(land, ground, eye)) {
    const glm::vec4 at = view_projection * glm::vec4(plant.foot, 1);
    if (at.w < -1 || std::fabs(at.x) > at.w + 1 || std::fabs(at.y) > at.w + 1) continue;
    const sim::LandLight light = land.light_at(double{plant.foot.x}, double{plant.foot.z});
    Instance& made = kinds[plant.kind].emplace_back();
    made.foot = plant.foot, made.size = plant.size;
    made.turn = {static_cast<std::int8_t>(std::lround(127 * plant.turn.x)),
                 static_cast<std::int8_t>(std::lround(127 * plant.turn.y)), 0, 0};
    made.look = {sim::byte_of(plant.tint), light.sun, light.lamp, 0};
  }
  std::vector<Instance> all;
  for (const std::vector<Instance>& kind : kinds) all.insert(all.end(), kind.begin(), kind.end());
  grass_.fill(all);
  Drawn drawn;
  std::size_t first = 0;
  for (std::size_t kind = 0; kind < kinds.size(); first += kinds[kind++].size()) {
    if (kinds[kind].empty()) continue;
    ++drawn.draw_calls;
    drawn.triangles += std::int64_t{meadow_[kind].size / 3} * static_cast<std::int64_t>(kinds[kind].size());
    if (unseen) continue;
    gl_->BindVertexArray(array_.id());
    gl_->BindBuffer(GL_ARRAY_BUFFER, grass_.id());
    link(first);
    gl_->DrawElementsInstanced(GL_TRIANGLES, GLsizei(meadow_[kind].size), GL_UNSIGNED_SHORT,
                               reinterpret_cast<const void*>(std::size_t{meadow_[kind].first} * sizeof(std::uint16_t)),
                               GLsizei(kinds[kind].size()));
  }
  return drawn;
}

PlantCache::Drawn PlantCache::cast(const glm::mat4& light, bool unseen) const {
  Drawn drawn;
  if (!unseen && !held_.empty()) {
    gl_->BindVertexArray(array_.id());
    gl_->BindBuffer(GL_ARRAY_BUFFER, instances_.id());
  }
  for (std::size_t patch = 0; patch < held_.size(); ++patch) {
    if (!may_show(light, held_[patch].box)) continue;
    for (std::size_t kind = 0; kind < sim::kPlantKinds; ++kind)
      draw_run(patch, kind, sim::PlantLevel::far, held_[patch].begins[kind][0], held_[patch].begins[kind][kAllGroups],
               unseen, drawn);
  }
  return drawn;
}

}  // namespace coaster::gfx
