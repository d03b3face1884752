// Steel shafts, heads of glass. Whoever works at the face must see them on a dark stage, too.
#include "frame.glsl"
#include "light.glsl"
in vec3 normal;
flat in vec3 paint;
flat in float tint;
in float on_head;
uniform float opacity;
layout(location = 0) out vec4 colour;
const vec3 kSteel = vec3(0.34, 0.36, 0.40);
const vec3 kLamp = vec3(-0.38, 0.55, 0.74);
const float kDimmest = 0.5;

void main() {
  vec3 n = normalize(normal);
  vec3 c = mix(mix(kSteel, paint, tint), paint, step(0.5, on_head));
  float lit = 0.42 + 0.58 * Ramp(dot(n, kLamp), 0.4);
  float rim = pow(1.0 - max(n.z, 0.0), 3.0);
  float glint = smoothstep(0.90, 0.985, dot(n, kLamp)) * on_head;
  vec3 light = (c * lit + 0.10 * rim + 0.85 * glint) * max(key.w, kDimmest);
  colour = vec4(Coded(light).rgb, opacity);
}
