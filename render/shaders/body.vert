// The face itself, textured. BY_PIXEL: it is lit by body.frag.
#include "frame.glsl"
#include "light.glsl"
#include "skin.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float open;
layout(location = 3) in vec2 uv;
#ifdef BY_PIXEL
layout(location = 4) in vec2 squeeze;
out vec2 pressed;     // How far the skin is pressed together along the texture's u and v, 0..1.
out vec3 in_camera;   // Metres.
out vec3 facing;      // The normal, camera's frame; not of unit length between vertices.
out vec4 rest;        // xy: texture coordinates; z: how open it lies; w: what is left of light under the chin.
#else
uniform vec3 surface;
out vec4 lit;    // rgb: times the texture; a: added.
out vec3 rest;   // xy: texture coordinates; z: gloss.
#endif

void main() {
  vec3 n = normal;
  vec3 p = HeadToCamera(position, n);
#ifdef BY_PIXEL
  pressed = squeeze;
  in_camera = p;
  facing = n;
  rest = vec4(uv, open, UnderChin(TurnShare(position)));
#else
  Lit l = Skin(p, n, open, surface, UnderChin(TurnShare(position)), vec3(1.0));
  lit = vec4(l.diffuse, l.added);
  rest = vec3(uv, l.gloss);
#endif
  gl_Position = projection * vec4(p, 1.0);
}
