// Shadows of the key lamp, with soft edges.
uniform highp sampler2DShadow depths;  // What the lamp sees: depths of the nearest surfaces, by `lamp` of the frame.
const int kTaps = 16;
const float kPenumbra = 0.0085;   // Radius of a shadow's edge, of the map's side: about 4 mm on the face.
const float kBias = 0.0012;       // Of the map's depth, about 1 mm.

// 0..1: how much of the lamp is seen from `off` metres outside of this point, over a disc whose points turn by the golden
// angle (Vogel 1979).
float LampSeen(vec3 p, vec3 n, float off) {
  vec3 at = (lamp * vec4(p + off * n, 1.0)).xyz * 0.5 + 0.5;
  float seen = 0.0;
  for (int i = 0; i < kTaps; ++i) {
    float radius = kPenumbra * sqrt((float(i) + 0.5) / float(kTaps));
    float angle = 2.39996 * float(i);
    seen += texture(depths, vec3(at.xy + radius * vec2(cos(angle), sin(angle)), at.z - kBias));
  }
  return seen / float(kTaps);
}
