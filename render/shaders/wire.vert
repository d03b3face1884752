// One line as a ribbon of constant width on the screen. Its ends are looked up by number.
#include "frame.glsl"
layout(location = 0) in uvec2 ends;
layout(location = 1) in vec2 corner;   // x: at which end, 0 or 1; y: on which side, -1 or 1.
uniform sampler2D points;              // xyz: metres, head's frame; w: brightness.
uniform vec3 paint;
out vec3 across;      // x: pixels from the middle of the line; y: brightness; z: half the width in pixels.

vec4 Point(uint number) { return texelFetch(points, ivec2(int(number & 63u), int(number >> 6)), 0); }

// What is near glows, what is far dims: 0.3 behind the head, above 1 at the tip of the nose.
float Nearness(vec3 q) {
  float middle = (view * vec4(pivot.xyz + shift.xyz, 1.0)).z;
  return 0.30 + 1.05 * smoothstep(-0.075, 0.115, q.z - middle);
}

vec4 Project(vec3 p, inout float brightness) {
  vec3 n = vec3(0.0, 0.0, 1.0);
  vec3 q = HeadToCamera(p, n);
  brightness *= Nearness(q) * key.w;
  return projection * vec4(q * 0.998, 1.0);   // A little nearer than the surface that it lies on.
}

void main() {
  vec4 a = Point(ends.x);
  vec4 b = Point(ends.y);
  vec4 from = Project(a.xyz, a.w);
  vec4 to = Project(b.xyz, b.w);
  vec2 half_size = 0.5 * sway.zw;
  vec2 way = to.xy / to.w * half_size - from.xy / from.w * half_size;
  vec2 side = normalize(vec2(-way.y, way.x) + vec2(1e-6, 0.0));
  float half_width_px = 0.62 * max(1.0, sway.w / 900.0);   // Lines grow with the layer.
  float reach = half_width_px + 1.0;
  gl_Position = corner.x < 0.5 ? from : to;
  gl_Position.xy += side * corner.y * reach / half_size * gl_Position.w;
  across = vec3(corner.y * reach, mix(a.w, b.w, corner.x), half_width_px);
}
