// A poster's print: white paper, dots of an ink in the surface's own colour where it is shaded, and a dark ink.
// Dots are fixed to the picture and stand in rows at 45 degrees.
uniform vec3 print;  // x: share 0..1; y: the light's exposure; z: radians of a dot's wave for each pixel.
const vec3 kPaper = vec3(0.91, 0.86, 0.76);
const vec3 kDarkInk = vec3(0.016, 0.011, 0.030);

// Between 0 midway between dots and 1 at their middles.
float DotWave(vec2 pixel) {
  vec2 turned = vec2(pixel.x + pixel.y, pixel.x - pixel.y) * (0.70710678 * print.z);
  return 0.5 + 0.25 * (cos(turned.x) + cos(turned.y));
}

// How much of a pixel an ink covers whose dots take up `share` of the paper.
float Inked(float wave, float share) {
  float soft = 0.08 + 0.10 * print.z;
  return smoothstep(-soft, soft, wave - 1.0 + share * (1.0 + 2.0 * soft) - soft);
}

vec3 InkOf(vec3 light) {
  vec3 hue = light / max(max(light.r, max(light.g, light.b)), 1e-4);
  return hue * hue * sqrt(hue) * 0.80;
}

vec3 Printed(vec3 light) {
  vec3 lit = light / max(print.y, 1e-3);
  float tone = sqrt(dot(lit, vec3(0.2126, 0.7152, 0.0722)));
  float wave = DotWave(gl_FragCoord.xy);
  vec3 inked = mix(kPaper, InkOf(lit), Inked(wave, 1.0 - smoothstep(0.44, 0.76, tone)));
  inked = mix(inked, kDarkInk, Inked(wave, 1.0 - smoothstep(0.12, 0.34, tone)));
  return mix(light, inked * print.y, print.x);
}
