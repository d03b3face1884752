// The neck dissolves into the dark, dithered: it has no end in the picture.
in vec3 lit;
in float there;
layout(location = 0) out vec4 colour;

void main() {
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  colour = there > noise ? vec4(sqrt(max(lit, 0.0)), 1.0) : vec4(0.0);
}
