// The evaluated polyline: instance i is the line from vertex i to vertex i+1 of the one buffer; breaks between segments have no area.
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
  // Half a percent nearer to the eye, on the same pixel: over the rails and ties that it touches.
  vec4 a = view_projection * vec4(mix(eye, from, 0.995), 1.0), b = view_projection * vec4(mix(eye, to, 0.995), 1.0);
  // Far off it thins out, so that it does not cover the track that it describes: never wider than kWidest metres.
  const float kWidest = 0.2;
  float px_per_metre = 0.5 * viewport.y * length(vec3(view_projection[0][1], view_projection[1][1], view_projection[2][1])) / max(b.w, 0.01);
  width = clamp(kWidest * px_per_metre, 0.6, width_px);
  gl_Position = expand(a, b, vec2(gl_VertexID & 1, (gl_VertexID & 2) - 1), width, viewport, across);
}
