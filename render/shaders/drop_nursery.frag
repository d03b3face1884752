// A child's room: dots on the wallpaper, a striped wainscot, a string of lanterns, a warm lamp.
#include "drop.glsl"
void main() {
  vec2 cell = uv * 3.4 + vec2(0.5 * mod(floor(uv.y * 3.4), 2.0), 0.0);
  float dots = Below(length(fract(cell) - 0.5), 0.17, 0.09);
  vec3 light = Wall() * (1.0 + 0.22 * dots);
  float stripe = smoothstep(-0.5, 0.5, sin(uv.x * 20.0));
  float wainscot = Below(uv.y, -0.52, 0.018);
  light = mix(light, bottom * mix(0.80, 1.15, stripe), wainscot);
  light = mix(light, top * 1.25, Below(abs(uv.y + 0.50), 0.024, 0.014));
  vec2 lamp = vec2(1.28, 0.05);
  light *= 0.62 + 1.15 * glow * Pool(lamp, vec2(0.95, 0.85)) + 0.30 * Pool(vec2(0.0), vec2(0.8));
  light = mix(light, glow * 1.05, 0.92 * Disc(lamp, 0.17, 0.05));
  for (int i = 0; i < 11; ++i) {
    float x = 0.35 * (float(i) - 5.0);
    float hue = mod(float(i), 3.0);
    vec3 paint = hue < 0.5 ? vec3(0.85, 0.22, 0.20) : (hue < 1.5 ? vec3(0.95, 0.62, 0.12) : vec3(0.16, 0.45, 0.62));
    vec2 centre = vec2(x, 0.60 + 0.11 * x * x);
    light = mix(light, paint * 0.85 + 0.10, 0.92 * Lamp(centre, 0.085));
  }
  Show(light);
}
