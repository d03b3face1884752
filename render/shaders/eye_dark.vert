#include "frame.glsl"
layout(location = 0) in vec3 direction;
uniform vec4 ball;   // xyz centre, w radius, metres.
out vec3 in_head;    // The point in the head's frame.

void main() {
  vec3 n = direction;
  in_head = direction;
  gl_Position = projection * vec4(HeadToCamera(ball.xyz + ball.w * direction, n), 1.0);
}
