// Passes a control point to the tessellator: vertices 4k to 4k+3 are the segment in slot k, instance j the j-th kLevel
// of its lines.
layout(location = 0) in vec3 control;
out vec3 handed;
flat out int piece;
flat out int slot_of;

void main() {
  handed = control;
  piece = gl_InstanceID;
  slot_of = gl_VertexID / 4;
  gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
}
