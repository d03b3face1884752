// The face itself, textured.
#include "frame.glsl"
#include "light.glsl"
#include "skin.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float open;
layout(location = 3) in vec2 uv;
uniform vec2 surface;
out vec4 lit;    // rgb: times the texture; a: added.
out vec3 rest;   // xy: texture coordinates; z: gloss.

void main() {
  vec3 n = normal;
  vec3 p = HeadToCamera(position, n);
  Lit l = Skin(p, n, open, surface, UnderChin(TurnShare(position)));
  lit = vec4(l.diffuse, l.added);
  rest = vec3(uv, l.gloss);
  gl_Position = projection * vec4(p, 1.0);
}
