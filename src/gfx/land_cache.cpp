#include "gfx/land_cache.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>

#include "sim/ground/land_paint.h"

namespace coaster::gfx {
namespace {

constexpr float kFine = 120, kMiddling = 260;  // m up to which steps are 1 and 2
constexpr GLuint kLift = 4, kCorner = 5;       // attributes of shaders/park_land.vert
constexpr int kSnap = 4;                       // cells between vertices of a snapped border

constexpr std::array<float, 9> kRings{1, 1.06f, 1.25f, 1.6f, 2.2f, 3.2f, 5, 9, kFarthestLand};
constexpr int kAroundSide = 48;  // vertices along a side of all rings but the first
constexpr int kBorder = 4;       // cells between the first ring's vertices

// Point i of n along side 0..3 of the square with corners at -1 and 1.
glm::vec2 on_side(int side, float along) {
  const float t = 2 * along - 1;
  switch (side) {
    case 0: return {t, -1};
    case 1: return {1, t};
    case 2: return {-t, 1};
    default: return {-1, -t};
  }
}

sim::LandVertex vertex_at(const sim::Ground& ground, glm::vec2 at, float height) {
  const world::Park& park = ground.land().park();
  const double x = double{at.x}, z = double{at.y}, e = 6;
  const sim::Land& land = ground.land();
  const glm::dvec3 slope(land.seeded(x - e, z) - land.seeded(x + e, z), 2 * e,
                         land.seeded(x, z - e) - land.seeded(x, z + e));
  const glm::vec3 normal(glm::normalize(slope));
  const float wood = sim::far_woods(park, x, z);
  const glm::vec3 paint = sim::land_paint(park, {x, z, height, normal.y, wood, 0});
  return {{at.x, height, at.y}, sim::land_finish(normal, paint, 0.94f * (1 - 0.35f * wood))};
}

constexpr std::size_t kPatchVertices = std::size_t{sim::LandPatch::kSide} * sim::LandPatch::kSide;
constexpr std::uint32_t kPatchIndices = 6 * world::kGroundTileCells * world::kGroundTileCells;
constexpr std::uint32_t kKeptSlots = 96;  // own triangles of so many patches are kept out of sight

// A patch with open cells has only its own triangles, and its neighbours are as fine.
bool has_own_triangles(const sim::LandMesh& mesh, const VisiblePatch& patch) {
  return (patch.step == 1 && patch.snapped == 0) || !mesh.patches()[patch.index].open.empty();
}

void finish_attributes(const Gl& gl, std::size_t stride, std::size_t offset) {
  byte_attribute(gl, 1, 4, GL_BYTE, stride, offset + offsetof(sim::LandFinish, normal));
  byte_attribute(gl, 2, 4, GL_UNSIGNED_BYTE, stride, offset + offsetof(sim::LandFinish, paint));
}

}  // namespace

bool may_show(const glm::mat4& m, const Box& box) {
  const auto row = [&](int i) { return glm::vec4(m[0][i], m[1][i], m[2][i], m[3][i]); };
  const glm::vec4 w = row(3);
  for (int i = 0; i < 3; ++i) {
    for (const float sign : {1.0f, -1.0f}) {
      const glm::vec4 plane = w + sign * row(i);
      // The corner farthest along the plane's normal.
      const glm::vec3 corner(plane.x > 0 ? box.high.x : box.low.x, plane.y > 0 ? box.high.y : box.low.y,
                             plane.z > 0 ? box.high.z : box.low.z);
      if (glm::dot(glm::vec3(plane), corner) + plane.w < 0) return false;
    }
  }
  return true;
}

float distance_to(const Box& box, glm::vec3 from) {
  return glm::length(glm::max(glm::max(box.low - from, from - box.high), glm::vec3(0)));
}

Box box_of(const sim::LandPatch& patch, float above) {
  constexpr auto kSide = static_cast<float>(sim::GroundPatch::kLength);
  return {{patch.corner.x, patch.low, patch.corner.y},
          {patch.corner.x + kSide, patch.high + above, patch.corner.y + kSide}};
}

std::vector<VisiblePatch> visible_patches(std::span<const sim::LandPatch> patches, const glm::mat4& view_projection,
                                          glm::vec3 eye, float near) {
  const int across = static_cast<int>(std::lround(std::sqrt(static_cast<double>(patches.size()))));
  std::vector<Box> boxes(patches.size());
  std::vector<std::uint8_t> steps(patches.size());
  for (std::size_t i = 0; i < patches.size(); ++i) {
    boxes[i] = box_of(patches[i], kPlantHeight);
    const float metres = distance_to(boxes[i], eye);
    steps[i] = metres < near * kFine ? 1 : metres < near * kMiddling ? 2 : 4;
  }
  // A patch with open cells has all its vertices, and so have its neighbours, whose borders it shares.
  const auto around = [&](std::size_t i, auto&& visit) {
    const int x = static_cast<int>(i) % across, z = static_cast<int>(i) / across;
    const std::array<std::array<int, 2>, 4> beside{{{x - 1, z}, {x + 1, z}, {x, z - 1}, {x, z + 1}}};
    for (int side = 0; side < 4; ++side) {
      const auto [column, row] = beside[static_cast<std::size_t>(side)];
      const bool inside = column >= 0 && row >= 0 && column < across && row < across;
      visit(side, inside ? &steps[static_cast<std::size_t>(row * across + column)] : nullptr);
    }
  };
  for (std::size_t i = 0; i < patches.size(); ++i) {
    if (patches[i].open.empty()) continue;
    steps[i] = 1;
    around(i, [](int, std::uint8_t* step) {
      if (step) *step = 1;
    });
  }
  std::vector<VisiblePatch> visible;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    if (!may_show(view_projection, boxes[i])) continue;
    VisiblePatch patch{i, distance_to(boxes[i], eye), steps[i], 0};
    around(i, [&](int side, const std::uint8_t* step) {
      if (steps[i] > 1 || step == nullptr || *step > 1) patch.snapped |= static_cast<std::uint8_t>(1 << side);
    });
    visible.push_back(patch);
  }
  std::ranges::sort(visible, [](const VisiblePatch& a, const VisiblePatch& b) {
    return a.metres != b.metres ? a.metres < b.metres : a.index < b.index;
  });
  return visible;
}

