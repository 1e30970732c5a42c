// The factor by which shadows darken the ground's colour on the screen; runs only where ground.frag has marked a
// possible shadow.
uniform vec3 eye;
uniform vec3 eye_right, eye_up;  // of an orthographic view: from its middle to its edges; else 0
in vec3 direction;
in vec2 across;
out vec4 colour;

void main() {
  vec3 sight = normalize(direction);
  float metres = eye.y / max(-sight.y, 1e-5);
  vec2 place = eye.xz + across.x * eye_right.xz + across.y * eye_up.xz + sight.xz * metres;
  float shade = air.ink.w * ground_shadow(place, dFdx(place), dFdy(place));
  vec3 sun = air.sun_light.rgb * air.sun.y, sky_light = air.sky_light.rgb;
  vec3 lit = air.ground.rgb * mix(sun + sky_light, vec3(1.0), air.sun.w),
       left = air.ground.rgb * mix(sun * (1.0 - shade) + sky_light, vec3(1.0 - shade), air.sun.w);
  vec3 far = mist(sight);
  float much = fog(metres, eye.y);
  colour = vec4(encode(mix(left, far, much)) / encode(mix(lit, far, much)), 1.0);
}
