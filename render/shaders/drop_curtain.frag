// Velvet in folds, a valance above, footlights from below.
#include "drop.glsl"

// The light on a fold: 0 in its depth, 1 on its ridge; folds are never quite even.
float Fold(float x) {
  float wave = 0.5 + 0.5 * sin(x + 0.8 * sin(0.37 * x + 1.0) + 0.5 * sin(0.23 * x));
  return wave * (0.35 + 0.65 * wave);
}

void main() {
  float lean = 0.06 * sin(uv.x * 2.1) * (uv.y - 1.0);
  vec3 cloth = Wall() * (0.16 + 1.05 * Fold(uv.x * 17.0 + lean * 17.0));
  float foot = exp(-1.7 * (uv.y + 1.0));
  vec3 light = cloth * (0.75 + glow * (0.9 * foot + 0.9 * Pool(vec2(0.0, 0.10), vec2(1.0, 0.75))));
  float hem = 0.80 - 0.11 * abs(sin(uv.x * 2.65 + 1.5708));
  light *= 1.0 - 0.62 * Below(abs(uv.y - hem + 0.12), 0.02, 0.14);
  vec3 valance = Wall() * (0.10 + 0.60 * Fold(uv.x * 23.0 + 2.0)) * (1.0 - 0.5 * smoothstep(hem, 1.1, uv.y));
  light = mix(light, valance, smoothstep(hem - 0.025, hem + 0.025, uv.y));
  float fringe = Below(abs(uv.y - hem - 0.015), 0.022, 0.014);
  Show(mix(light, glow * vec3(0.55, 0.34, 0.10) * (0.35 + 0.65 * Fold(uv.x * 60.0)), 0.8 * fringe));
}
