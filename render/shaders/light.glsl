// Soft light of a small stage: a wrapped key, a cool fill, sky and bounce. All colours are linear.
const vec3 kKeyColour = vec3(1.0, 0.96, 0.90) * 0.92;
const vec3 kSky = vec3(0.275, 0.270, 0.392) * 0.55;
const vec3 kBounce = vec3(0.485, 0.254, 0.195) * 0.25;
const vec3 kFillColour = vec3(0.10, 0.11, 0.15);

float Ramp(float cosine, float wrap) {
  float x = clamp((cosine + wrap) / (1.0 + wrap), 0.0, 1.0);
  return mix(x, x * x * (3.0 - 2.0 * x), 0.55);
}

// Light bleeds into shade, red most: a cheap look of skin. `softness` 0 gives hard matter.
vec3 SkinRamp(float cosine, float softness) {
  vec3 wrap = vec3(0.55, 0.32, 0.25) * mix(0.25, 1.0, softness);
  return vec3(Ramp(cosine, wrap.r), Ramp(cosine, wrap.g), Ramp(cosine, wrap.b));
}

// Bright light is taken back softly, as film does: nothing burns out, and colours keep their hue.
vec3 Shoulder(vec3 light) {
  vec3 over = max(light - 0.70, 0.0);
  return min(light, 0.70) + over / (1.0 + over * 1.1);
}

// 1 where a surface looks up, 0 where it looks down.
float SkyShare(vec3 n) { return 0.5 + 0.5 * dot(n, up.xyz); }

// The plain light of 1993: one lamp and a little ambience.
float PlainLight(vec3 n) { return 0.80 * max(dot(n, key.xyz), 0.0) + 0.17; }

// Layers hold square roots of linear light.
vec4 Coded(vec3 light) { return vec4(sqrt(max(light, 0.0)), 1.0); }
