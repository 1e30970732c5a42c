// The air over a park, after common.glsl: how much of it lies before a place, by vertex. Distances count less than over
// the plain, so that hills and trees behind the track stay clear.
// Returns the colour of the air in front of a place, times its share (w).
vec4 air_before(vec3 world, vec3 eye) {
  vec3 sight = world - eye;
  float metres = length(sight);
  float much = 0.96 * fog(0.72 * metres, eye.y);
  return vec4(mist(sight / max(metres, 1e-3)) * much, much);
}
