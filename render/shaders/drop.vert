// One triangle that covers the whole target.
out vec2 uv;

void main() {
  vec2 p = vec2(float((gl_VertexID & 1) << 2) - 1.0, float((gl_VertexID >> 1) << 2) - 1.0);
  uv = p * vec2(16.0 / 9.0, 1.0);
  gl_Position = vec4(p, 0.0, 1.0);
}
