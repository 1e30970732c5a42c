// One colour over the viewport; blending takes how much of it from the coverage gathered in the target's alpha.
uniform vec4 paint;
out vec4 colour;

void main() { colour = paint; }
