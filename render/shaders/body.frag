// Up to TEXTURES faces share the skin, each by its weight. BY_PIXEL: light is evaluated here, with shadows and pores.
#include "skin_texture.glsl"
#ifdef BY_PIXEL
#include "frame.glsl"
#include "light.glsl"
#include "skin.glsl"
#include "fine_skin.glsl"
in vec2 pressed;
in vec3 in_camera;
in vec3 facing;
in vec4 rest;
uniform vec3 surface;
uniform sampler2D scattered;   // The light on skin after it was spread; a: metres from the camera.
uniform float scatter;         // 0..1: how much of it is seen.
const float kSameSkin = 0.01;  // Metres: a pixel of the picture may lie on what another one's middle does not see.
#else
in vec4 lit;
in vec3 rest;
#endif
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
#ifdef BY_PIXEL
  Lit l = FineSkin(in_camera, normalize(facing), rest, surface, pressed);
  vec4 spread = texelFetch(scattered, ivec2(gl_FragCoord.xy), 0);
  float same = step(abs(spread.a + in_camera.z), kSameSkin);
  l.diffuse = mix(l.diffuse, spread.rgb, same * scatter);
  vec3 light = skin.rgb * l.diffuse + (l.added + skin.a * l.gloss);
#else
  vec3 light = skin.rgb * lit.rgb + (lit.a + skin.a * rest.z);
#endif
  colour = vec4(sqrt(max(light, 0.0)), 1.0);  // Beyond a triangle's edge light may fall below 0.
}
