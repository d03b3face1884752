// Between the lids alone.
#include "eye_lids.glsl"
in vec3 in_head;
layout(location = 0) out vec4 colour;

void main() {
  vec3 d = normalize(in_head);
  if (d.y > UpperLid(d.x) || d.y < LowerLid(d.x)) discard;
  colour = vec4(0.05, 0.09, 0.10, 1.0);
}
