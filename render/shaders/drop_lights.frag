// Many lamps on the racks of a dark laboratory.
#include "drop.glsl"
void main() {
  float rack = 0.5 + 0.5 * cos(uv.y * 11.0);
  vec3 light = Wall() * (0.70 + 0.30 * rack) + glow * Wall() * Pool(vec2(0.0, 0.1), vec2(1.1, 0.8));
  for (int i = 0; i < 54; ++i) {
    vec2 at = Spread(float(i) + 7.5);
    float row = floor(at.y * 7.0) / 3.5 - 0.86;
    vec2 centre = vec2(3.8 * at.x - 1.9, row + 0.05 * fract(at.x * 31.0));
    float radius = 0.030 + 0.075 * pow(fract(at.x * 19.0), 2.0);
    float pick = fract(at.y * 11.0 + at.x * 5.0);
    vec3 hue = mix(glow, mix(vec3(1.0, 0.35, 0.10), vec3(0.20, 0.45, 1.0), step(0.8, pick)), step(0.62, pick));
    light += hue * Lamp(centre, radius) * (0.05 + 0.30 * fract(at.x * 43.0)) * (1.0 - 0.6 * Disc(vec2(0.0), 0.3, 0.4));
  }
  Show(light);
}
