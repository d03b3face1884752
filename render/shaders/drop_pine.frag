// The board behind a Noh stage: an old pine, painted on planks.
#include "drop.glsl"

vec3 Planks() {
  float across = uv.y * 3.1;
  float seam = 1.0 - 0.30 * Below(abs(fract(across) - 0.5), 0.006, 0.02);
  float tone = 0.90 + 0.20 * Spread(floor(across + 0.5) + 11.0).x;
  float grain = 1.0 + 0.05 * sin(uv.y * 70.0 + 2.0 * sin(uv.x * 2.3)) * sin(uv.x * 3.0 + floor(across) * 2.0);
  return Wall() * seam * tone * grain;
}

// A pad of needles: a flat cloud with a scalloped upper edge.
float Needles(vec2 centre, vec2 size) {
  vec2 d = (uv - centre) / size;
  float scallop = 0.11 * abs(sin(d.x * 6.5)) * step(0.0, d.y);
  float belly = d.y < 0.0 ? d.y * d.y * 6.0 : d.y * d.y;
  return Below(d.x * d.x + belly, 0.86 + scallop, 0.10);
}

float Trunk() {
  float x = -0.62 + 0.34 * sin(uv.y * 2.3 + 0.6) + 0.10 * sin(uv.y * 6.0);
  float branch = Below(abs(uv.y - 0.26 - 0.16 * sin(uv.x * 2.2)), 0.035, 0.02) * Below(abs(uv.x - 0.25), 1.0, 0.06);
  return max(Below(abs(uv.x - x), 0.13 - 0.05 * uv.y, 0.025), branch);
}

void main() {
  vec3 light = Planks() * (0.62 + 0.62 * Pool(vec2(0.0, 0.1), vec2(1.3, 0.9)));
  light = mix(light, bottom * vec3(0.32, 0.24, 0.18), 0.92 * Trunk());
  float pads = 0.0;
  pads = max(pads, Needles(vec2(-1.15, 0.48), vec2(0.52, 0.19)));
  pads = max(pads, Needles(vec2(-0.25, 0.78), vec2(0.60, 0.20)));
  pads = max(pads, Needles(vec2(0.72, 0.56), vec2(0.48, 0.17)));
  pads = max(pads, Needles(vec2(1.22, 0.20), vec2(0.46, 0.16)));
  pads = max(pads, Needles(vec2(-1.42, -0.02), vec2(0.40, 0.15)));
  pads = max(pads, Needles(vec2(0.66, -0.18), vec2(0.38, 0.13)));
  vec3 green = glow * (0.62 + 0.30 * sin(uv.x * 46.0 + 3.0 * sin(uv.y * 9.0)) * 0.4);
  Show(mix(light, green, 0.94 * pads));
}
