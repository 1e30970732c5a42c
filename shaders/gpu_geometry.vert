// Passes a segment's control points to the geometry shader: instance k is the segment in slot k, vertex j the j-th
// kLines of its lines.
layout(location = 0) in vec3 p0;
layout(location = 1) in vec3 p1;
layout(location = 2) in vec3 p2;
layout(location = 3) in vec3 p3;
out vec3 q0;
out vec3 q1;
out vec3 q2;
out vec3 q3;
flat out int piece;
flat out int slot_of;

void main() {
  q0 = p0, q1 = p1, q2 = p2, q3 = p3;
  piece = gl_VertexID;
  slot_of = gl_InstanceID;
  gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
}
