// One colour over the viewport, blended by the coverage accumulated in the target's alpha.
uniform vec4 paint;
out vec4 colour;

void main() { colour = paint; }
