// The look of 1993: a textured cage under one lamp. Codes are multiplied, not light: a power of a product is the
// product of powers.
#include "frame.glsl"
#include "light.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 3) in vec2 place;
out vec3 lit;   // x: light, coded; yz: texture place.

void main() {
  vec3 n = normal;
  vec3 p = HeadToCamera(position, n);
  lit = vec3(Code(vec3(PlainLight(n) * key.w)).x, place);
  gl_Position = projection * vec4(p, 1.0);
}
