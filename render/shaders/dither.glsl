// Half a step of the picture's 8 bits, up or down, fixed to the pixel: a gradient shows no bands and does not
// flicker. `light` is linear, the steps are those of sRGB, nearly a square root.
vec3 Dithered(vec3 light) {
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
  return light + noise * (1.9 / 255.0) * sqrt(light);
}
