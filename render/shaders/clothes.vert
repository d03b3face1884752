// Shoulders: they breathe, but do not turn with the head.
#include "frame.glsl"
#include "light.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float open;
uniform vec3 paint;
uniform float sunk_m;
out vec3 lit;

void main() {
  vec3 n = mat3(view) * normal;
  vec3 breathing = position * vec3(1.0 + 3.0 * up.w, 1.0, 1.0 + 3.0 * up.w);
  vec3 p = (view * vec4(breathing + vec3(0.0, up.w - sunk_m, 0.0), 1.0)).xyz;
  float edge = 1.0 - clamp(dot(n, normalize(-p)), 0.0, 1.0);
  float sky = SkyShare(n);
  vec3 soft = paint * (Ramp(dot(n, key.xyz), 0.4) * kKeyColour * 0.85 + kSky * (0.5 + 0.7 * sky)) * open;
  soft += edge * edge * edge * 0.05 * (0.3 + 0.7 * sky) * open;
  lit = mix(paint * PlainLight(n) * key.w, Shoulder(soft * key.w), fill.w);
  gl_Position = projection * vec4(p, 1.0);
}
