// A view of a track, and its picture with ids as colours: drawn from the rules of view/pick.h alone, with marks sorted
// by the depth buffer, as an oracle for pick(). The curve is not in it.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "gfx/gl_objects.h"
#include "sim/ride/ride.h"
#include "sim/tracks.h"
#include "view/pick.h"
#include "world/aid_settings.h"
#include "world/appearance_settings.h"

namespace coaster::test {

using view::PickKind;

inline constexpr int kIdWidth = 160, kIdHeight = 120;

// Red: the slot of the entity plus one; green: the kind. 0: nothing with an id.
using Id = std::array<std::uint8_t, 2>;
inline constexpr Id kNothing{0, 0};
inline Id id_of(PickKind kind, world::Entity entity) {
  if (kind == PickKind::none || kind == PickKind::curve) return kNothing;  // the curve is not in the pictures
  return {static_cast<std::uint8_t>(entity.index + 1), static_cast<std::uint8_t>(kind)};
}

// A hilly ring with three carts close together, so that they cover each other, and one view of it.
struct LevelView {
  world::Document document;
  sim::DerivedTrack derived;
  world::Motion motion;
  world::Settings settings;
  view::View view;
  std::vector<sim::Pose> carts() const {
    std::vector<sim::Pose> poses;
    for (const world::TrainMotion& cart : motion.carts.items())
      poses.push_back(sim::pose(derived, cart, settings.frames));
    return poses;
  }
  view::Pick at(glm::vec2 pixel) const { return view::pick(document, derived, motion, settings, view, pixel); }
};

inline LevelView make_sight() {
  LevelView sight;
  sight.settings.aids->show_gizmo = false;  // its parts are no entities
  sight.document = ring_document(9, 17.3);
  for (const double fraction : {0.21, 0.43, 0.67})
    world::add_cart(sight.document, sight.document.track.segments[2], fraction);
  sim::derive(sight.document, sight.settings, {}, sight.derived);
  sim::reset(sight.document, sight.derived, sight.motion);
  return sight;
}

inline double uniform(std::mt19937& bits, double low, double high) {
  return low + (high - low) * (bits() / 4294967296.0);
}

inline void look_around(std::mt19937& bits, LevelView& sight) {
  const std::vector<world::Entity>& knots = sight.document.track.knots;
  const std::vector<world::Entity>& segments = sight.document.track.segments;
  const std::array<world::Entity, 3> choices{world::kNone, knots[bits() % knots.size()],
                                             segments[bits() % segments.size()]};
  sight.settings.selected = choices[bits() % choices.size()];
  sight.settings.look->ui_scale = bits() % 2 ? 1.0f : 1.5f;
  sight.settings.frames = bits() % 2 ? world::FrameMethod::knots : world::FrameMethod::frenet;
  world::Camera camera;
  camera.target = bits() % 2 ? world::knot(sight.document, knots[bits() % knots.size()]).position
                             : glm::vec3(sight.carts()[bits() % sight.motion.carts.size()].position);
  camera.yaw_deg = static_cast<float>(uniform(bits, -180, 180));
  camera.pitch_deg = static_cast<float>(uniform(bits, -30, 88));
  camera.distance = static_cast<float>(std::exp(uniform(bits, std::log(4.0), std::log(150.0))));
  sight.view = view::orbit_view(camera, {13, 7, kIdWidth, kIdHeight});
}

// The boxes of a cart, low and high corner, m ahead, up, left: the body is on the rails' plane, the riders' heads on
// the body.
inline constexpr double kCartBoxes[2][2][3] = {{{-1.1, 0, -0.65}, {1.1, 1.1, 0.65}},
                                               {{-1.1, 1.1, -0.4}, {0.25, 1.45, 0.4}}};
inline glm::vec3 corner_of(const sim::Pose& pose, const double (&box)[2][3], int i) {
  return glm::vec3(pose.position + box[i & 1][0] * pose.frame.forward + box[i >> 1 & 1][1] * pose.frame.up +
                   box[i >> 2][2] * pose.frame.left());
}
// Closer views involve the near plane and the rider's own cart, which this test does not cover.
inline bool near_a_cart(const LevelView& sight) {
  for (const sim::Pose& pose : sight.carts())
    if (glm::distance(pose.position, glm::dvec3(sight.view.eye)) < 2.5) return true;
  return false;
}

inline constexpr const char* kIdVertexShader = R"(
layout(location = 0) in vec4 place;   // clip space
layout(location = 1) in vec3 middle;  // px from the bottom left, and half the size; of size 0: all of the triangle
layout(location = 2) in vec3 paint;   // id, and 1 for squares
flat out vec3 mark;
flat out vec3 id;
void main() {
  mark = middle;
  id = paint;
  gl_Position = place;
}
)";
inline constexpr const char* kIdFragmentShader = R"(
flat in vec3 mark;
flat in vec3 id;
out vec4 colour;
void main() {
  vec2 away = abs(gl_FragCoord.xy - mark.xy);
  float distance = id.z > 0.5 ? max(away.x, away.y) : length(away);
  if (mark.z > 0.0 && distance > mark.z) discard;
  colour = vec4(id.xy / 255.0, 0.0, 1.0);
}
)";

// Draws ids of discs about the middles of carts, then carts over them, then knots over them, then handles over all;
// within a kind the depth buffer decides.
class IdPicture {
 public:
  explicit IdPicture(const gfx::Gl& gl)
      : gl_(gl),
        program_(std::move(
            *gfx::make_program(gl, {.name = "ids", .vertex = kIdVertexShader, .fragment = kIdFragmentShader}))),
        target_(std::move(*gfx::make_target(gl, kIdWidth, kIdHeight, 0))),
        array_(gfx::make_vertex_array(gl)),
        buffer_(gfx::make_buffer(gl)) {}

