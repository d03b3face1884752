// CHANGING: clothes of several faces share the picture, each pixel shows one of them. Their order runs from the
// collar to the lower edge of the picture, and is dithered, so that the border between two is soft.
in vec3 lit;
layout(location = 0) out vec4 colour;
#ifdef CHANGING
uniform vec4 fit;          // x, y: these clothes are seen where the order lies within [x, y).
uniform float collar_px;   // The collars' height in the picture.
const float kSoftBorder = 0.3;  // Of the order's range.

// Interleaved gradient noise (Jimenez 2014): 0..1, even over any few neighbours.
float Noise() { return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))); }

float Order() {
  float down = clamp(1.0 - gl_FragCoord.y / max(collar_px, 1.0), 0.0, 1.0);
  return mix(down, Noise(), kSoftBorder);
}
#endif

void main() {
#ifdef CHANGING
  float order = Order();
  if (order < fit.x || order >= fit.y) discard;
#endif
  colour = vec4(sqrt(max(lit, 0.0)), 1.0);
}
