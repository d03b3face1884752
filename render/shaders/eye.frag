#include "frame.glsl"
#include "light.glsl"
#include "eye_lids.glsl"
in vec3 ahead;
in vec3 in_head;
in vec2 shade;
in vec3 deeper;
uniform vec4 iris;    // rgb; a: its radius, in radii of the ball.
uniform vec4 white;   // rgb; a: veins.
uniform vec4 drawn;   // x: the pupil's radius, of the iris's; y: dark (or, below 0, pale) rim; z: spokes; w: rings of a lens.
uniform vec2 answer;  // x: wet; y: light of its own.
flat in vec3 glint_at;  // See eye.vert.
flat in float glint_size;
layout(location = 0) out vec4 colour;
const vec3 kVein = vec3(0.80, 0.50, 0.45);
const float kDepth = 0.10;  // Of the iris behind the cornea, radii of the ball.

// Fine spokes: a few sines that do not repeat visibly.
float Spokes(float angle, float r) {
  return 0.25 * sin(angle * 23.0 + 3.0 * sin(angle * 5.0)) + 0.25 * sin(angle * 37.0 + 9.0 * r);
}

// Lit from above, an iris glows at its far side, below.
vec3 IrisColour(float r, vec2 at) {
  float below = (1.0 - smoothstep(-1.0, 0.5, at.y));
  vec3 c = iris.rgb * mix(0.50 + 1.15 * below, 1.0, answer.y) * (0.99 + 0.34 * drawn.z * Spokes(atan(at.y, at.x), r));
  float rim = smoothstep(0.74, 1.0, r);
  c = mix(c * (1.0 - max(drawn.y, 0.0) * rim), vec3(0.62, 0.66, 0.68), 0.7 * max(-drawn.y, 0.0) * rim);
  c *= 1.0 - 0.6 * drawn.w * smoothstep(0.55, 0.85, abs(fract(r * 3.0) * 2.0 - 1.0));
  return c * (1.0 - 0.95 * (1.0 - smoothstep(drawn.x - 0.04, drawn.x + 0.04, r)));
}

// Lids shade the ball below them, and most in the corners where they meet.
float LidShade(float under_upper, float over_lower) {
  float upper = 0.62 * (1.0 - smoothstep(0.02, 0.48, under_upper));
  float lower = 0.30 * (1.0 - smoothstep(0.0, 0.16, over_lower));
  float corner = 0.34 * (1.0 - smoothstep(0.10, 0.50, under_upper + over_lower));
  return (1.0 - upper) * (1.0 - lower) * (1.0 - corner);
}

void main() {
  vec2 at = ahead.xy / iris.a;
  float r = length(at);
  float blur = fwidth(r);
  at -= deeper.xy * (kDepth / iris.a * max(1.0 - r * r, 0.0));
  vec3 ball = mix(white.rgb, white.rgb * kVein, white.a * smoothstep(0.55, 0.95, shade.y));
  vec3 c = mix(IrisColour(min(length(at), r + 0.2), at), ball, smoothstep(1.0 - blur, 1.04 + blur, r));
  float soft = fill.w;
  vec3 d = normalize(in_head);
  float over_lower = d.y - LowerLid(d.x);
  float lit = (0.42 + 0.58 * shade.x) * LidShade(UpperLid(d.x) - d.y, over_lower);
  c *= mix(mix(1.0, lit, 0.35 + 0.65 * soft), 1.0, answer.y * (1.0 - smoothstep(1.0, 1.04, r)));
  vec2 edge = 1.0 - vec2(0.0195, 0.0080) * mix(0.2, 1.0, glint_size);
  float glint = mix(0.5, 1.0, glint_size) * smoothstep(edge.x, edge.y, dot(d, glint_at));
  float veil = 0.010 * smoothstep(0.2, 0.9, dot(d, vec3(1.5 * glint_at.xy, 0.70)));
  float tears = smoothstep(0.0, 0.02, over_lower) * (1.0 - smoothstep(0.02, 0.055, over_lower));
  c += (0.95 * glint + veil + 0.14 * tears * shade.x) * answer.x * soft;
  colour = Coded(c * key.w);
}
