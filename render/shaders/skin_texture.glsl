// Skin textures hold square roots of linear light; alpha is gloss.
vec4 SkinAt(sampler2D skin, vec2 uv) {
  vec4 texel = texture(skin, uv);
  return vec4(texel.rgb * texel.rgb, texel.a);
}
