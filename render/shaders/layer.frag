// A layer over the backdrop. It holds square roots of linear light, so samples are squared, then averaged.
#ifdef PRINT
#include "print.glsl"
#endif
#ifdef SAMPLES
uniform sampler2DMS layer;
#else
uniform sampler2D layer;
#endif
uniform sampler2D behind;   // The backdrop, as large as the picture.
uniform float opacity;
uniform float dim;          // Of the backdrop.
layout(location = 0) out vec4 colour;

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
  vec4 a = texelFetch(layer, at, 0);
  vec3 light = a.rgb * a.rgb;
  float covered = ceil(a.a);
#endif
#ifdef PRINT
  if (covered > 0.0) light = Printed(light / covered) * covered;
#endif
  vec3 root = texelFetch(behind, at, 0).rgb;
  colour = vec4(light + root * root * (dim * (1.0 - covered)), opacity);
}
