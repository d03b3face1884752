// One triangle that covers the whole canvas.
uniform vec2 cover;   // How much of a backdrop is seen, across and up; 1: all.
out vec2 uv;       // Where in a backdrop, 0..1.

void main() {
  vec2 p = vec2(float((gl_VertexID & 1) << 2) - 1.0, float((gl_VertexID >> 1) << 2) - 1.0);
  uv = p * cover * 0.5 + 0.5;
  gl_Position = vec4(p, 0.0, 1.0);
}
