#include "frame.glsl"
#include "light.glsl"
in vec3 ahead;
in vec3 in_head;
in vec3 shade;
uniform vec4 iris;   // rgb; a: its radius, in radii of the ball.
flat in vec3 glint_at;  // See eye.vert.
layout(location = 0) out vec4 colour;
const vec3 kWhite = vec3(0.896, 0.863, 0.855);
const vec3 kVein = vec3(0.80, 0.50, 0.45);

// Fine spokes: a few sines that do not repeat visibly.
float Spokes(float angle, float r) {
  return 0.5 + 0.25 * sin(angle * 23.0 + 3.0 * sin(angle * 5.0)) + 0.25 * sin(angle * 37.0 + 9.0 * r);
}

// Lit from above, an iris glows at its far side, below.
vec3 IrisColour(float r, vec2 at) {
  float below = smoothstep(0.5, -1.0, at.y);
  vec3 c = iris.rgb * (0.50 + 1.15 * below) * (0.82 + 0.34 * Spokes(atan(at.y, at.x), r));
  c *= 1.0 - 0.78 * smoothstep(0.78, 1.0, r);
  return c * (1.0 - 0.95 * smoothstep(0.52, 0.44, r));
}

void main() {
  vec2 at = ahead.xy / iris.a;
  float r = length(at);
  float blur = fwidth(r);
  vec3 white = mix(kWhite, kVein, 0.22 * smoothstep(0.75, 1.0, shade.z));
  vec3 c = mix(IrisColour(r, at), white, smoothstep(1.0 - blur, 1.03 + blur, r));
  float soft = fill.w;
  c *= mix(1.0, (0.42 + 0.58 * shade.x) * (1.0 - 0.62 * shade.y), 0.35 + 0.65 * soft);
  vec3 d = normalize(in_head);
  float glint = smoothstep(0.984, 0.9915, dot(d, glint_at));
  glint += 0.38 * smoothstep(0.992, 0.998, dot(d, normalize(vec3(-0.87 * glint_at.x, -0.84 * glint_at.y - 0.02, 0.92))));
  float veil = 0.010 * smoothstep(0.2, 0.9, dot(d, vec3(1.5 * glint_at.xy, 0.70)));
  c += (0.95 * glint + veil) * soft;
  colour = Coded(c * key.w);
}