std::vector<std::uint16_t> patch_indices(int step, std::uint8_t snapped) {
  constexpr int kCells = world::kGroundTileCells;
  const auto vertex = [&](int x, int z) {
    const auto snap = [](int v) { return (v + kSnap / 2) / kSnap * kSnap; };
    const bool across = (x == 0 && (snapped & 1)) || (x == kCells && (snapped & 2)),
               along = (z == 0 && (snapped & 4)) || (z == kCells && (snapped & 8));
    if (across) z = snap(z);
    if (along) x = snap(x);
    return static_cast<std::uint16_t>(z * sim::LandPatch::kSide + x);
  };
  std::vector<std::uint16_t> indices;
  const auto add = [&](std::uint16_t a, std::uint16_t b, std::uint16_t c) {
    if (a != b && b != c && c != a) indices.insert(indices.end(), {a, b, c});
  };
  for (int z = 0; z < kCells; z += step) {
    for (int x = 0; x < kCells; x += step) {
      const std::uint16_t a = vertex(x, z), b = vertex(x + step, z), c = vertex(x, z + step),
                          d = vertex(x + step, z + step);
      // Diagonals by turns, so that slopes are not combed to one side.
      if ((x / step + z / step) % 2 == 0) add(a, c, d), add(a, d, b);
      else add(a, c, b), add(b, c, d);
    }
  }
  return indices;
}

