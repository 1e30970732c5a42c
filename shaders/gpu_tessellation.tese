// The polyline evaluated by the tessellation shader, as lines of equal steps; with MEASURE as its vertices, captured
// with number and slot.
#ifdef MEASURE
layout(isolines, equal_spacing, point_mode) in;
#else
layout(isolines, equal_spacing) in;
#endif
in vec3 control[];
patch in int first;
patch in int count;
patch in int patch_slot;
uniform int steps;
out vec3 place;
out float number;
out float slot;

void main() {
  int i = first + int(round(gl_TessCoord.x * float(count)));
  place = cubic_point(control[0], control[1], control[2], control[3], i, steps);
  number = float(i);
  slot = float(patch_slot);
  gl_Position = vec4(place, 1.0);
}
