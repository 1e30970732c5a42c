// Four control points are a patch; the levels set the number of its lines: none for an empty slot.
layout(vertices = 4) out;
in vec3 handed[];
flat in int piece[];
flat in int slot_of[];
out vec3 control[];
patch out int first;
patch out int count;
patch out int patch_slot;
uniform int steps;
const int kLevel = 64;  // every driver supports levels of 64

void main() {
  control[gl_InvocationID] = handed[gl_InvocationID];
  first = piece[0] * kLevel;
  count = min(kLevel, steps - first);
  patch_slot = slot_of[0];
  gl_TessLevelOuter[0] = handed[0].x > kBreak ? 0.0 : 1.0;
  gl_TessLevelOuter[1] = float(count);
}
