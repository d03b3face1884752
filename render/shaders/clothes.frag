// CHANGING: clothes of several faces share the picture, each pixel shows one of them. Their order runs in arcs about the
// neck, from the collar to the lower corners of the picture. What replaces each other is of one colour meanwhile, so the
// border needs no dots to be soft.
in vec3 lit;
layout(location = 0) out vec4 colour;
#ifdef CHANGING
uniform vec4 fit;          // x, y: these clothes are seen where the order lies within [x, y).
uniform vec3 collar_px;    // xy: the collars' place on the layer; z: how far from there clothes reach.
const float kFlat = 0.45;  // Shoulders are wider than they are high, and so are the arcs.

float Order() {
  vec2 away = (gl_FragCoord.xy - collar_px.xy) * vec2(kFlat, 1.0);
  away.y = min(away.y, 0.0);
  return clamp(length(away) / collar_px.z, 0.0, 1.0);
}
#endif

void main() {
#ifdef CHANGING
  float order = Order();
  if (order < fit.x || order >= fit.y) discard;
#endif
  colour = vec4(sqrt(max(lit, 0.0)), 1.0);
}
