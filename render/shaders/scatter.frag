// Light within skin, along one axis of the picture: nine places, each as much as a Gaussian says, red's the widest.
#include "frame.glsl"
uniform sampler2D light;   // rgb: light on skin, linear; a: metres from the camera, 0 where there is none.
uniform ivec2 axis;        // Of unit length.
uniform ivec4 within;      // The first and the last pixel of what was drawn: what lies beyond is of other frames.
layout(location = 0) out vec4 colour;
const int kBeside = 4;              // On each side.
const float kReach = 0.0028;        // Metres to the farthest place.
const vec3 kWidth = vec3(0.0013, 0.0007, 0.0005);  // Of the Gaussians, metres.
const float kApart = 0.008;         // Metres between two surfaces that do not share light.

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 here = texelFetch(light, at, 0);
  colour = vec4(0.0);
  if (here.a <= 0.0) return;   // Most of the picture is no skin.
  float pixels = 0.5 * sway.w * projection[1][1] / here.a;   // For each metre.
  vec3 sum = here.rgb;
  vec3 whole = vec3(1.0);
  for (int i = 1; i <= kBeside; ++i) {
    float away = kReach * float(i) / float(kBeside);
    vec3 share = exp(-0.5 * away * away / (kWidth * kWidth));
    ivec2 off = axis * int(away * pixels + 0.5);
    vec4 before = texelFetch(light, max(at - off, within.xy), 0);
    vec4 behind = texelFetch(light, min(at + off, within.zw), 0);
    sum += share * mix(here.rgb, before.rgb, clamp(1.0 - abs(before.a - here.a) / kApart, 0.0, 1.0));
    sum += share * mix(here.rgb, behind.rgb, clamp(1.0 - abs(behind.a - here.a) / kApart, 0.0, 1.0));
    whole += 2.0 * share;
  }
  colour = vec4(sum / whole, here.a);
}
