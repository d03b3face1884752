// The front of a solid ball. It stays; the iris is turned by the gaze, highlights and shade are not.
#include "frame.glsl"
#include "light.glsl"
layout(location = 0) in vec3 direction;  // Unit, head's frame.
uniform vec4 ball;                       // xyz centre, w radius, metres.
uniform mat3 gaze;                       // Head's frame to the iris's: columns.
uniform float lid[9];                    // Height of the upper lid's margin over the centre, in radii, from x = -1.2 to 1.2 radii.
flat out vec3 glint_at;  // Unit, head's frame: where the lamp is mirrored; it does not turn with the gaze.
out vec3 ahead;      // The point seen from the iris: z out of the pupil.
out vec3 in_head;    // The point in the head's frame.
out vec3 shade;      // x: diffuse light; y: shade of the lid, 0..1; z: turned away from the viewer, 0..1.

float LidHeight(float x) {
  float at = clamp((x + 1.2) / 2.4, 0.0, 0.999) * 8.0;
  int i = int(at);
  return mix(lid[i], lid[i + 1], at - float(i));
}

// The lamp on the wet ball: halfway between it and the viewer, kept where the eye is open, so that it stays
// alive when the head turns or the lid hangs low.
vec3 Glint() {
  vec3 h = normalize(key.xyz + vec3(0.0, 0.0, 1.0)) * mat3(view);
  h = Rotate(normalize(vec4(-0.6 * turn.xyz, turn.w)), h);
  float x = clamp(1.26 * h.x, -0.40, 0.40);
  float y = clamp(1.24 * h.y, -0.36, 0.36);
  y = clamp(min(y, LidHeight(x) - 0.20), -0.36, 0.36);
  return vec3(x, y, sqrt(1.0 - x * x - y * y));
}

void main() {
  glint_at = Glint();
  vec3 n = direction;
  vec3 p = HeadToCamera(ball.xyz + ball.w * direction, n);
  ahead = gaze * direction;
  in_head = direction;
  float under_lid = LidHeight(direction.x) - direction.y;
  shade = vec3(Ramp(dot(n, key.xyz), 0.6), smoothstep(0.48, 0.02, under_lid),
               1.0 - clamp(dot(n, normalize(-p)), 0.0, 1.0));
  gl_Position = projection * vec4(p, 1.0);
}
