// The look of 1993: a textured cage under one lamp.
#include "frame.glsl"
#include "light.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 3) in vec2 place;
out vec3 lit;   // x: light; yz: texture place.

void main() {
  vec3 n = normal;
  vec3 p = HeadToCamera(position, n);
  lit = vec3(PlainLight(n) * key.w, place);
  gl_Position = projection * vec4(p, 1.0);
}
