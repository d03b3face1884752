// One of the handles: a thin cone whose tip sticks in the skin, and a ball at its end.
#include "frame.glsl"
layout(location = 0) in vec3 outwards;  // Unit, along the handle's axes: z from the tip to the head.
layout(location = 1) in vec2 along;     // x: 0 the tip .. 1 the middle of the head; y: 1 on the head.
uniform sampler2D handles;              // For each: root and length, axis and the head's radius, paint and how much of it.
uniform int first;                      // The handle with which to begin.
uniform vec3 plain;                     // Of heads without paint; linear.
out vec3 normal;      // Camera's frame.
flat out vec3 paint;  // Linear.
flat out float tint;  // How much of it is on the shaft.
out float on_head;
const float kThick_m = 0.00034;  // The shaft's radius below the head.

vec4 Texel(int which) { return texelFetch(handles, ivec2(which, first + gl_InstanceID), 0); }

// Any two directions across the axis.
mat3 Axes(vec3 axis) {
  vec3 other = abs(axis.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
  vec3 side = normalize(cross(other, axis));
  return mat3(side, cross(axis, side), axis);
}

void main() {
  vec4 root = Texel(0);
  vec4 axis = Texel(1);
  vec4 own = Texel(2);
  paint = mix(plain, own.rgb, own.a);
  tint = mix(0.2, 0.7, own.a);
  on_head = along.y;
  vec3 n = axis.xyz;
  vec3 p = HeadToCamera(root.xyz, n);
  normal = Axes(n) * outwards;
  float pixel_m = 2.0 * -p.z / (projection[1][1] * sway.w);   // What a pixel measures there.
  float shaft = max(kThick_m, 0.42 * pixel_m) * mix(0.35, 1.0, along.x);
  float head = axis.w <= 0.0 ? 0.0 : max(axis.w, 1.1 * pixel_m);
  p += n * (along.x * root.w) + normal * mix(shaft, head, along.y);
  gl_Position = projection * vec4(p, 1.0);
}
