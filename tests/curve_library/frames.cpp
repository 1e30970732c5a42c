// Frames along a closed loop: carried without rotation about the tangent, they come back turned by an angle that the
// loop's shape determines. Spread over the length, that turn gives frames without a seam.
#include <array>
#include <cstddef>
#include <cstdio>

#include <coaster/curve/arc_length.h>
#include <coaster/curve/carried_frame.h>

namespace curve = coaster::curve;

int main() {
  // Knots on four sides, at different heights, with level tangents: every joint is G1.
  constexpr float kHandle = 5.5f;
  const std::array<glm::vec3, 4> knots{{{10, 3, 0}, {0, -2, 10}, {-10, 1, 0}, {0, 0, -10}}};
  const std::array<glm::vec3, 4> tangents{{{0, 0, 1}, {-1, 0, 0}, {0, 0, -1}, {1, 0, 0}}};
  std::array<curve::Cubic, 4> loop;
  double length = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    loop[i] = {knots[i], knots[i] + kHandle * tangents[i], knots[next] - kHandle * tangents[next], knots[next]};
    length += curve::arc_length(loop[i]);
  }

  const curve::Frame start{curve::unit_tangent(loop[0], 0), {0, 1, 0}};
  curve::Frame frame = start;
  for (const curve::Cubic& cubic : loop) frame = curve::carried(cubic, frame, 0, 1);
  const double turn = curve::signed_angle(frame.up, start.up, start.forward);
  std::printf("length %.9f\nturn %.9f\n", length, turn);

  // Again, turned by the part of the length behind. `bare` is without that turn.
  curve::Frame bare = start;
  double behind = 0;
  for (const curve::Cubic& cubic : loop) {
    bare = curve::carried(cubic, bare, 0, 1), behind += curve::arc_length(cubic);
    frame = {bare.forward, curve::rotate(bare.up, bare.forward, turn * behind / length)};
    const glm::dvec3 left = frame.left();
    std::printf("frame %.9f %.9f %.9f %.9f %.9f %.9f\n", frame.up.x, frame.up.y, frame.up.z, left.x, left.y, left.z);
  }
  std::printf("seam %.3e\n", glm::distance(frame.up, start.up));
}
