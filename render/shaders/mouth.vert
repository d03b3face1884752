// Teeth and tongue: rigid, deep in the mouth, so mostly shade.
#include "frame.glsl"
#include "light.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float open;
uniform vec4 fit;      // xyz: offset; w: scale about the anchor.
uniform vec3 anchor;
uniform vec3 paint;
uniform vec2 look;     // x: wet shine; y: light that reaches in, 0..1.
out vec3 lit;

void main() {
  vec3 n = normal;
  vec3 p = HeadToCamera((position - anchor) * fit.w + anchor + fit.xyz, n);
  float light = (0.62 * Ramp(dot(n, key.xyz), 0.5) + 0.22) * open * look.y;
  float h = clamp(dot(n, normalize(key.xyz + normalize(-p))), 0.0, 1.0);
  lit = (paint * light + look.x * pow(h, 30.0) * open * look.y) * key.w;
  gl_Position = projection * vec4(p, 1.0);
}
