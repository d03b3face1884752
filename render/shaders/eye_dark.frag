layout(location = 0) out vec4 colour;
void main() { colour = vec4(0.05, 0.09, 0.10, 1.0); }
