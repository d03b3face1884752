// The finished picture, texel by texel. Not by texelFetch: that decodes sRGB in any case.
uniform sampler2D picture;
layout(location = 0) out vec4 colour;

void main() {
  colour = vec4(texture(picture, gl_FragCoord.xy / vec2(textureSize(picture, 0))).rgb, 1.0);
}
