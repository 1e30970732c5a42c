// The tone of a shadow on the ground; the stencil lets each sample be darkened once.
uniform vec3 eye;
uniform vec4 tone;  // and how much of it
in vec3 world;
in vec3 facing;
flat in float material;
out vec4 colour;

void main() {
  if (world.y < 0.0) discard;
  vec3 place = world - kSun * (world.y / kSun.y);
  colour = vec4(tone.rgb, tone.a * (1.0 - fog(distance(eye, place), eye.y)));
}
