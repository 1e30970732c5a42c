// A quad with soft edges: a contact shadow on the ground; with SPRAY water thrown up by a train.
layout(location = 0) in vec3 corner_0;
layout(location = 1) in vec3 corner_1;
layout(location = 2) in vec3 corner_2;
layout(location = 3) in vec3 corner_3;
layout(location = 4) in vec4 look;
uniform mat4 view_projection;
uniform vec3 eye;
uniform float nearer;  // part of the way to the eye by which quads come nearer, so that the ground does not hide them
out vec2 corner;       // -1 to 1
flat out vec4 soft;
out float clear;  // part of the air

void main() {
  corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
  soft = look;
  vec3 at = gl_VertexID == 0 ? corner_0 : gl_VertexID == 1 ? corner_1 : gl_VertexID == 2 ? corner_2 : corner_3;
  clear = 1.0 - air_before(at, eye).w;
  gl_Position = view_projection * vec4(mix(at, eye, nearer), 1.0);
}
