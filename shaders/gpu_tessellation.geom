// Turns a line of the tessellator into a strip of two triangles of constant width on the screen.
layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;
in vec3 place[];
in float number[];
uniform mat4 view_projection;
uniform vec3 eye;
uniform vec2 viewport;
uniform float width_px;
uniform vec4 paint;
out float across;
flat out float width;
flat out vec4 tint;

void main() {
  // Tessellators may reverse a line; its width is that of the later end.
  int later = number[0] < number[1] ? 1 : 0;
  for (int corner = 0; corner < 4; ++corner) {
    float off, wide;
    gl_Position = polyline_corner(view_projection, eye, viewport, width_px, place[1 - later], place[later],
                                  vec2(corner & 1, (corner & 2) - 1), off, wide);
    across = off, width = wide, tint = paint;
    EmitVertex();
  }
  EndPrimitive();
}
