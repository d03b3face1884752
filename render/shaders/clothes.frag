in vec3 lit;
uniform float opacity;
layout(location = 0) out vec4 colour;
void main() { colour = vec4(sqrt(max(lit, 0.0)), opacity); }
