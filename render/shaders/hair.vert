// Locks of hair: they turn with the head, their tips lag behind. BY_PIXEL: they are lit by hair.frag.
#include "frame.glsl"
#include "light.glsl"
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 tangent;
layout(location = 3) in vec3 lock_place;   // x along, y across, z shade.
layout(location = 4) in float lock_number; // 0..1, one for each lock.
#define lock vec4(lock_place, lock_number)
#ifdef BY_PIXEL
centroid out vec3 in_camera;    // Metres.
centroid out vec3 facing;       // The normal and the direction to the tip, camera's frame; not of unit length between vertices.
centroid out vec3 to_tip;
centroid out vec2 open_number;  // x: how open it lies; y: the lock's number.
#else
uniform vec3 paint;
centroid out vec4 lit;
#endif
out vec2 uv;
#ifdef GROWTH
// x: hair is there up to here, along the lock; y: how far hard things have sunk into the head; z: by how much locks are apart
// in their length, which together would look like a cap.
uniform vec3 grown;
uniform highp vec4 motion[20];   // To the head of the frame, see head_fit.h.
out float left_of;               // What is left of the lock here: below 0 nothing.
const vec3 kMiddle = vec3(0.0, 0.03, -0.01);
const float kWhole = 1.35;       // As kBeyondTips in hair.cpp.
const float kTucked = kWhole - 1.0;   // Of a lock, so that none of whole hair is.

// How far this lock reaches.
float Reach() {
  float share = grown.x / kWhole;
  return kWhole * clamp(share * (1.0 + grown.z) - grown.z * lock.w, 0.0, 1.0);
}

// Hair that has not its whole length is tucked into the head over the last part of each lock, so that no end of it hangs in
// the air, and at last sinks into the scalp. In between it stands off a little: the scalp that faces have together is not
// quite where the motion says.
vec3 Bedded(vec3 p, float reach) {
  float sunk = 0.45 * smoothstep(reach - kTucked, reach, lock.x) + 0.22 * (1.0 - smoothstep(0.05, 0.55, reach));
  float length_left = min(reach / kWhole, 1.0);
  sunk -= 0.10 * length_left * (1.0 - length_left);
  return mix(p, kMiddle, sunk + 0.22 * grown.y);
}

vec3 Fitted(vec3 p) {
  // Below the scalp nothing was measured: tips go with the hair over them.
  vec3 q = (vec3(p.x, max(p.y, -0.02), p.z) - kMiddle) * 10.0;
  p += motion[0].xyz + motion[1].xyz * q.x + motion[2].xyz * q.y + motion[3].xyz * q.z;
  p += motion[4].xyz * (q.x * q.x) + motion[5].xyz * (q.y * q.y) + motion[6].xyz * (q.z * q.z);
  p += motion[7].xyz * (q.x * q.y) + motion[8].xyz * (q.y * q.z) + motion[9].xyz * (q.z * q.x);
  p += q.x * q.x * (motion[10].xyz * q.x + motion[11].xyz * q.y + motion[12].xyz * q.z);
  p += q.y * q.y * (motion[13].xyz * q.x + motion[14].xyz * q.y + motion[15].xyz * q.z);
  p += q.z * q.z * (motion[16].xyz * q.x + motion[17].xyz * q.y + motion[18].xyz * q.z);
  return p + motion[19].xyz * (q.x * q.y * q.z);
}
#endif

// How open a point lies. What lay below longer hair is uncovered as that withdraws: it would be a dark band.
float Open() {
#ifdef GROWTH
  return mix(0.85, lock.z, smoothstep(0.6, 1.0, grown.x / kWhole));
#else
  return lock.z;
#endif
}

// The lower and further along, the more a point swings. Over the forehead, to the left and to the right in times of their own; between
// them there is no edge at which hair would part.
vec3 Swing(vec3 p) {
  float loose = lock.x * lock.x * clamp((shift.w + 0.16 - p.y) * 6.0, 0.0, 1.0);
  float arm = 0.09 * loose;
  float fringe = smoothstep(0.03, 0.07, p.z) * (1.0 - smoothstep(0.04, 0.08, abs(p.x)));
  vec2 side = mix(sway_sides.zw, sway_sides.xy, smoothstep(-0.03, 0.03, p.x));
  vec2 swing = mix(side, sway.xy, fringe);
  return p + vec3(sin(swing.x), 0.0, sin(swing.y)) * arm * (0.85 + 0.3 * lock.w);
}

void main() {
  vec3 n = normal;
  vec3 t = tangent;
#ifdef GROWTH
  float reach = Reach();
  left_of = reach - lock.x;
  vec3 p = RigidToCamera(Swing(Fitted(Bedded(position, reach))), n);
#else
  vec3 p = RigidToCamera(Swing(position), n);
#endif
  t = normalize(mat3(view) * Rotate(turn, t));
  uv = vec2(lock.y + 5.0 * lock.w, lock.x);
  gl_Position = projection * vec4(p, 1.0);
#ifdef BY_PIXEL
  in_camera = p;
  facing = n;
  to_tip = t;
  open_number = vec2(Open(), lock.w);
#else
  vec3 toward_eye = normalize(-p);
  float facing = clamp(dot(n, toward_eye), 0.0, 1.0);
  float open = Open();
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
#endif
}
