// Lines of constant pixel width as quads, after common.glsl in both stages of line programs.
const float kFeather = 0.75;  // px beyond half the width, where the coverage falls to 0

// Returns a corner of the quad for the line from a to b (clip space): corner.x 0 at a, 1 at b; corner.y -1 or 1 across.
// The result has w = 1, so interpolation is linear on the screen. `across`: px from the middle. A line behind the eye
// has no area.
vec4 expand(vec4 a, vec4 b, vec2 corner, float width_px, vec2 viewport, out float across) {
  const float kNear = 0.01;
  across = 0.0;
  if (a.w < kNear && b.w < kNear) return vec4(2.0, 2.0, 2.0, 1.0);
  if (a.w < kNear) a = mix(a, b, (kNear - a.w) / (b.w - a.w));
  if (b.w < kNear) b = mix(b, a, (kNear - b.w) / (a.w - b.w));
  vec3 from = a.xyz / a.w, to = b.xyz / b.w;
  vec2 along = (to.xy - from.xy) * viewport;
  float size = length(along);
  along = size > 1e-4 ? along / size : vec2(1.0, 0.0);
  float reach = 0.5 * width_px + kFeather;
  across = corner.y * reach;
  vec3 place = corner.x < 0.5 ? from : to;
  place.xy += vec2(-along.y, along.x) * across * 2.0 / viewport;
  return vec4(place, 1.0);
}

float coverage(float across, float width_px) {
  return clamp((0.5 * width_px + kFeather - abs(across)) / (2.0 * kFeather), 0.0, 1.0) * min(width_px, 1.0);
}

// Returns a corner of the line from `from` to `to` (world) of the laboratory's polyline.
vec4 polyline_corner(mat4 view_projection, vec3 eye, vec2 viewport, float widest_px, vec3 from, vec3 to, vec2 corner,
                     out float across, out float width) {
  // Half a percent nearer to the eye, on the same pixel: in front of the rails and ties that it touches.
  vec4 a = view_projection * vec4(mix(eye, from, 0.995), 1.0), b = view_projection * vec4(mix(eye, to, 0.995), 1.0);
  vec3 height = vec3(view_projection[0][1], view_projection[1][1], view_projection[2][1]);
  if (view_projection[0][3] == 0.0 && view_projection[1][3] == 0.0 &&
      view_projection[2][3] == 0.0) {  // orthographic: by as much at the subject
    float nearer =
        0.012 * length(vec3(view_projection[0][2], view_projection[1][2], view_projection[2][2])) / length(height);
    a = view_projection * vec4(from, 1.0) - vec4(0.0, 0.0, nearer, 0.0);
    b = view_projection * vec4(to, 1.0) - vec4(0.0, 0.0, nearer, 0.0);
  }
  // Thins out at a distance, so that it does not cover the track: at most kWidest metres wide.
  const float kWidest = 0.2;
  float px_per_metre = 0.5 * viewport.y * length(height) / max(b.w, 0.01);
  width = clamp(kWidest * px_per_metre, 0.6, widest_px);
  return expand(a, b, corner, width, viewport, across);
}
