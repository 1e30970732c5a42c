#include "gfx/soft_quads.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sim/ground/ground.h"
#include "sim/solids/supports.h"
#include "sim/solids/track_mesh.h"

namespace coaster::gfx {
namespace {

using Corners = std::array<glm::vec3, 4>;

// Returns the corners of a rectangle on the ground with half sides `along` and `across` (x and z, m).
Corners on_ground(const sim::Ground& ground, glm::dvec3 middle, glm::dvec2 along, glm::dvec2 across) {
  constexpr double kOver = 0.03;  // m
  Corners corners;
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec2 at = glm::dvec2(middle.x, middle.z) + (i & 1 ? along : -along) + (i & 2 ? across : -across);
    corners[i] = glm::vec3(at.x, ground.height(at.x, at.y) + kOver, at.y);
  }
  return corners;
}

}  // namespace

void SoftQuads::Batch::fill(const Gl& gl, const std::vector<Quad>& quads) {
  count = GLsizei(quads.size());
  if (!buffer.fill(quads) && array.id() != 0) return;
  if (array.id() == 0) array = make_vertex_array(gl);
  gl.BindVertexArray(array.id());
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer.id());
  for (GLuint i = 0; i < 5; ++i)
    float_attribute(gl, i, i < 4 ? 3 : 4, sizeof(Quad), std::size_t{i} * sizeof(glm::vec3), 1);
  gl.BindVertexArray(0);
}

void SoftQuads::upload(const Scene& scene, std::uint64_t solids) {
  const sim::Ground& ground = *scene.ground;
  std::vector<Quad> quads;
  for (const Splash& splash : scene.splashes) {
    const float high = 0.4f + 1.5f * splash.strength, back = 1.6f + 3.4f * splash.strength;
    const glm::vec3 forward = splash.forward, left = glm::normalize(glm::cross(glm::vec3(0, 1, 0), forward));
    for (const float side : {-1.0f, 1.0f})
      for (const float layer : {0.0f, 1.0f}) {
        const glm::vec3 front = splash.at + (1.2f - 0.5f * layer) * forward + side * (0.75f + 0.4f * layer) * left,
                        rear = front - back * forward,
                        out = glm::vec3(0, high, 0) + side * (0.35f + 0.5f * layer) * high * left;
        quads.push_back({{front, rear, front + out, rear + out},
                         {std::min(0.35f + 0.5f * splash.strength, 0.85f), 0, 17 * layer + 5 * side, 0}});
      }
  }
  spray_.fill(*gl_, quads);
  if (const std::array key{solids, ground.build()}; std::exchange(key_, key) == key) return;
  quads.clear();
  const auto add = [&](glm::dvec3 middle, glm::dvec2 along, glm::dvec2 across, glm::vec3 look) {
    if (ground.height(middle.x, middle.z) > ground.water())
      quads.push_back({on_ground(ground, middle, along, across), glm::vec4(look, 0)});
  };
  if (scene.supports != nullptr)
    for (const world::Entity segment : scene.supports->order())
      if (const sim::SegmentSupports* const held = scene.supports->of(segment))
        for (const sim::Bar& bar : held->bars)
          if (const double reach = 0.75 + 2 * double{bar.to_radius}; bar.grounded)
            add(glm::dvec3(bar.to), {reach, 0}, {0, reach}, {0.45f, 0.15f, 0.15f});
  constexpr double kBeside = 4.2, kHigh = 6;  // m
  for (std::size_t i = 0; i < scene.derived.order.size(); ++i) {
    const sim::SegmentShape& shape = scene.derived.shape_at(i);
    if (shape.fitted != world::EquipmentKind::station) continue;
    const std::vector<sim::Ring> rings = sim::spaced_rings(shape, 1.5);
    for (const sim::Ring& ring : rings) {
      const glm::dvec2 way(ring.frame.forward.x, ring.frame.forward.z);
      if (!(glm::length(way) > 0.5)) continue;
      const glm::dvec2 ahead = 0.5 * shape.arc.length() / static_cast<double>(rings.size()) * glm::normalize(way);
      const double over =
          ring.position.y + sim::form_of(shape).platform - ground.height(ring.position.x, ring.position.z);
      if (over < kHigh && over > 0)
        add(ring.position, ahead, kBeside * glm::normalize(glm::dvec2(-way.y, way.x)),
            {static_cast<float>(0.5 * (1 - over / kHigh)), 0.999f, 0.55f});
    }
  }
  shadows_.fill(*gl_, quads);
}

void SoftQuads::draw(const PassContext& pass, const ShaderProgram& program, const Batch& batch) const {
  const view::View& view = pass.scene.view;
  program.set("view_projection", pass.view_projection);
  program.set("eye", view.eye);
  program.set("nearer", view.parallel > 0 ? 0.0f : 0.002f);
  blend(*gl_, true);
  gl_->DepthMask(GL_FALSE);
  gl_->BindVertexArray(batch.array.id());
  if (!pass.scene.unseen) gl_->DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, batch.count);
  pass.count(std::int64_t{2} * batch.count);
  gl_->DepthMask(GL_TRUE);
  blend(*gl_, false);
}

void SoftQuads::draw_contact(const PassContext& pass) const {
  if (shadows_.count == 0) return;
  if (pass.park) gl_->Enable(GL_DEPTH_TEST), gl_->DepthFunc(GL_LEQUAL);
  else gl_->Disable(GL_DEPTH_TEST);
  draw(pass, pass.use(SceneProgram::contact), shadows_);
}

void SoftQuads::draw_spray(const PassContext& pass) const {
  if (spray_.count == 0) return;
  gl_->Enable(GL_DEPTH_TEST), gl_->DepthFunc(GL_LESS);
  const ShaderProgram& program = pass.use(SceneProgram::spray);
  program.set("clock", static_cast<float>(std::fmod(pass.scene.seconds, 1000.0)));
  draw(pass, program, spray_);
}

}  // namespace coaster::gfx
