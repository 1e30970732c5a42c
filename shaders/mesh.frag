// Painted steel in sun and sky light, or the flat faces of the blueprint style; with OUTLINE its outlines. The ground
// hides solids on its other side.
uniform vec3 eye;
uniform int colouring;     // 1: rails and spine by the segment's values
uniform sampler2D values;  // 32 per segment, uniform in arc length; 32 segments per row; over 1e38: unknown
uniform vec2 value_range;  // from and to
uniform vec3 stops[10];    // the colour map, uniform from 0 to 1
uniform vec3 unknown;
in vec3 world;
in vec3 facing;
flat in float material;
in float along;
flat in float segment;
out vec4 colour;

// By sim::Part.
const vec3 kPaints[19] = vec3[19](
    vec3(0.851, 0.271, 0.184), vec3(0.659, 0.204, 0.149), vec3(0.227, 0.247, 0.278),  // rail, spine, tie
    vec3(0.180, 0.369, 0.667), vec3(0.957, 0.773, 0.259), vec3(0.150, 0.160, 0.180),  // body, stripe, wheel
    vec3(0.894, 0.906, 0.922), vec3(0.710, 0.722, 0.706), vec3(0.420, 0.441, 0.471),  // support, concrete, chain
    vec3(0.788, 0.816, 0.847), vec3(0.165, 0.545, 0.655), vec3(0.545, 0.573, 0.608),  // fin, stator, deck
    vec3(0.170, 0.185, 0.215), vec3(0.850, 0.660, 0.525), vec3(0.240, 0.560, 0.525),  // seat, skin, teal
    vec3(0.851, 0.773, 0.560), vec3(0.480, 0.360, 0.600), vec3(0.910, 0.895, 0.860),  // sand, plum, linen
    vec3(0.260, 0.200, 0.160));                                                       // hair
vec3 paint(int part) { return kPaints[clamp(part, 0, 18)]; }

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

// Returns how much of a part's surface is varnish, which reflects sun and sky.
float gloss(int part) {
  if (part == 2) return 0.12;
  if (part == 5) return 0.06;
  if (part == 7 || part >= 11) return 0.04;  // concrete, floors, seats, riders
  if (part == 8) return 0.3;
  return part == 3 || part == 4 ? 0.9 : 0.6;
}

// Returns the linear light of a painted surface; `sun`: fraction of sunlight on it.
vec3 lit(vec3 paint_light, float shiny, float sun, vec3 normal, vec3 to_eye) {
  vec3 ambient = mix(air.ground_light.rgb, air.sky_light.rgb, 0.5 + 0.5 * normal.y);
  vec3 light = paint_light * (air.sun_light.rgb * sun + ambient);
  float upright = max(dot(normal, to_eye), 0.0);
  float grazing = (1.0 - upright) * (1.0 - upright);
  float mirror = shiny * air.sun_light.w * (0.04 + 0.5 * grazing * grazing * (1.0 - upright));
  vec3 bounce = reflect(-to_eye, normal);
  vec3 seen = mix(air.ground.rgb * (air.sun_light.rgb * air.sun.y + air.sky_light.rgb),
                  sky(vec3(bounce.x, max(bounce.y, 0.0), bounce.z)), smoothstep(-0.12, 0.12, bounce.y));
  float half_way = max(dot(normal, normalize(air.sun.xyz + to_eye)), 0.0);
  vec3 shine =
      air.sun_light.rgb * shiny * (0.45 * to_90(half_way) + 0.04 * to_7(half_way * half_way)) * min(4.0 * sun, 1.0);
  return light + mirror * seen + shine * air.sun_light.w;
}

void main() {
  if (world.y * eye.y < 0.0) discard;
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
    light = lit(own, gloss(part), sun, normal, to_eye);
    if (part == 4) light += air.ground_light.w * own;
  }
#endif
  light = mix(light, mist(-to_eye), (by_value ? 0.45 : 0.9) * fog(metres, eye.y));
  colour = vec4(encode(light), 1.0);
}
