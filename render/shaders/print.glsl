// A poster's print: white paper, dots of an ink in the surface's own colour where it is shaded, and a dark ink.
// Dots stand in rows at 45 degrees and go with the head, as if they were printed on it. While the print fades they melt into
// even ink, which the picture then takes up.
uniform vec2 print;  // x: share 0..1; y: the light's exposure.
uniform vec4 dots;   // xy: where the head is, pixels; zw: along a row, radians of a dot's wave for each pixel.
const vec3 kPaper = vec3(0.91, 0.86, 0.76);
const vec3 kDarkInk = vec3(0.016, 0.011, 0.030);

// Between 0 midway between dots and 1 at their middles.
float DotWave(vec2 pixel) {
  vec2 from_head = pixel - dots.xy;
  float along = dot(from_head, dots.zw);
  float across = dot(from_head, vec2(-dots.w, dots.z));
  return 0.5 + 0.25 * (cos(along) + cos(across));
}

// How much of a pixel an ink covers whose dots take up `share` of the paper.
float Inked(float wave, float share) {
  float soft = 0.08 + 0.10 * length(dots.zw) + 1.2 * (1.0 - print.x);
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
