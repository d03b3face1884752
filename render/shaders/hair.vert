// Locks of hair: they turn with the head, their tips lag behind.
#include "frame.glsl"
#include "light.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 tangent;
layout(location = 3) in vec3 lock_place;   // x along, y across, z shade.
layout(location = 4) in float lock_number; // 0..1, one for each lock.
#define lock vec4(lock_place, lock_number)
uniform vec3 paint;
out vec4 lit;
out vec2 uv;

// The lower and further along, the more a point swings.
vec3 Swing(vec3 p) {
  float loose = lock.x * lock.x * clamp((shift.w + 0.16 - p.y) * 6.0, 0.0, 1.0);
  float arm = 0.09 * loose;
  return p + vec3(sin(sway.x), 0.0, sin(sway.y)) * arm * (0.85 + 0.3 * lock.w);
}

void main() {
  vec3 n = normal;
  vec3 t = tangent;
  vec3 p = RigidToCamera(Swing(position), n);
  t = normalize(mat3(view) * Rotate(turn, t));
  vec3 toward_eye = normalize(-p);
  float facing = clamp(dot(n, toward_eye), 0.0, 1.0);
  float open = lock.z;
  float diffuse = Ramp(dot(n, key.xyz), 0.4);
  float along_h = dot(t, normalize(key.xyz + toward_eye)) + 0.10 * (lock.w - 0.5);
  float across_h = clamp(1.0 - along_h * along_h, 0.0, 1.0);
  float band = 0.45 * pow(across_h, 14.0) + 0.85 * pow(across_h, 75.0);
  float edge = pow(1.0 - facing, 2.5);
  float sky = SkyShare(n);
  vec3 soft = paint * (diffuse * 1.25 + 0.28 + 0.22 * sky) * open;
  soft += edge * vec3(0.205, 0.162, 0.246) * 0.22 * open * (0.3 + 0.7 * sky);
  float highlight = band * 0.80 * open * (0.25 + 0.75 * diffuse) * fill.w * key.w;
  lit = vec4(mix(paint * 1.25 * PlainLight(n) * key.w, Shoulder(soft * key.w), fill.w), highlight);
  uv = vec2(lock.y + 5.0 * lock.w, lock.x);
  gl_Position = projection * vec4(p, 1.0);
}
