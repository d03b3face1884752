// Stripes along the lock, none on hard things (`across` far below 0). With GROWTH only the lock's first part is there and
// ends in strands; and hair of several faces shares the picture from the crown down, each pixel shows one of them.
in vec4 lit;       // rgb; a: highlight.
in vec2 uv;     // Across the stripes, along the lock.
uniform vec3 gleam;
#ifdef GROWTH
uniform vec2 grown;   // As hair.vert.
uniform vec3 part;    // xy: it is seen where the order lies within [x, y); z: how soft the border is.
uniform vec2 span_px;  // Height in the picture of the crown, and from there down to the tips.
#endif
layout(location = 0) out vec4 colour;

float Zigzag(float x) { return abs(fract(x) - 0.5); }

#ifdef GROWTH
// Interleaved gradient noise (Jimenez 2014): 0..1, even over any few neighbours.
float Noise() { return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))); }

bool Elsewhere() {
  float down = clamp((span_px.x - gl_FragCoord.y) / span_px.y, 0.0, 1.0);
  float order = mix(down, Noise(), part.z);
  return order < part.x || order >= part.y;
}
#endif

void main() {
  float stripe = uv.x < -50.0 ? 0.55 : Zigzag(uv.x * 3.0 + 0.3 * uv.y) + Zigzag(uv.x * 7.3) * 0.8 + Zigzag(uv.x * 12.7) * 0.6;
  vec3 c = lit.rgb * (0.62 + 0.63 * stripe) + gleam * (lit.a * (0.35 + 1.08 * stripe));
  float present = 1.0;
#ifdef GROWTH
  float left = grown.x - uv.y - 0.26 * stripe;
  if (left <= 0.0 || Elsewhere()) discard;
  present = clamp(left * 12.0, 0.0, 1.0);
#endif
  colour = vec4(sqrt(max(c, 0.0)), present);  // Beyond a triangle's edge light may fall below 0.
}
