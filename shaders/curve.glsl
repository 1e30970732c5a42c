// A cubic from its control points, after line.glsl: shared by the GPU evaluators. The same arithmetic as Horner on the
// processor.
const float kBreak = 1e38;  // a larger x of a control point marks an empty slot

// Returns vertex i of a polyline of `steps` steps; both ends are exactly the control points, so joints have no gaps.
vec3 cubic_point(vec3 p0, vec3 p1, vec3 p2, vec3 p3, int i, int steps) {
  if (i >= steps) return p3;
  float t = float(i) / float(steps);
  vec3 d0 = p1 - p0, d1 = p2 - p1, d2 = p3 - p2;
  vec3 c1 = 3.0 * d0, c2 = 3.0 * (d1 - d0), c3 = (d2 - d1) - (d1 - d0);
  return p0 + t * (c1 + t * (c2 + t * c3));
}
