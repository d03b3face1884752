// What all shaders of a frame share. Metres; the camera's frame: +X right, +Y up, +Z towards the viewer.
layout(std140) uniform Frame {
  mat4 view;        // World to camera.
  mat4 projection;
  vec4 turn;        // The head's rotation, a quaternion.
  vec4 pivot;       // xyz: the head turns about this point; w: below this height the neck does not turn.
  vec4 shift;       // xyz: how far the head is moved; w: above this height it turns and moves fully.
  vec4 key;         // xyz: unit direction towards the key light, camera's frame; w: exposure.
  vec4 fill;        // xyz: as key, of the fill light; w: share of today's soft light, the rest is 1993's plain one.
  vec4 up;          // xyz: the world's up in the camera's frame; w: metres that breath lifts the shoulders.
  vec4 sway;        // xy: how far tips of the fringe swing, radians, sideways and forwards; zw: what is drawn on, in pixels.
  vec4 sway_sides;  // xy: the same of hair on the character's left; zw: on the right.
  mat4 lamp;        // Camera to the key lamp's clip space, for its shadows.
  vec4 least;       // x: what covers no more than this of a pixel is left out.
};

vec3 Rotate(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }

// How far a point of the head follows its turn: 1 but for the neck. The chin hangs low, but far in front.
float TurnShare(vec3 p) {
  float height = p.y + 0.8 * max(p.z - pivot.z - 0.04, 0.0);
  return smoothstep(pivot.w, shift.w, height);
}

// How far a height of the figure follows the head's shift: the head wholly, the body below it the less the lower, as one
// leans in from the hip. Neck and clothes of one height move alike, so that nothing comes through a collar.
float LeanShare(float y) { return clamp(1.0 - (shift.w - y) * 3.3, 0.0, 1.0); }

vec4 PartOfTurn(float share) { return normalize(mix(vec4(0.0, 0.0, 0.0, 1.0), turn, share)); }

// The neck bends, but where it stands in the collar it stays: looking up, it would come out in front.
float BendShare(float share) { return smoothstep(0.62, 1.0, share); }

// A point of the head to the camera's frame, and the direction `n` with it.
vec3 HeadToCamera(vec3 p, inout vec3 n) {
  float share = TurnShare(p);
  vec4 q = PartOfTurn(share);
  n = mat3(view) * Rotate(q, n);
  vec3 turned = Rotate(q, p - pivot.xyz) + pivot.xyz;
  turned.xz = mix(p.xz, turned.xz, BendShare(share));
  turned += shift.xyz * LeanShare(p.y);
  turned.y += up.w * (1.0 - 0.4 * share);
  return (view * vec4(turned, 1.0)).xyz;
}

// What hangs on the head and turns with all of it.
vec3 RigidToCamera(vec3 p, inout vec3 n) {
  n = mat3(view) * Rotate(turn, n);
  vec3 turned = Rotate(turn, p - pivot.xyz) + pivot.xyz + shift.xyz;
  turned.y += up.w * 0.6;
  return (view * vec4(turned, 1.0)).xyz;
}
