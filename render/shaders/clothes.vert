// Shoulders: they breathe and lean with the head, but do not turn with it. CHANGING: they are fitted to a neck
// that is shared with another face's clothes.
#include "frame.glsl"
#include "light.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float open;
uniform vec3 paint;
out vec3 lit;
#ifdef CHANGING
uniform vec4 fit;    // x, y: see clothes.frag; z: rises by, metres; w: widens about the neck by, metres.
uniform vec3 neck;   // xy: the neck's axis, x and z; z: clothes sink by, metres.
// In even steps from the middle outwards, metres below the collar, x: of these clothes, y: of all together. Then their half widths.
uniform vec4 outline[17];

vec2 BelowCollar(vec2 across_m) {
  vec2 at = min(across_m / outline[16].xy, 1.0) * 15.0;
  ivec2 step = min(ivec2(at), ivec2(14));
  vec2 share = at - vec2(step);
  return vec2(mix(outline[step.x].x, outline[step.x + 1].x, share.x),
              mix(outline[step.y].y, outline[step.y + 1].y, share.y));
}

// About the neck clothes keep to it; beyond it all have one outline.
vec3 Fitted(vec3 p) {
  vec2 away = p.xz - neck.xy;
  float from_neck = max(length(away), 1e-4);
  float beyond = smoothstep(0.05, 0.14, from_neck);
  float sewn = abs(p.x);
  p.xz += away / from_neck * (fit.w * (1.0 - beyond));
  p.x *= mix(1.0, outline[16].y / outline[16].x, beyond);
  vec2 below = BelowCollar(vec2(sewn, abs(p.x)));
  p.y += fit.z - neck.z + (below.x - below.y) * smoothstep(0.04, 0.08, from_neck);
  return p;
}
#endif

void main() {
  vec3 n = mat3(view) * normal;
  vec3 p = position;
#ifdef CHANGING
  p = Fitted(p);
#endif
  vec3 breathing = p * vec3(1.0 + 3.0 * up.w, 1.0, 1.0 + 3.0 * up.w) + vec3(0.0, up.w, 0.0);
  p = (view * vec4(breathing + shift.xyz * LeanShare(p.y), 1.0)).xyz;
  float edge = 1.0 - clamp(dot(n, normalize(-p)), 0.0, 1.0);
  float sky = SkyShare(n);
  vec3 soft = paint * (Ramp(dot(n, key.xyz), 0.4) * kKeyColour * 0.85 + kSky * (0.5 + 0.7 * sky)) * open;
  soft += edge * edge * edge * 0.05 * (0.3 + 0.7 * sky) * open;
  lit = mix(paint * PlainLight(n) * key.w, Shoulder(soft * key.w), fill.w);
  gl_Position = projection * vec4(p, 1.0);
}
