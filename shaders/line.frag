// A thin antialiased line, without lighting or tone mapping.
in float across;
flat in float width;
flat in vec4 tint;
out vec4 colour;

void main() { colour = vec4(tint.rgb, tint.a * coverage(across, width)); }
