// A bright middle within a halo.
in vec2 corner;
in float strength;
out vec4 colour;

void main() {
  float out_2 = min(dot(corner, corner), 1.0), left = 1.0 - out_2;
#ifdef STREAK
  float shine = left * left * (1.0 - abs(corner.x));
#else
  float shine = smoothstep(0.16, 0.03, out_2) + 0.38 * left * left * left;
#endif
  colour =
      vec4(mix(vec3(1.0, 0.72, 0.42), vec3(1.0, 0.93, 0.78), smoothstep(0.3, 1.0, shine)), min(shine, 1.0) * strength);
}
