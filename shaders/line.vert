// The overlay's lines: one instance each.
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in float width_px;
layout(location = 3) in vec4 paint;
uniform mat4 view_projection;
uniform vec2 viewport;
out float across;
flat out float width;
flat out vec4 tint;

void main() {
  width = width_px;
  tint = paint;
  gl_Position = expand(view_projection * vec4(from, 1.0), view_projection * vec4(to, 1.0),
                       vec2(gl_VertexID & 1, (gl_VertexID & 2) - 1), width_px, viewport, across);
}
