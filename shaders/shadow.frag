// The colour of a shadow map, besides depth: coverage, and the height of the caster above the ground.
in vec3 world;
in vec3 facing;
flat in float material;
out vec4 colour;
#ifdef PARK
uniform vec2 cast_heights;  // m, the lowest height that maps tell apart, and their range
#endif

void main() {
#ifdef PARK
  colour = vec4(1.0, clamp((world.y - cast_heights.x) / cast_heights.y, 0.0, 1.0), 0.0, 1.0);
#else
  if (world.y < 0.0) discard;
  colour = vec4(1.0, clamp(world.y / kHighest, 0.0, 1.0), 0.0, 1.0);
#endif
}
