// Facets of the cage: one colour, one normal each.
#include "frame.glsl"
#include "light.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform vec3 paint;
flat out vec3 lit;

void main() {
  vec3 n = normal;
  vec3 p = HeadToCamera(position, n);
  float sky = SkyShare(n);
  float key_light = 0.85 * max(dot(n, key.xyz), 0.0);
  lit = sqrt(paint * key.w * (key_light + 0.06 + 0.07 * sky));
  gl_Position = projection * vec4(p, 1.0);
}
