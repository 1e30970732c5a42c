// A filled mark with a dark rim, antialiased by its distance to the edge.
in vec2 place;
flat in float radius;
flat in float shape;
flat in vec4 tint;
out vec4 colour;
uniform float rim;  // px

void main() {
  float away = shape > 0.5 ? max(abs(place.x), abs(place.y)) : length(place);
  float inside = clamp(radius + 0.5 - away, 0.0, 1.0);
  float fill = clamp(radius - rim + 0.5 - away, 0.0, 1.0);
  colour = vec4(mix(vec3(0.106, 0.122, 0.153), tint.rgb, fill), tint.a * inside);
}
