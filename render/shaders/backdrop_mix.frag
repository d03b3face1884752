// One backdrop, enlarged; or DROPS of them mixed, which are enlarged later. What is mixed are square roots of
// light, as the eye does: a fade has no dip in its middle.
#include "dither.glsl"
in vec2 uv;
uniform sampler2D drop0;
#if DROPS > 1
uniform sampler2D drop1;
uniform vec4 weights;
#endif
#if DROPS > 2
uniform sampler2D drop2;
uniform sampler2D drop3;
#endif
layout(location = 0) out vec4 colour;

void main() {
#if DROPS == 1
  vec3 root = DitheredRoot(texture(drop0, uv).rgb);
#else
  vec3 root = weights.x * texture(drop0, uv).rgb + weights.y * texture(drop1, uv).rgb;
#endif
#if DROPS > 2
  root += weights.z * texture(drop2, uv).rgb + weights.w * texture(drop3, uv).rgb;
#endif
  colour = vec4(root, 1.0);
}
