// The evaluated polyline: instance i is the line from vertex i to vertex i+1 of the one buffer; breaks between segments
// have no area.
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 from_tangent;
layout(location = 2) in vec3 to;
layout(location = 3) in vec3 to_tangent;
uniform mat4 view_projection;
uniform vec3 eye;
uniform vec2 viewport;
uniform float width_px;
uniform vec4 paint;
out float across;
flat out float width;
flat out vec4 tint;

void main() {
  tint = paint;
  across = 0.0;
  width = width_px;
  if (max(from_tangent.x, to_tangent.x) > 1e38) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  gl_Position = polyline_corner(view_projection, eye, viewport, width_px, from, to,
                                vec2(gl_VertexID & 1, (gl_VertexID & 2) - 1), across, width);
}