FarLand far_land(const sim::Ground& ground, const sim::LandField& field) {
  FarLand far;
  const int first_side = field.across / kBorder;  // of the first ring
  const float half = 0.5f * static_cast<float>(field.across) * static_cast<float>(world::kGroundCell);
  std::vector<std::uint32_t> begins;
  for (std::size_t ring = 0; ring < kRings.size(); ++ring) {
    begins.push_back(static_cast<std::uint32_t>(far.vertices.size()));
    const int along = ring == 0 ? first_side : kAroundSide;
    for (int i = 0; i < 4 * along; ++i) {
      const glm::vec2 way = on_side(i / along, static_cast<float>(i % along) / static_cast<float>(along));
      const auto column = static_cast<int>(std::lround(0.5f * (way.x + 1) * static_cast<float>(field.across))),
                 row = static_cast<int>(std::lround(0.5f * (way.y + 1) * static_cast<float>(field.across)));
      // On the border exactly where the patches' vertices are.
      const auto cell = static_cast<float>(world::kGroundCell);
      const glm::vec2 at =
          ring == 0 ? glm::vec2(cell * static_cast<float>(column) - half, cell * static_cast<float>(row) - half)
                    : half * kRings[ring] * way;
      const float height =
          ring == 0 ? field.height(column, row) : static_cast<float>(ground.land().seeded(double{at.x}, double{at.y}));
      far.vertices.push_back(vertex_at(ground, at, height));
      far.low = std::min(far.low, height), far.high = std::max(far.high, height);
    }
  }
  for (int side = 0; side < 4; ++side) {
    far.sides[static_cast<std::size_t>(side)] = static_cast<std::uint32_t>(far.indices.size());
    for (std::size_t ring = 0; ring + 1 < kRings.size(); ++ring) {
      const int inner = ring == 0 ? first_side : kAroundSide, fan = inner / kAroundSide;
      const auto in = [&](int i) { return static_cast<std::uint16_t>(begins[ring] + std::uint32_t(i % (4 * inner))); };
      const auto out = [&](int i) {
        return static_cast<std::uint16_t>(begins[ring + 1] + std::uint32_t(i % (4 * kAroundSide)));
      };
      // A fan of the inner vertices to the nearer of two outer ones, and a triangle between the fans.
      for (int j = side * kAroundSide; j < (side + 1) * kAroundSide; ++j) {
        for (int i = 0; i < fan; ++i)
          far.indices.insert(far.indices.end(),
                             {in(j * fan + i), in(j * fan + i + 1), out(i < (fan + 1) / 2 ? j : j + 1)});
        far.indices.insert(far.indices.end(), {in(j * fan + (fan + 1) / 2), out(j + 1), out(j)});
      }
    }
  }
  far.sides[4] = static_cast<std::uint32_t>(far.indices.size());
  return far;
}

void byte_attribute(const Gl& gl, GLuint location, int components, GLenum type, std::size_t stride, std::size_t offset,
                    GLuint divisor) {
  gl.EnableVertexAttribArray(location);
  gl.VertexAttribPointer(location, components, type, GL_TRUE, GLsizei(stride), reinterpret_cast<const void*>(offset));
  gl.VertexAttribDivisor(location, divisor);
}

void land_attributes(const Gl& gl, GLuint buffer) {
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  float_attribute(gl, 0, 3, sizeof(sim::LandVertex), offsetof(sim::LandVertex, position));
  finish_attributes(gl, sizeof(sim::LandVertex), offsetof(sim::LandVertex, finish));
}

void no_corner(const Gl& gl) {
  gl.VertexAttrib4f(kLift, 0, 0, 0, 1);
  gl.VertexAttrib4f(kCorner, 0, 0, 0, 1);
}

void light_attribute(const Gl& gl, GLuint buffer, std::size_t first) {
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  byte_attribute(gl, 3, 2, GL_UNSIGNED_BYTE, sizeof(sim::LandLight), first * sizeof(sim::LandLight));
}

