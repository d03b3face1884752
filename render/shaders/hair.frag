// Stripes along the lock, none on hard things (`across` far below 0); with GROWTH only its first part is there, and ends softly.
in vec4 lit;       // rgb; a: highlight.
in vec2 uv;     // Across the stripes, along the lock.
uniform vec3 gleam;
#ifdef GROWTH
uniform float grown;
#endif
layout(location = 0) out vec4 colour;

float Zigzag(float x) { return abs(fract(x) - 0.5); }

void main() {
  float stripe = uv.x < -50.0 ? 0.55 : Zigzag(uv.x * 3.0 + 0.3 * uv.y) + Zigzag(uv.x * 7.3) * 0.8 + Zigzag(uv.x * 12.7) * 0.6;
  vec3 c = lit.rgb * (0.62 + 0.63 * stripe) + gleam * (lit.a * (0.35 + 1.08 * stripe));
  float present = 1.0;
#ifdef GROWTH
  float left = grown - uv.y - 0.10 * stripe;
  if (left <= 0.0) discard;
  present = clamp(left * 12.0, 0.0, 1.0);
#endif
  colour = vec4(sqrt(max(c, 0.0)), present);  // Beyond a triangle's edge light may fall below 0.
}
