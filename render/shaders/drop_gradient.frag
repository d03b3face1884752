#include "drop.glsl"
void main() { colour = vec4(sqrt(mix(bottom, top, uv.y * 0.5 + 0.5)), 1.0); }
