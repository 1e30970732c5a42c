#include "gfx/plant_cache.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace coaster::gfx {
namespace {

constexpr float kTile = static_cast<float>(world::kGroundTileCells * world::kGroundCell);  // m
constexpr float kCrownMiddle = 5;                                                          // m over the foot

void byte_attribute(const Gl& gl, GLuint location, int components, GLenum type, std::size_t stride, std::size_t offset,
                    GLuint divisor) {
  gl.EnableVertexAttribArray(location);
  gl.VertexAttribPointer(location, components, type, GL_TRUE, GLsizei(stride), reinterpret_cast<const void*>(offset));
  gl.VertexAttribDivisor(location, divisor);
}

}  // namespace

PlantCache::PlantCache(const Gl& gl) : gl_(&gl), vertices_(gl), indices_(gl), instances_(gl) {}

std::int64_t PlantCache::sync(const sim::Plants& plants, const sim::LandMesh& land) {
  if (array_.id() == 0) {
    std::vector<sim::LandVertex> vertices;
    std::vector<std::uint16_t> indices;
    for (std::size_t kind = 0; kind < sim::kPlantKinds; ++kind) {
      for (std::size_t level = 0; level < sim::kPlantLevels; ++level) {
        const sim::PlantModel model =
            sim::plant_model(static_cast<sim::PlantKind>(kind), static_cast<sim::PlantLevel>(level));
        models_[kind][level] = {static_cast<std::uint32_t>(indices.size()),
                                static_cast<std::uint32_t>(model.indices.size())};
        for (const std::uint16_t index : model.indices)
          indices.push_back(static_cast<std::uint16_t>(vertices.size() + index));
        vertices.insert(vertices.end(), model.vertices.begin(), model.vertices.end());
      }
    }
    vertices_.fill(vertices);
    indices_.fill(indices);
    array_ = make_vertex_array(*gl_);
    gl_->BindVertexArray(array_.id());
    gl_->BindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    float_attribute(*gl_, 0, 3, sizeof(sim::LandVertex), 0);
    byte_attribute(*gl_, 1, 4, GL_BYTE, sizeof(sim::LandVertex), offsetof(sim::LandVertex, normal), 0);
    byte_attribute(*gl_, 2, 4, GL_UNSIGNED_BYTE, sizeof(sim::LandVertex), offsetof(sim::LandVertex, paint), 0);
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
  const sim::LandPatch& ground = land.patches()[patch];
  held.box = {ground.vertices.front().position, ground.vertices.back().position};
  held.box.low.y = ground.low, held.box.high.y = ground.high + kPlantHeight;
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
        made.look = {sim::byte_of(plant.tint), sim::byte_of(sun), there.lamp, 0};
      }
    }
    held.begins[kind][kAllGroups] = static_cast<std::uint16_t>(next);
  }
  instances_.write(patch * kMost, instances);
}

// Draws neighbours of one kind at a level.
void PlantCache::draw_run(std::size_t patch, std::size_t kind, sim::PlantLevel level, std::size_t begin,
                          std::size_t end, bool unseen, Drawn& drawn) const {
  if (begin >= end) return;
  const Range& model = models_[kind][static_cast<std::size_t>(level)];
  ++drawn.draw_calls;
  drawn.triangles += std::int64_t{model.size / 3} * static_cast<std::int64_t>(end - begin);
  if (unseen) return;
  const std::size_t offset = (patch * kMost + begin) * sizeof(Instance);
  float_attribute(*gl_, 4, 4, sizeof(Instance), offset, 1);
  byte_attribute(*gl_, 5, 2, GL_BYTE, sizeof(Instance), offset + offsetof(Instance, turn), 1);
  byte_attribute(*gl_, 6, 3, GL_UNSIGNED_BYTE, sizeof(Instance), offset + offsetof(Instance, look), 1);
  gl_->DrawElementsInstanced(GL_TRIANGLES, GLsizei(model.size), GL_UNSIGNED_SHORT,
                             reinterpret_cast<const void*>(std::size_t{model.first} * sizeof(std::uint16_t)),
                             GLsizei(end - begin));
}

PlantCache::Drawn PlantCache::draw(std::size_t patch, glm::vec3 eye, bool unseen) const {
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
      const sim::PlantLevel level = sim::plant_level(metres[group]);
      std::size_t end = group;
      while (end < kAllGroups && metres[end] <= reach && sim::plant_level(metres[end]) == level) ++end;
      draw_run(patch, kind, level, held.begins[kind][group], held.begins[kind][end], unseen, drawn);
      group = end;
    }
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
