// The polyline evaluated by the geometry shader: a point becomes up to kLines lines, a strip of two triangles each.
// With MEASURE it becomes the polyline's vertices, captured with number and slot.
layout(points) in;
in vec3 q0[], q1[], q2[], q3[];
flat in int piece[];
flat in int slot_of[];
uniform int steps;
const int kLines = 16;  // 64 vertices of 10 components: below the 1,024 that every driver has
#ifdef MEASURE
layout(points, max_vertices = 17) out;
out vec3 place;
out float number;
out float slot;
#else
layout(triangle_strip, max_vertices = 64) out;
uniform mat4 view_projection;
uniform vec3 eye;
uniform vec2 viewport;
uniform float width_px;
uniform vec4 paint;
out float across;
flat out float width;
flat out vec4 tint;

void emit(vec3 from, vec3 to) {
  for (int corner = 0; corner < 4; ++corner) {
    float off, wide;
    gl_Position = polyline_corner(view_projection, eye, viewport, width_px, from, to,
                                  vec2(corner & 1, (corner & 2) - 1), off, wide);
    across = off, width = wide, tint = paint;
    EmitVertex();
  }
  EndPrimitive();
}
#endif

void main() {
  if (q0[0].x > kBreak) return;
  int first = piece[0] * kLines, last = min(first + kLines, steps);
#ifdef MEASURE
  for (int i = first; i <= last; ++i) {
    place = cubic_point(q0[0], q1[0], q2[0], q3[0], i, steps);
    number = float(i), slot = float(slot_of[0]);
    EmitVertex();
    EndPrimitive();
  }
#else
  vec3 from = cubic_point(q0[0], q1[0], q2[0], q3[0], first, steps);
  for (int i = first; i < last; ++i) {
    vec3 to = cubic_point(q0[0], q1[0], q2[0], q3[0], i + 1, steps);
    emit(from, to);
    from = to;
  }
#endif
}
