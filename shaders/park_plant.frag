// The light of a plant.
in vec3 light;
out vec4 colour;

void main() { colour = vec4(encode(light), 1.0); }
