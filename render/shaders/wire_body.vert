// The dark body behind the wires: hides what lies behind, and glows faintly at its edges.
#include "frame.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 3) in vec2 uv;
uniform vec3 paint;
out vec3 lit;
out float there;   // 0..1: less and less of the neck, down to its lower edge.

void main() {
  vec3 n = normal;
  vec3 p = HeadToCamera(position, n);
  float edge = 1.0 - abs(dot(n, normalize(-p)));
  there = smoothstep(0.01, 0.15, uv.y);   // As wire.cpp.
  lit = paint * (0.004 + 0.11 * edge * edge * there) * key.w;
  gl_Position = projection * vec4(p, 1.0);
}