void LandCache::make_shared() {
  std::vector<std::uint16_t> all;
  const auto add = [&](int step, int snapped) {
    const std::vector<std::uint16_t> list = patch_indices(step, static_cast<std::uint8_t>(snapped));
    lists_[{step, snapped}] = {static_cast<std::uint32_t>(all.size()), static_cast<std::uint32_t>(list.size())};
    all.insert(all.end(), list.begin(), list.end());
  };
  for (int snapped = 1; snapped <= kAllSides; ++snapped) add(1, snapped);
  add(2, kAllSides);
  add(4, kAllSides);
  shared_.fill(all);
  std::vector<glm::vec3> grid;
  for (int z = 0; z < sim::LandPatch::kSide; ++z)
    for (int x = 0; x < sim::LandPatch::kSide; ++x)
      grid.push_back(static_cast<float>(world::kGroundCell) * glm::vec3(x, 0, z));
  grid_.fill(grid);
}

// Gives each patch an array of its own, after the buffers have moved.
void LandCache::link() {
  const Gl& gl = *gl_;
  for (std::size_t i = 0; i < held_.size(); ++i) {
    if (held_[i].array.id() == 0) held_[i].array = make_vertex_array(gl);
    gl.BindVertexArray(held_[i].array.id());
    const std::size_t first = i * kPatchVertices;
    gl.BindBuffer(GL_ARRAY_BUFFER, grid_.id());
    float_attribute(gl, 0, 3, sizeof(glm::vec3), 0);
    gl.BindBuffer(GL_ARRAY_BUFFER, heights_.id());
    float_attribute(gl, kLift, 1, sizeof(float), first * sizeof(float));
    gl.BindBuffer(GL_ARRAY_BUFFER, finish_.id());
    finish_attributes(gl, sizeof(sim::LandFinish), first * sizeof(sim::LandFinish));
    light_attribute(gl, light_.id(), first);
  }
  gl.BindVertexArray(0);
}

LandCache::UploadStats LandCache::sync(const sim::Ground& ground, const sim::LandMesh& mesh) {
  UploadStats stats;
  const std::span<const sim::LandPatch> patches = mesh.patches();
  if (lists_.empty()) make_shared();
  if (reset_ != mesh.reset_build() || held_.size() != patches.size()) {
    reset_ = mesh.reset_build();
    held_.clear();
    held_.resize(patches.size());
    slots_ = {};
    heights_.reserve(patches.size() * kPatchVertices);
    finish_.reserve(patches.size() * kPatchVertices);
    light_.reserve(patches.size() * kPatchVertices);
    link();
  }
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const sim::LandPatch& patch = patches[i];
    Held& held = held_[i];
    if (held.light_build != patch.light_build) {
      held.light_build = patch.light_build;
      light_.write(i * kPatchVertices, patch.light);
      stats.bytes += static_cast<std::int64_t>(patch.light.size() * sizeof(sim::LandLight));
    }
    if (held.build == patch.build) continue;
    held.build = patch.build;
    heights_.write(i * kPatchVertices, ground.patches()[i].heights);
    finish_.write(i * kPatchVertices, patch.finish);
    ++stats.patches;
    stats.bytes += static_cast<std::int64_t>(kPatchVertices * (sizeof(float) + sizeof(sim::LandFinish)));
  }
  sync_far(ground, mesh, stats);
  return stats;
}

std::int64_t LandCache::prepare(const sim::LandMesh& mesh, std::span<const VisiblePatch> visible) {
  std::vector<std::uint8_t> wanted(held_.size());
  for (const VisiblePatch& patch : visible) wanted[patch.index] = has_own_triangles(mesh, patch);
  if (slots_.used() > kKeptSlots * kPatchIndices)
    for (std::size_t i = 0; i < held_.size(); ++i)
      if (Held& held = held_[i]; held.slot.size > 0 && !wanted[i]) slots_.give_back(held.slot), held.slot = {};
  std::int64_t bytes = 0;
  for (std::size_t i = 0; i < held_.size(); ++i) {
    Held& held = held_[i];
    if (!wanted[i] || (held.slot.size > 0 && held.own_build == held.build)) continue;
    held.own_build = held.build;
    if (held.slot.size == 0) held.slot = slots_.take(kPatchIndices);
    own_.reserve(slots_.used());
    const std::vector<std::uint16_t> triangles = mesh.triangles(i);
    held.indices = static_cast<std::uint32_t>(triangles.size());
    own_.write(held.slot.first, triangles);
    bytes += static_cast<std::int64_t>(triangles.size() * sizeof(std::uint16_t));
  }
  return bytes;
}

