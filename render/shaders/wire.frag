in vec3 across;
uniform vec3 paint;
layout(location = 0) out vec4 colour;

void main() {
  float there = clamp(across.z + 0.5 - abs(across.x), 0.0, 1.0);
  // A line that has faded hides nothing.
  colour = vec4(sqrt(max(paint * there * across.y, 0.0)), across.y > 0.01 ? there : 0.0);
}
