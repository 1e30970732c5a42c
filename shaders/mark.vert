// Discs and squares of constant pixel size that face the screen: one instance each, four corners.
layout(location = 0) in vec3 position;
layout(location = 1) in float radius_px;  // of a square: half its side
layout(location = 2) in float square;     // 0 disc, 1 square
layout(location = 3) in vec4 paint;
uniform mat4 view_projection;
uniform vec2 viewport;
out vec2 place;  // px from the middle
flat out float radius;
flat out float shape;
flat out vec4 tint;

void main() {
  radius = radius_px;
  shape = square;
  tint = paint;
  place = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID & 2) - 1) * (radius_px + 1.0);
  vec4 middle = view_projection * vec4(position, 1.0);
  if (middle.w < 0.01) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  // Depth 0: neither the near nor the far plane clips a mark.
  gl_Position = vec4(middle.xy / middle.w + place * 2.0 / viewport, 0.0, 1.0);
}
