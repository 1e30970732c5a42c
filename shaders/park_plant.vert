// Trees, bushes and rocks, lit by vertex; with SHADOW as seen from the sun.
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec4 paint;  // square roots of linear light; a: ambient light
layout(location = 4) in vec4 foot;   // w: size
layout(location = 5) in vec2 turn;   // cosine and sine
layout(location = 6) in vec4 look;   // tint, sun at the crown, half of the lamps' light, sinking in parts of 8 m
uniform mat4 view_projection;
#ifdef SHADOW
out vec3 world;
#else
uniform vec3 eye;
uniform float snow;  // 0..1, on what faces up
uniform float sunk;  // part of the sinking: 1 where the land is drawn coarsely
uniform float room;  // m about the eye that plants leave free
out vec3 light;      // with the air before it
#endif

vec3 turned(vec3 at) { return vec3(turn.x * at.x - turn.y * at.z, at.y, turn.y * at.x + turn.x * at.z); }

void main() {
  vec3 at = foot.xyz + foot.w * turned(position * vec3(0.9 + 0.25 * look.x, 1.0, 0.9 + 0.25 * look.x));
#ifndef SHADOW
  at.y -= 8.0 * sunk * look.w;
#endif
  gl_Position = view_projection * vec4(at, 1.0);
#ifdef SHADOW
  world = at;
#else
  if (distance(foot.xyz + vec3(0.0, 4.0 * foot.w, 0.0), eye) < room) gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
  vec3 up = turned(normal.xyz), own = paint.rgb * paint.rgb;
  own *= 0.92 * mix(vec3(0.72, 0.86, 0.75), vec3(1.45, 1.18, 0.95), look.x);
  own = mix(own, vec3(0.74, 0.78, 0.84), snow * smoothstep(0.05, 0.6, up.y) * smoothstep(0.3, 0.9, paint.a));
  float reach = look.y;
  for (int i = 0; i < taps; ++i) {  // once where the map may shade plants, else never
    vec3 there = (track_light * vec4(at + 1.2 * up + air.sun.xyz, 1.0)).xyz;
    vec2 edge = 0.5 - abs(there.xy - 0.5);
    reach *= min(edge.x, edge.y) > 0.0 ? textureLod(track_depth, vec3(there.xy, min(there.z, 1.0)), 0.0) : 1.0;
  }
  vec3 to_plant = normalize(at - eye);
  float through = 0.35 * max(dot(to_plant, air.sun.xyz), 0.0) * paint.a * reach;
  float direct = 1.15 * max(0.25 + 0.75 * dot(up, air.sun.xyz), 0.0) * mix(0.22, 1.05, paint.a) * reach;
  vec3 ambient = mix(air.ground_light.rgb, air.sky_light.rgb, 0.5 + 0.5 * up.y);
  float glow = 2.0 * look.z * (1.0 - 0.5 * up.y) * max(1.2 - 0.09 * position.y, 0.0);
  light = own * (air.sun_light.rgb * (direct + through * vec3(1.1, 1.2, 0.5)) + 1.1 * paint.a * ambient +
                 glow * vec3(1.0, 0.62, 0.30));
  vec4 before = air_before(at, eye);
  light = light * (1.0 - before.w) + before.rgb;
#endif
}
