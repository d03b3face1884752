// Up to TEXTURES faces share the skin, each by its weight.
#include "skin_texture.glsl"
in vec4 lit;
in vec3 rest;
uniform sampler2D texture0;
#if TEXTURES > 1
uniform sampler2D texture1;
uniform vec4 weights;
#endif
#if TEXTURES > 2
uniform sampler2D texture2;
uniform sampler2D texture3;
#endif
layout(location = 0) out vec4 colour;

void main() {
#if TEXTURES == 1
  vec4 skin = SkinAt(texture0, rest.xy);
#else
  vec4 skin = weights.x * SkinAt(texture0, rest.xy) + weights.y * SkinAt(texture1, rest.xy);
#endif
#if TEXTURES > 2
  skin += weights.z * SkinAt(texture2, rest.xy) + weights.w * SkinAt(texture3, rest.xy);
#endif
  vec3 light = skin.rgb * lit.rgb + (lit.a + skin.a * rest.z);
  colour = vec4(sqrt(max(light, 0.0)), 1.0);  // Beyond a triangle's edge light may fall below 0.
}
