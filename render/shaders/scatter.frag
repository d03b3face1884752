// Light within skin, along one axis of the picture: nine places, each as much as a Gaussian says, red's the widest.
#include "frame.glsl"
uniform sampler2D light;   // rgb: light on skin, linear; a: metres from the camera, 0 where there is none.
uniform vec2 axis;         // Of unit length.
layout(location = 0) out vec4 colour;
const int kBeside = 4;              // On each side.
const float kReach = 0.0052;        // Metres to the farthest place.
const vec3 kWidth = vec3(0.0026, 0.0013, 0.0009);  // Of the Gaussians, metres.
const float kApart = 0.008;         // Metres between two surfaces that do not share light.

void main() {
  vec2 size = vec2(textureSize(light, 0));
  vec4 here = texelFetch(light, ivec2(gl_FragCoord.xy), 0);
  float pixels = 0.5 * sway.w * projection[1][1] / max(here.a, 0.1);   // For each metre.
  vec3 sum = here.rgb;
  vec3 whole = vec3(1.0);
  for (int i = -kBeside; i <= kBeside; ++i) {
    if (i == 0) continue;
    float away = kReach * float(i) / float(kBeside);
    vec4 there = textureLod(light, (gl_FragCoord.xy + away * pixels * axis) / size, 0.0);
    vec3 share = exp(-0.5 * away * away / (kWidth * kWidth));
    float same = clamp(1.0 - abs(there.a - here.a) / kApart, 0.0, 1.0);
    sum += share * mix(here.rgb, there.rgb, same);
    whole += share;
  }
  colour = here.a > 0.0 ? vec4(sum / whole, here.a) : vec4(0.0);
}
