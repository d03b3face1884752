// One triangle that covers the whole canvas.
uniform vec3 top;
uniform vec3 bottom;
out vec3 backdrop;

void main() {
  vec2 p = vec2(float((gl_VertexID & 1) << 2) - 1.0, float((gl_VertexID >> 1) << 2) - 1.0);
  backdrop = mix(bottom, top, p.y * 0.5 + 0.5);
  gl_Position = vec4(p, 0.0, 1.0);
}
