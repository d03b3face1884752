// Letters on a plate with round, soft corners. Linear light.
uniform sampler2D letters;  // a: how much of a pixel a letter covers; the lower left corner first.
uniform vec4 plate;         // Pixels: left, bottom, width, height.
uniform int border;         // Pixels about the letters.
uniform float opacity;
layout(location = 0) out vec4 colour;
const vec4 kPlate = vec4(0.006, 0.008, 0.014, 0.66);
const vec3 kInk = vec3(0.86, 0.84, 0.80);

float Plate(vec2 at) {
  float corner = float(border) * 0.8;
  vec2 beyond = abs(at - plate.zw * 0.5) - plate.zw * 0.5 + corner;
  float away = length(max(beyond, 0.0)) - corner;
  return clamp(0.5 - away, 0.0, 1.0);
}

void main() {
  vec2 at = gl_FragCoord.xy - plate.xy;
  ivec2 letter = ivec2(floor(at)) - border;
  bool within = all(greaterThanEqual(letter, ivec2(0))) && all(lessThan(letter, textureSize(letters, 0)));
  float ink = within ? texelFetch(letters, letter, 0).a : 0.0;
  float under = kPlate.a * Plate(at) * (1.0 - ink);
  float cover = under + ink;
  colour = vec4(mix(kPlate.rgb, kInk, ink / max(cover, 1e-4)), cover * opacity);
}
