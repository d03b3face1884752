// A layer over the backdrop. It holds square roots of linear light, so samples are squared, then averaged. SAMPLES: a layer
// with four of them; else one that is larger than the picture, of which a pixel covers two texels each way at most.
#ifdef PRINT
#include "print.glsl"
#endif
#ifdef SAMPLES
uniform sampler2DMS layer;
#else
uniform sampler2D layer;
uniform vec2 per_pixel;     // Texels of the layer for a pixel of the picture, each from 1 to 4/3.
#endif
uniform sampler2D behind;   // The backdrop, as large as the picture.
uniform float opacity;
uniform float dim;          // Of the backdrop.
layout(location = 0) out vec4 colour;

#ifndef SAMPLES
// rgb: light; a: how much of this texel is covered.
vec4 LightOf(ivec2 texel) {
  vec4 root = texelFetch(layer, texel, 0);
  return vec4(root.rgb * root.rgb, ceil(root.a));
}
#endif

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
#ifdef SAMPLES
  vec4 a = texelFetch(layer, at, 0);
  vec4 b = texelFetch(layer, at, 1);
  vec4 c = texelFetch(layer, at, 2);
  vec4 d = texelFetch(layer, at, 3);
  vec3 light = (a.rgb * a.rgb + b.rgb * b.rgb + c.rgb * c.rgb + d.rgb * d.rgb) * 0.25;
  float covered = (ceil(a.a) + ceil(b.a) + ceil(c.a) + ceil(d.a)) * 0.25;
#else
  vec2 from = vec2(at) * per_pixel + 0.002;   // Thirds of texels are no binary fractions.
  ivec2 first = ivec2(from);
  vec2 share = min(1.0 - fract(from), per_pixel) / per_pixel;   // Of the pixel, in its first texel.
  ivec2 last = min(first + 1, textureSize(layer, 0) - 1);
  vec4 below = mix(LightOf(ivec2(last.x, first.y)), LightOf(first), share.x);
  vec4 above = mix(LightOf(last), LightOf(ivec2(first.x, last.y)), share.x);
  vec4 mean = mix(above, below, share.y);
  vec3 light = mean.rgb;
  float covered = mean.a;
#endif
#ifdef PRINT
  if (covered > 0.0) light = Printed(light / covered) * covered;
#endif
  vec3 root = texelFetch(behind, at, 0).rgb;
  colour = vec4(light + root * root * (dim * (1.0 - covered)), opacity);
}
