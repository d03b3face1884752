// Stripes along the lock; with GROWTH only its first part is there, and ends softly.
in vec4 lit;
in vec4 gleam;
uniform sampler2D stripes;
#ifdef GROWTH
uniform float grown;
#endif
layout(location = 0) out vec4 colour;

void main() {
  float stripe = texture(stripes, vec2(gleam.a, lit.a * 0.3)).r;
  vec3 c = lit.rgb * (0.62 + 0.76 * stripe) + gleam.rgb * (0.35 + 1.3 * stripe);
  float present = 1.0;
#ifdef GROWTH
  float left = grown - lit.a - 0.12 * stripe;
  if (left <= 0.0) discard;
  present = clamp(left * 12.0, 0.0, 1.0);
#endif
  colour = vec4(sqrt(c), present);
}
