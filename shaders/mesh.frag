// Painted steel in sun and sky light, or the flat faces of the blueprint style; with OUTLINE its outlines. The ground
// hides solids on its other side; in a park its depth does.
uniform vec3 eye;
uniform int colouring;     // 1: rails and spine by the segment's values
uniform sampler2D values;  // 32 per segment, uniform in arc length; 32 segments per row; over 1e38: unknown
uniform vec2 value_range;  // from and to
uniform vec3 stops[10];    // the colour map, uniform from 0 to 1
uniform vec3 unknown;
uniform vec4 materials[23];        // by sim::Material: paint (sRGB); w: how much of the surface is varnish
uniform int own_paints;            // 1: some sections have paint of their own
uniform sampler2D section_paints;  // 4 per segment: rails, spine, supports, none; alpha 1: its own; 32 segments per row
#ifdef PARK
uniform sampler2D lamp_map;  // from above: r: half the light of lamps, g: their height
uniform int lamps;           // 1: they shine
uniform float lamp_square;   // m, side of the map, about the origin
uniform vec2 cast_heights;   // m, the lowest height, and the range
uniform vec4 headlights[8];  // of trains, in pairs: place (m), then direction
uniform int headlight_count;
#endif
in vec3 world;
in vec3 facing;
flat in float material;
in float along;
flat in float segment;
#ifdef SHADED
in float hidden;  // part of the sky; at most 1, below 0: none
#endif
out vec4 colour;

// Returns the paint of a material: its own, or that of the segment's section.
vec3 paint(int part) {
  vec3 own = materials[clamp(part, 0, 22)].rgb;
  int which = part == 0 ? 0 : part < 3 ? 1 : part == 6 || part == 21 ? 2 : 3;
  // Once or never: software renderers skip a loop, but not a branch.
  for (int i = 0; i < own_paints; ++i) {
    int index = int(segment + 0.5);
    vec4 section = texelFetch(section_paints, ivec2((index & 31) * 4 + which, index >> 5), 0);
    own = mix(own, section.rgb, step(0.5, section.a));
  }
  return own;
}

vec3 value_colour() {
  int index = int(segment + 0.5);
  float at = clamp(along, 0.0, 1.0) * 31.0;
  int first = min(int(at), 30);
  ivec2 texel = ivec2((index & 31) * 32 + first, index >> 5);
  float a = texelFetch(values, texel, 0).r, b = texelFetch(values, texel + ivec2(1, 0), 0).r;
  if (a > 1e38 && b > 1e38) return unknown;
  float value = a > 1e38 ? b : b > 1e38 ? a : mix(a, b, at - float(first));
  float part = clamp((value - value_range.x) / (value_range.y - value_range.x), 0.0, 1.0) * 9.0;
  int stop = min(int(part), 8);
  return mix(stops[stop], stops[stop + 1], part - float(stop));
}

// Returns the linear light of a painted surface; `sun`: fraction of sunlight on it, `open`: of the sky's.
vec3 lit(vec3 paint_light, float shiny, float sun, float open, vec3 normal, vec3 to_eye) {
  vec3 ambient = mix(air.ground_light.rgb, air.sky_light.rgb, 0.5 + 0.5 * normal.y) * open;
  vec3 light = paint_light * (air.sun_light.rgb * sun + ambient);
  float upright = max(dot(normal, to_eye), 0.0);
  float grazing = (1.0 - upright) * (1.0 - upright);
  float mirror = open * shiny * air.sun_light.w * (0.04 + 0.5 * grazing * grazing * (1.0 - upright));
  vec3 bounce = reflect(-to_eye, normal);
  vec3 seen = mix(air.ground.rgb * (air.sun_light.rgb * air.sun.y + air.sky_light.rgb),
                  sky(vec3(bounce.x, max(bounce.y, 0.0), bounce.z)), smoothstep(-0.12, 0.12, bounce.y));
  float half_way = max(dot(normal, normalize(air.sun.xyz + to_eye)), 0.0);
  vec3 shine =
      air.sun_light.rgb * shiny * (0.45 * to_90(half_way) + 0.04 * to_7(half_way * half_way)) * min(4.0 * sun, 1.0);
  return light + mirror * seen + shine * air.sun_light.w;
}

void main() {
#ifndef PARK
  if (world.y * eye.y < 0.0) discard;
#endif
  int part = int(material + 0.5);
  vec3 normal = normalize(facing), to_eye = eye - world;
  float metres = length(to_eye);
  to_eye /= metres;
  bool by_value = colouring == 1 && part < 2;
#ifdef OUTLINE
  vec3 light = air.ink.rgb;
#else
  float sun = max(dot(normal, air.sun.xyz), 0.0) * sun_reaches(world, normal);
  vec3 own = linear_of(by_value ? value_colour() : paint(part)), light;
  if (by_value) {
    // Colours that show values are shaded only lightly: they stay close to the legend in every style.
    light = own * (0.78 + 0.28 * sun + 0.12 * normal.y);
  } else if (air.sun.w > 0.5) {
    float bright = dot(own, vec3(0.2126, 0.7152, 0.0722));
    light =
        mix(air.ground.rgb, air.ink.rgb, (0.05 + 0.34 * bright) * (0.75 + 0.45 * normal.y + 0.2 * dot(normal, to_eye)));
  } else {
    float open = 1.0;
#ifdef SHADED
    float dark = clamp(hidden, 0.0, 1.0);
    open = 1.0 - dark * (1.0 - 0.3 * dark);
#endif
    light = lit(own, materials[clamp(part, 0, 22)].w, sun, open, normal, to_eye);
    if (part == 4) light += air.ground_light.w * own;
#ifdef PARK
    for (int i = 0; i < lamps; ++i) {
      vec2 there = textureLod(lamp_map, world.xz / lamp_square + 0.5, 0.0).rg;
      float over = (world.y - cast_heights.x - there.g * cast_heights.y) / 7.0;
      float within = 0.0;
#ifdef SHADED
      if (part > 11 && part < 19) within = 0.45;  // of cars: seats and riders
#endif
      light += own * vec3(1.0, 0.62, 0.30) * (1.5 * there.r / (1.0 + over * over) + within);
    }
    for (int i = 0; i < headlight_count; ++i) {
      vec3 to = headlights[2 * i].xyz - world;
      float far = dot(to, to), ahead = -dot(to, headlights[2 * i + 1].xyz) * inversesqrt(far);
      light += own * vec3(1.0, 0.86, 0.62) * (60.0 * smoothstep(0.86, 0.98, ahead) / (far + 40.0)) *
               max(dot(normal, to) * inversesqrt(far) + 0.15, 0.0);
    }
#endif
  }
#endif
  light = mix(light, mist(-to_eye), (by_value ? 0.45 : 0.9) * fog(metres, eye.y));
  colour = vec4(encode(light), 1.0);
}
