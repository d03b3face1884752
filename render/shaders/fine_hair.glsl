// Hair a pixel at a time, for graphics cards: two bands of light, of the lamp's colour and of the hair's own, of which the
// second lies nearer to the root (Marschner et al. 2003, in the shifted tangents of Scheuermann 2004).
#include "lamp_seen.glsl"
const float kTipsFrom = 0.90;     // Along a lock, strands end from here on.

// What is left of a strand here: below the end of its own, nothing. `strand` 0 .. 0.9; of coarse stripes, since finer ones
// than pixels would end as dots.
float StrandLeft(float along, float strand) {
  return clamp((1.02 - along - (1.0 - kTipsFrom) * (1.0 - strand)) * 26.0, 0.0, 1.0);
}

float Band(vec3 tangent, vec3 n, float shift, vec3 h, float sharpness) {
  float along = dot(normalize(tangent + shift * n), h);
  return pow(clamp(1.0 - along * along, 0.0, 1.0), sharpness);
}

// As hair.vert lights a vertex. `open_number`: x how open it lies, y the lock's number; `stripe`: of the strand.
vec4 FineHair(vec3 p, vec3 n, vec3 t, vec2 open_number, vec3 paint, float stripe) {
  float open = open_number.x;
  vec3 toward_eye = normalize(-p);
  vec3 h = normalize(key.xyz + toward_eye);
  float seen = mix(0.42, 1.0, LampSeen(p, n, 0.006));
  float diffuse = Ramp(dot(n, key.xyz), 0.4) * seen;
  float strand = 0.16 * (stripe - 0.6) + 0.05 * (open_number.y - 0.5);
  float band = 0.40 * Band(t, n, strand + 0.10, h, 16.0) + 0.95 * Band(t, n, strand - 0.05, h, 95.0);
  float edge = pow(1.0 - clamp(dot(n, toward_eye), 0.0, 1.0), 2.5);
  float sky = SkyShare(n);
  vec3 soft = paint * (diffuse * 1.25 + 0.28 + 0.22 * sky) * open;
  soft += edge * vec3(0.205, 0.162, 0.246) * 0.22 * open * (0.3 + 0.7 * sky);
  float highlight = band * 0.80 * open * (0.25 + 0.75 * diffuse) * seen * fill.w * key.w;
  return vec4(mix(paint * 1.25 * PlainLight(n) * key.w, Shoulder(soft * key.w), fill.w), highlight);
}
