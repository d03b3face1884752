// The backdrop alone, as it stands behind the figure.
uniform sampler2D behind;   // Square roots of linear light.
uniform float dim;
layout(location = 0) out vec4 colour;

void main() {
  vec3 root = texelFetch(behind, ivec2(gl_FragCoord.xy), 0).rgb;
  colour = vec4(root * root * dim, 1.0);
}
