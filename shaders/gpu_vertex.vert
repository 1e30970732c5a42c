// The polyline evaluated by the vertex shader: instance k is the segment in slot k, six vertices are one of its lines.
// With MEASURE vertex i is the polyline's, captured with its number and slot.
layout(location = 0) in vec3 p0;
layout(location = 1) in vec3 p1;
layout(location = 2) in vec3 p2;
layout(location = 3) in vec3 p3;
uniform int steps;
#ifdef MEASURE
out vec3 place;
out float number;
out float slot;

void main() {
  place = cubic_point(p0, p1, p2, p3, gl_VertexID, steps);
  number = float(gl_VertexID);
  slot = float(gl_InstanceID);
  gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
}
#else
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
  if (p0.x > kBreak) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  int line = gl_VertexID / 6, at = gl_VertexID % 6;
  int corner = at < 3 ? at : at == 3 ? 2 : at == 4 ? 1 : 3;  // the triangles 0 1 2 and 2 1 3 of a strip
  gl_Position =
      polyline_corner(view_projection, eye, viewport, width_px, cubic_point(p0, p1, p2, p3, line, steps),
                      cubic_point(p0, p1, p2, p3, line + 1, steps), vec2(corner & 1, (corner & 2) - 1), across, width);
}
#endif
