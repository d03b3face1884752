// A picture of the show's own, a little out of focus; it covers the whole stage.
#include "drop.glsl"
uniform sampler2D picture;
uniform vec2 cover;   // How much of the picture is seen, across and up; 1: all.

vec3 At(vec2 offset) {
  vec3 root = texture(picture, (uv / vec2(3.5555556, 2.0) + offset) * cover + 0.5).rgb;
  return root * root;
}

void main() {
  vec2 step_size = vec2(1.0 / 384.0, 1.0 / 216.0);
  vec3 light = 2.0 * At(vec2(0.0));
  light += At(step_size) + At(-step_size) + At(step_size * vec2(1.0, -1.0)) + At(step_size * vec2(-1.0, 1.0));
  colour = vec4(sqrt(light / 6.0), 1.0);
}
