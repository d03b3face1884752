// Skin textures hold square roots of linear light; alpha is gloss.
vec4 SkinAt(sampler2D skin, vec2 place) {
  vec4 texel = texture(skin, place);
  return vec4(texel.rgb * texel.rgb, texel.a);
}
