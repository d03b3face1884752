// Stripes along the lock, none on hard things (`across` far below 0). With GROWTH only the lock's first part is there and
// ends in strands; and hair of several faces shares the picture from the crown down. At a border the lower hair comes in
// under the upper one, which then goes: one of them always covers, and neither is seen as dots.
// BY_PIXEL: strands are lit one by one, in the lamp's shadows, and end unevenly.
#if defined(GROWTH) || defined(BY_PIXEL)
#include "frame.glsl"
#endif
#ifdef BY_PIXEL
#include "light.glsl"
#include "fine_hair.glsl"
centroid in vec3 in_camera;
centroid in vec3 facing;
centroid in vec3 to_tip;
centroid in vec2 open_number;
uniform vec3 paint;
#else
centroid in vec4 lit;       // rgb; a: highlight.
#endif
in vec2 uv;     // Across the stripes, along the lock.
uniform vec3 gleam;
#ifdef GROWTH
in float left_of;     // As hair.vert.
uniform vec3 part;    // xy: it is seen where the order lies within [x, y); z: 1 for what is hard, whose share y is everywhere.
uniform vec2 span_px;  // Height on the layer of the crown, and from there down to the tips.
#endif
layout(location = 0) out vec4 colour;

float Zigzag(float x) { return abs(fract(x) - 0.5); }

#ifdef GROWTH
const float kBorder = 0.10;  // Half of it, of the order's range.

// How much of this hair covers here, by the order; strands make the border uneven.
float Share(float stripe) {
  float down = clamp((span_px.x - gl_FragCoord.y) / span_px.y + 0.10 * (stripe - 0.6), 0.0, 1.0);
  float order = down * (1.0 - 2.0 * kBorder);
  float in_under = clamp((order - part.x) / kBorder + 2.0, 0.0, 1.0);
  float not_gone = clamp((part.y - order) / kBorder, 0.0, 1.0);
  return mix(in_under * not_gone, part.y, part.z);
}
#endif

#ifdef BY_PIXEL
// Stripes that are narrower than pixels are their mean: they would be dots. `width`: of a pixel, across the stripes.
float Stripe(float x, float width) { return mix(Zigzag(x), 0.25, smoothstep(0.30, 0.80, width)); }
#else
#define Stripe(x, width) Zigzag(x)
#endif

void main() {
  bool hard = uv.x < -50.0;
#ifdef BY_PIXEL
  float width = fwidth(uv.x);
#endif
  float stripe = Stripe(uv.x * 3.0 + 0.3 * uv.y, 3.0 * width) + 0.8 * Stripe(uv.x * 7.3, 7.3 * width) + 0.6 * Stripe(uv.x * 12.7, 12.7 * width);
  stripe = hard ? 0.55 : stripe;
#ifdef BY_PIXEL
  vec4 lit = FineHair(in_camera, normalize(facing), normalize(to_tip), open_number, paint, stripe);
  float present = hard ? 1.0 : StrandLeft(uv.y, Zigzag(uv.x * 3.0 + 0.3 * uv.y) + 0.8 * Zigzag(uv.x * 7.3));
#else
  float present = 1.0;
#endif
  vec3 c = lit.rgb * (0.62 + 0.63 * stripe) + gleam * (lit.a * (0.35 + 1.08 * stripe));
#ifdef GROWTH
  float left = left_of - 0.26 * stripe;
  present *= clamp(left * 12.0, 0.0, 1.0) * Share(stripe);
#endif
#if defined(GROWTH) || defined(BY_PIXEL)
  if (present <= least.x) discard;
#endif
  colour = vec4(sqrt(max(c, 0.0)), present);  // Beyond a triangle's edge light may fall below 0.
}