void LandCache::sync_far(const sim::Ground& ground, const sim::LandMesh& mesh, UploadStats& stats) {
  const world::Park& park = ground.land().park();
  std::vector<std::uint64_t> key{mesh.reset_build(), std::bit_cast<std::uint64_t>(park.relief),
                                 std::bit_cast<std::uint64_t>(park.woods)};
  const int across = ground.tiles_across();
  for (int i = 0; i < across * across; ++i)
    if (i % across == 0 || i % across == across - 1 || i / across == 0 || i / across == across - 1)
      key.push_back(mesh.patches()[static_cast<std::size_t>(i)].build);
  if (key == far_key_) return;
  far_key_ = std::move(key);
  far_land_ = far_land(ground, mesh.field());
  far_.fill(far_land_.vertices);
  far_indices_.fill(far_land_.indices);
  stats.bytes += static_cast<std::int64_t>(far_land_.vertices.size() * sizeof(sim::LandVertex) +
                                           far_land_.indices.size() * sizeof(std::uint16_t));
  if (far_array_.id() == 0) far_array_ = make_vertex_array(*gl_);
  gl_->BindVertexArray(far_array_.id());
  land_attributes(*gl_, far_.id());
  gl_->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, far_indices_.id());
  gl_->BindVertexArray(0);
}

std::int64_t LandCache::draw(const sim::LandMesh& mesh, const VisiblePatch& patch, bool unseen) const {
  const Held& held = held_[patch.index];
  const bool own = has_own_triangles(mesh, patch);
  const Range range = own ? Range{held.slot.first, held.indices} : lists_.at({patch.step, patch.snapped});
  if (!unseen) {
    const glm::vec2 corner = mesh.patches()[patch.index].corner;
    gl_->VertexAttrib4f(kCorner, corner.x, corner.y, 0, 1);
    gl_->BindVertexArray(held.array.id());
    gl_->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, own ? own_.id() : shared_.id());
    gl_->DrawElements(GL_TRIANGLES, GLsizei(range.size), GL_UNSIGNED_SHORT,
                      reinterpret_cast<const void*>(std::size_t{range.first} * sizeof(std::uint16_t)));
  }
  return range.size / 3;
}

std::int64_t LandCache::draw_far(const glm::mat4& view_projection, bool unseen) const {
  std::int64_t triangles = 0;
  if (far_land_.vertices.empty()) return 0;
  const float half = far_land_.vertices[0].position.x < 0 ? -far_land_.vertices[0].position.x : 1;
  const float far = kFarthestLand * half;
  const Box whole{{-far, far_land_.low, -far}, {far, far_land_.high, far}};
  if (!unseen) {
    gl_->BindVertexArray(far_array_.id());
    gl_->VertexAttrib4f(3, 1, 0, 0, 0);  // full sunlight, no lamps
    no_corner(*gl_);
  }
  for (std::size_t side = 0; side < 4; ++side) {
    Box box = whole;
    if (side == 0) box.high.z = -half;
    if (side == 1) box.low.x = half;
    if (side == 2) box.low.z = half;
    if (side == 3) box.high.x = -half;
    if (!may_show(view_projection, box)) continue;
    const std::uint32_t first = far_land_.sides[side], count = far_land_.sides[side + 1] - first;
    if (!unseen)
      gl_->DrawElements(GL_TRIANGLES, GLsizei(count), GL_UNSIGNED_SHORT,
                        reinterpret_cast<const void*>(std::size_t{first} * sizeof(std::uint16_t)));
    triangles += count / 3;
  }
  return triangles;
}

}  // namespace coaster::gfx
