#include "frame.glsl"
layout(location = 0) in vec3 position;
uniform vec3 paint;
flat out vec3 lit;
void main() {
  vec3 n = vec3(0.0, 0.0, 1.0);
  lit = sqrt(paint * key.w);
  gl_Position = projection * vec4(HeadToCamera(position, n), 1.0);
}
