#include "frame.glsl"
layout(location = 0) in vec3 position;
void main() {
  vec3 n = vec3(0.0, 0.0, 1.0);
  gl_Position = projection * vec4(HeadToCamera(position, n), 1.0);
}
