// Tiles in the light of a window, and jars on a shelf.
#include "drop.glsl"
const vec2 kWindow = vec2(-1.12, 0.42);

vec3 Tiles() {
  vec2 cell = uv / 0.26;
  vec2 in_cell = abs(fract(cell) - 0.5);
  float joint = smoothstep(0.40, 0.49, max(in_cell.x, in_cell.y));
  float tone = 0.86 + 0.28 * Spread(dot(floor(cell), vec2(7.0, 3.0)) + 200.0).x;
  return Wall() * mix(tone, 0.62, joint);
}

void main() {
  vec3 light = Tiles();
  float shine = Pool(kWindow, vec2(1.25, 1.1));
  light *= 0.55 + 1.3 * glow * shine + 0.45 * Pool(vec2(0.0), vec2(0.9, 0.8));
  vec2 pane = abs(uv - kWindow - vec2(0.0, 0.0));
  float bars = smoothstep(0.018, 0.05, min(pane.x, abs(uv.y - kWindow.y - 0.06)));
  light = mix(light, bottom * 0.9, Below(OutOfBox(kWindow, vec2(0.42, 0.46)), 0.045, 0.03));
  light = mix(light, mix(bottom, glow * vec3(0.95, 1.0, 1.0), bars), Below(OutOfBox(kWindow, vec2(0.38, 0.42)), 0.02, 0.03));
  light += glow * 0.10 * Pool(kWindow, vec2(0.75));
  light *= 1.0 - 0.55 * Below(OutOfBox(vec2(1.25, 0.215), vec2(0.60, 0.06)), 0.0, 0.07);
  light = mix(light, bottom * 0.75, Below(OutOfBox(vec2(1.25, 0.27), vec2(0.62, 0.018)), 0.004, 0.018));
  for (int i = 0; i < 4; ++i) {
    vec2 at = Spread(float(i) + 3.0);
    vec2 half_size = vec2(0.085, 0.11 + 0.08 * at.x);
    vec2 centre = vec2(0.82 + 0.27 * float(i), 0.30 + half_size.y);
    vec3 jar = mix(bottom, mix(vec3(0.60, 0.16, 0.07), vec3(0.10, 0.22, 0.18), at.y), 0.85);
    float round_light = 0.55 + 0.75 * Pool(centre - vec2(0.04, -0.03), vec2(0.06, 0.20));
    light = mix(light, jar * round_light, Below(OutOfBox(centre, half_size - 0.02), 0.02, 0.02));
  }
  Show(light);
}
