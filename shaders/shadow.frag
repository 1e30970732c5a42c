// The colour of a shadow map, besides depth: coverage, and the height of the caster above the ground.
in vec3 world;
in vec3 facing;
flat in float material;
out vec4 colour;

void main() {
  if (world.y < 0.0) discard;
  colour = vec4(1.0, clamp(world.y / kHighest, 0.0, 1.0), 0.0, 1.0);
}
