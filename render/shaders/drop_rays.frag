// A poster: rays of two inks from behind the head, and a sun.
#include "drop.glsl"
void main() {
  vec2 d = uv - vec2(0.0, 0.08);
  float ray = sin(atan(d.y, d.x) * 14.0);
  float edge = 0.10 + 0.02 / max(length(d), 0.05);
  vec3 light = mix(bottom, top, smoothstep(-edge, edge, ray));
  light = mix(light, glow, Below(length(d), 0.66, 0.010));
  light = mix(light, top, Below(abs(length(d) - 0.72), 0.022, 0.010));
  Show(light);
}
