// What all backdrops share: they are drawn small, once, and stand behind the character, enlarged, so all edges are soft.
in vec2 uv;         // x: -16/9 to 16/9 from left to right, y: -1 to 1 from below.
uniform vec3 top;      // Colours, linear.
uniform vec3 bottom;
uniform vec3 glow;
layout(location = 0) out vec4 colour;

vec3 Wall() { return mix(bottom, top, smoothstep(-1.0, 1.0, uv.y)); }

// Numbers 0..1 that are spread evenly, for lamp or tile `n`.
vec2 Spread(float n) { return fract(n * vec2(0.7548777, 0.5698403)); }

// 1 below `edge`, 0 above, softly.
float Below(float x, float edge, float soft) { return 1.0 - smoothstep(edge - soft, edge + soft, x); }

float Disc(vec2 centre, float radius, float soft) { return Below(distance(uv, centre), radius, soft); }

// The distance out of a box, 0 inside.
float OutOfBox(vec2 centre, vec2 half_size) { return length(max(abs(uv - centre) - half_size, 0.0)); }

// Light that falls off from a point; 1 there.
float Pool(vec2 centre, vec2 reach) {
  vec2 d = (uv - centre) / reach;
  return exp(-dot(d, d));
}

// Lamps out of focus are discs, a little brighter at their rims.
float Lamp(vec2 centre, float radius) {
  float d = distance(uv, centre) / radius;
  return Below(d, 1.0, 0.10) * (0.72 + 0.28 * d * d);
}

// Towards the corners a stage is darker, and the face brighter for it.
float Vignette() { return 1.0 - 0.14 * dot(uv, uv * vec2(0.55, 1.0)); }

void Show(vec3 light) { colour = vec4(sqrt(clamp(light * Vignette(), 0.0, 1.0)), 1.0); }