  void draw(const LevelView& sight) {
    gl_.BindFramebuffer(GL_FRAMEBUFFER, target_.framebuffer.id());
    gl_.Viewport(0, 0, kIdWidth, kIdHeight);
    gl_.ClearColor(0, 0, 0, 0);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
    gl_.Enable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_LESS);
    std::vector<Corner> corners;
    for (std::size_t i = 0; i < sight.motion.carts.size(); ++i) {
      const sim::Pose pose = sight.carts()[i];
      add_mark(sight, glm::vec3(pose.position + 0.55 * pose.frame.up), view::kCartReach, false,
               id_of(PickKind::cart, sight.motion.carts.entities()[i]), corners);
    }
    flush(corners);
    for (std::size_t i = 0; i < sight.motion.carts.size(); ++i)
      for (const auto& box : kCartBoxes)
        add_box(sight, sight.carts()[i], box, id_of(PickKind::cart, sight.motion.carts.entities()[i]), corners);
    flush(corners);
    for (const world::Entity e : sight.document.track.knots)
      add_mark(sight, world::knot(sight.document, e).position, view::kKnotRadius, false, id_of(PickKind::knot, e),
               corners);
    flush(corners);
    std::vector<world::Entity> shown;
    if (sight.document.entities.find<world::Knot>(sight.settings.selected)) shown = {sight.settings.selected};
    if (const auto* segment = sight.document.entities.find<world::Segment>(sight.settings.selected))
      shown = {segment->from, segment->to};
    for (const world::Entity e : shown) {
      const world::Knot& knot = world::knot(sight.document, e);
      add_mark(sight, knot.position - knot.in_length * knot.tangent, view::kHandleHalf, true,
               id_of(PickKind::handle_in, e), corners);
      add_mark(sight, knot.position + knot.out_length * knot.tangent, view::kHandleHalf, true,
               id_of(PickKind::handle_out, e), corners);
    }
    flush(corners);
    gl_.PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl_.ReadPixels(0, 0, kIdWidth, kIdHeight, GL_RGBA, GL_UNSIGNED_BYTE, pixels_.data());
  }
  // `column` and `row` from the top left.
  Id at(int column, int row) const {
    const std::size_t i = 4 * (std::size_t(kIdHeight - 1 - row) * kIdWidth + std::size_t(column));
    return {pixels_[i], pixels_[i + 1]};
  }

 private:
  struct Corner {
    glm::vec4 place;
    glm::vec3 middle, paint;
  };
  static void add_box(const LevelView& sight, const sim::Pose& pose, const double (&box)[2][3], Id id,
                      std::vector<Corner>& corners) {
    constexpr std::array<std::array<int, 4>, 6> kFaces{
        {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}}};
    for (const auto& face : kFaces)
      for (const int i : {0, 1, 2, 0, 2, 3}) {
        const glm::vec4 place =
            sight.view.projection * sight.view.view * glm::vec4(corner_of(pose, box, face[std::size_t(i)]), 1);
        corners.push_back({place, glm::vec3(0), glm::vec3(id[0], id[1], 0)});
      }
  }
  static void add_mark(const LevelView& sight, glm::vec3 position, float size, bool square, Id id,
                       std::vector<Corner>& corners) {
    const glm::dvec4 clip = glm::dmat4(sight.view.projection) * glm::dmat4(sight.view.view) * glm::dvec4(position, 1);
    if (clip.w <= 0 || std::abs(clip.z) > clip.w) return;
    const glm::dvec2 half(0.5 * kIdWidth, 0.5 * kIdHeight), middle = (glm::dvec2(clip) / clip.w + 1.0) * half;
    const float radius = size * sight.settings.look->ui_scale;
    // Depth by the distance from the eye, which differs from the depth along the line of sight: resolution 0.25 mm up
    // to 2 km.
    const double depth = glm::distance(glm::dvec3(position), glm::dvec3(sight.view.eye)) / 1000 - 1;
    for (const int i : {0, 1, 2, 2, 1, 3}) {
      const glm::dvec2 corner = middle + (radius + 2.0) * glm::dvec2(i & 1 ? 1 : -1, i & 2 ? 1 : -1);
      corners.push_back({glm::vec4(glm::vec2(corner / half - 1.0), depth, 1), glm::vec3(glm::vec2(middle), radius),
                         glm::vec3(id[0], id[1], square ? 1 : 0)});
    }
  }
  void flush(std::vector<Corner>& corners) {
    gl_.Clear(GL_DEPTH_BUFFER_BIT);
    gl_.BindVertexArray(array_.id());
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_.id());
    gl_.BufferData(GL_ARRAY_BUFFER, GLsizeiptr(corners.size() * sizeof(Corner)), corners.data(), GL_STREAM_DRAW);
    gfx::float_attribute(gl_, 0, 4, sizeof(Corner), offsetof(Corner, place));
    gfx::float_attribute(gl_, 1, 3, sizeof(Corner), offsetof(Corner, middle));
    gfx::float_attribute(gl_, 2, 3, sizeof(Corner), offsetof(Corner, paint));
    program_.use();
    gl_.DrawArrays(GL_TRIANGLES, 0, GLsizei(corners.size()));
    corners.clear();
  }

  const gfx::Gl& gl_;
  gfx::ShaderProgram program_;
  gfx::RenderTarget target_;
  gfx::GlObject array_, buffer_;
  std::vector<std::uint8_t> pixels_ = std::vector<std::uint8_t>(4 * kIdWidth * kIdHeight);
};

}  // namespace coaster::test
