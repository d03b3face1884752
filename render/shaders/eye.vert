// The front of a solid ball. It stays; the iris is turned by the gaze, highlights and shade are not.
#include "frame.glsl"
#include "light.glsl"
#include "eye_lids.glsl"
layout(location = 0) in vec3 direction;  // Unit, head's frame.
uniform vec4 ball;                       // xyz centre, w radius, metres.
uniform mat3 gaze;                       // Head's frame to the iris's: columns.
flat out vec3 glint_at;  // Unit, head's frame: where the lamp is mirrored; it does not turn with the gaze.
flat out float glint_size;  // 0 to 1: what of its breadth a narrow eye leaves.
out vec3 ahead;      // The point seen from the iris: z out of the pupil.
out vec3 in_head;    // The point in the head's frame.
out vec2 shade;      // x: diffuse light; y: turned away from the viewer, 0..1.
out vec3 deeper;     // How far the iris, which lies behind the cornea, is seen off its place there: x, y; iris's frame.

// The lamp on the wet ball: halfway between it and the viewer, kept where the eye is open, so that it stays alive when the
// head turns or the lid hangs low. In a narrow eye it keeps to the middle and becomes small: as large as in an open one it
// would fill the slit, and be taken for the white.
vec3 Glint() {
  vec3 h = normalize(key.xyz + vec3(0.0, 0.0, 1.0)) * mat3(view);
  h = Rotate(normalize(vec4(-0.6 * turn.xyz, turn.w)), h);
  float x = clamp(1.26 * h.x, -0.40, 0.40);
  glint_size = smoothstep(0.12, 0.62, UpperLid(x) - LowerLid(x));
  x *= mix(0.4, 1.0, glint_size);
  float y = clamp(1.24 * h.y, -0.36, 0.36);
  float lowest = mix(0.5 * (UpperLid(x) + LowerLid(x)), -0.36, glint_size);
  y = clamp(min(y, UpperLid(x) - 0.20 * glint_size), min(lowest, 0.36), 0.36);
  y = min(y, UpperLid(x) - 0.03);
  return vec3(x, y, sqrt(max(1.0 - x * x - y * y, 0.0)));
}

void main() {
  glint_at = Glint();
  vec3 n = direction;
  vec3 p = HeadToCamera(ball.xyz + ball.w * direction, n);
  ahead = gaze * direction;
  in_head = direction;
  vec3 toward_eye = normalize(-p);
  shade = vec2(Ramp(dot(n, key.xyz), 0.6), 1.0 - clamp(dot(n, toward_eye), 0.0, 1.0));
  vec3 seen_from = gaze * Rotate(vec4(-turn.xyz, turn.w), toward_eye * mat3(view));
  deeper = seen_from / max(seen_from.z, 0.4);
  gl_Position = projection * vec4(p, 1.0);
}
