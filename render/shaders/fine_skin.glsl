// What a graphics card adds to skin: shadows of the key lamp with soft edges, pores, and wrinkles where it is pressed together.
#include "lamp_seen.glsl"
uniform sampler2D pores;               // xy: slope, 0.5 is none.
const float kPoresInUv = 9.0;     // So often the pores' picture lies along the skin's.
const float kPoreSlope = 0.24;
const vec3 kScattered = vec3(0.30, 0.19, 0.15);  // What of the lamp reaches skin in shadow, by ways within it and from what is lit around.

const vec2 kWrinklesInUv = vec2(62.0, 40.0);  // So many would lie round the head, and up it.
const float kWrinkleSlope = 0.62;

// Of skin that is pressed together by `pressed`: x, y: the slope of its folds along u and v; z: how deep this place lies,
// 0..1. Folds run across the pressure, a little crooked, and are narrower than what lies between them.
vec3 Wrinkles(vec2 uv, vec2 pressed) {
  vec2 crooked = vec2(0.30 * sin(47.0 * uv.y) + 0.12 * sin(131.0 * uv.y), 0.34 * sin(29.0 * uv.x) + 0.13 * sin(83.0 * uv.x));
  vec2 phase = 6.2832 * (kWrinklesInUv * uv + crooked);
  vec2 folded = smoothstep(0.05, 0.34, pressed);
  vec2 ridge = 0.5 + 0.5 * cos(phase);
  vec2 slope = -1.5 * kWrinkleSlope * folded * sin(phase) * ridge * ridge;
  vec2 groove = folded * ridge * ridge * ridge;
  return vec3(slope, max(groove.x, groove.y));
}

// The normal of a relief with these slopes along the texture's axes, without a stored tangent: where the axes lie on the surface follows from how both change from
// pixel to pixel (Mikkelsen 2010).
vec3 Bumped(vec3 n, vec3 p, vec2 uv, vec2 slope) {
  vec3 across = cross(dFdy(p), n);
  vec3 along = cross(n, dFdx(p));
  vec2 ux = dFdx(uv);
  vec2 uy = dFdy(uv);
  vec3 t = across * ux.x + along * uy.x;
  vec3 b = across * ux.y + along * uy.y;
  float longest = max(dot(t, t), dot(b, b));
  return normalize(n + (slope.x * t + slope.y * b) * inversesqrt(max(longest, 1e-24)));
}

// `rest` as body.vert gives it. Light that enters the skin beside a shadow leaves it within: red reaches farthest, so an
// edge is warm. The shade below the chin, which stands for a shadow where none is drawn, is mostly left to the lamp's own.
Lit FineSkin(vec3 p, vec3 n, vec4 rest, vec3 surface, vec2 pressed) {
  float seen = LampSeen(p, n, 0.0025);
  vec3 bled = mix(vec3(seen), mix(kScattered, vec3(1.0), pow(vec3(seen), vec3(0.60, 0.85, 1.00))), surface.x);
  float skin_like = surface.x * (1.0 - surface.y);
  vec3 wrinkles = Wrinkles(rest.xy, pressed) * skin_like;
  vec2 slope = kPoreSlope * skin_like * (texture(pores, rest.xy * kPoresInUv).xy - 0.5) + wrinkles.xy;
  vec3 bumped = Bumped(n, p, rest.xy, slope);
  float under_chin = mix(rest.w, 1.0, 0.85);
  float open = max(rest.z, 0.0) * (1.0 - 0.30 * wrinkles.z);  // Beyond a triangle's edge it may fall below 0.
  Lit lit = Skin(p, bumped, open, surface, under_chin, bled);
  // Gloss is of the lamp, and shadow takes it away. A second, narrower one: skin is moist.
  vec3 toward_eye = normalize(-p);
  float h = clamp(dot(bumped, normalize(key.xyz + toward_eye)), 0.0, 1.0);
  lit.gloss = lit.gloss * seen + 0.10 * skin_like * pow(h, 140.0) * seen * fill.w * key.w;
  return lit;
}
