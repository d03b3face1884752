// A moon over hills, and the lights of a town far away.
#include "drop.glsl"
const vec2 kMoon = vec2(1.02, 0.52);

vec3 Town() {
  vec3 light = vec3(0.0);
  for (int i = 0; i < 34; ++i) {
    vec2 at = Spread(float(i) + 0.5);
    vec2 centre = vec2(3.7 * at.x - 1.85, -0.97 + 0.52 * at.y * at.y);
    float radius = 0.035 + 0.045 * fract(at.x * 17.0);
    vec3 hue = mix(glow, vec3(1.0, 0.42, 0.12), fract(at.y * 7.0));
    light += hue * Lamp(centre, radius) * (0.16 + 0.34 * fract(at.x * 29.0));
  }
  return light;
}

float Stars() {
  float light = 0.0;
  for (int i = 0; i < 26; ++i) {
    vec2 at = Spread(float(i) + 40.25);
    light += Disc(vec2(3.6 * at.x - 1.8, 1.15 * at.y - 0.12), 0.008 + 0.007 * fract(at.x * 13.0), 0.012);
  }
  return light;
}

void main() {
  vec3 sky = mix(bottom, top, smoothstep(-0.55, 1.0, uv.y));
  sky += glow * (0.060 * Pool(kMoon, vec2(0.85)) + 0.20 * Pool(kMoon, vec2(0.34)));
  sky += 0.16 * Stars();
  vec2 d = uv - kMoon;
  float spots = 0.16 * (Disc(kMoon + vec2(-0.05, 0.05), 0.05, 0.04) + Disc(kMoon + vec2(0.06, -0.04), 0.07, 0.05));
  sky = mix(sky, mix(vec3(1.0), glow, 0.4) * (0.80 - spots + 0.10 * d.x), Disc(kMoon, 0.185, 0.014));
  float ridge = -0.40 + 0.10 * sin(uv.x * 1.7 + 0.6) + 0.05 * sin(uv.x * 3.9);
  sky = mix(sky, bottom * 0.55, Below(uv.y, ridge, 0.03));
  Show(sky + Town());
}
