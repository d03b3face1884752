uniform vec3 paint;
layout(location = 0) out vec4 colour;
void main() { colour = vec4(sqrt(paint), 1.0); }
