// The finished picture, texel by texel.
uniform sampler2D picture;
layout(location = 0) out vec4 colour;

void main() {
  colour = vec4(texelFetch(picture, ivec2(gl_FragCoord.xy), 0).rgb, 1.0);
}
