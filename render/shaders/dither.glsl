// Half a step of 8 bits, up or down, fixed to the pixel: a gradient shows no bands and does not flicker.
vec3 DitheredRoot(vec3 root) {
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
  return root + noise / 255.0;
}
