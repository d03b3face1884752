// The light on skin alone, before it is spread (scatter.frag), and how far from the camera it falls.
#include "frame.glsl"
#include "light.glsl"
#include "skin.glsl"
#include "fine_skin.glsl"
in vec2 pressed;
in vec3 in_camera;
in vec3 facing;
in vec4 rest;
uniform vec3 surface;
layout(location = 0) out vec4 colour;

void main() {
  Lit l = FineSkin(in_camera, normalize(facing), rest, surface, pressed);
  colour = vec4(l.diffuse, -in_camera.z);
}
