#include "dither.glsl"
in vec3 backdrop;
layout(location = 0) out vec4 colour;
void main() { colour = vec4(Dithered(backdrop), 1.0); }
