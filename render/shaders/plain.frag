in vec3 lit;
uniform sampler2D texture0;
layout(location = 0) out vec4 colour;
void main() { colour = vec4(texture(texture0, lit.yz).rgb * lit.x, 1.0); }
