// Light on the composed face, evaluated once a vertex: the fine mesh is dense enough, and pixels stay cheap. Or, with
// BY_PIXEL, once a pixel. `surface`: x softness, y metal, z flush. `lamp_seen`: what of the key lamp's light is not in shadow.
const vec3 kFlushed = vec3(1.0, 0.34, 0.20);   // What of light is left on what is as red as can be.

struct Lit {
  vec3 diffuse;     // Times the texture.
  float added;      // On top, white.
  float gloss;      // On top, times the texture's alpha.
};

// A polished body mirrors a window high up and a dark horizon.
float Mirror(vec3 n, vec3 toward_eye) {
  vec3 r = reflect(-toward_eye, n);
  float ry = dot(r, up.xyz);
  float horizon = smoothstep(-0.2, 0.05, ry) * (1.0 - smoothstep(0.2, 0.5, ry));
  float window = smoothstep(0.45, 0.75, ry) * (1.0 - smoothstep(0.8, 0.98, ry)) * (1.0 - smoothstep(0.1, 0.9, r.x));
  return 0.25 + 0.55 * horizon + 0.9 * window;
}

// The chin throws its shadow on the neck, deepest where they meet; 1 on the head. `share` is TurnShare there.
float UnderChin(float share) {
  float below = 1.0 - share;
  float shade = smoothstep(0.0, 0.30, below) * (1.0 - 0.55 * smoothstep(0.30, 0.95, below));
  return 1.0 - 0.46 * shade * clamp(dot(key.xyz, up.xyz) * 1.8, 0.0, 1.0);
}

Lit SoftSkin(vec3 p, vec3 n, float open, vec3 surface, vec3 lamp_seen) {
  vec3 toward_eye = normalize(-p);
  float edge = 1.0 - clamp(dot(n, toward_eye), 0.0, 1.0);
  float sky = SkyShare(n);
  vec3 ao = pow(vec3(open), vec3(1.00, 1.40, 1.45));
  vec3 light = SkinRamp(dot(n, key.xyz), surface.x) * kKeyColour * (0.25 + 0.80 * ao) * lamp_seen;
  light += (kSky * (0.55 + 0.45 * sky) + kBounce * (1.0 - sky)) * ao;
  light += Ramp(dot(n, fill.xyz), 0.3) * kFillColour * ao;
  float h = clamp(dot(n, normalize(key.xyz + toward_eye)), 0.0, 1.0);
  Lit lit;
  lit.added = edge * edge * edge * 0.13 * (0.3 + 0.7 * sky) * open + 0.035 * pow(h, 22.0) * open;
  lit.gloss = 0.35 * pow(h, 60.0) * open;
  float shine = Mirror(n, toward_eye) * (0.18 + 0.5 * edge * edge * edge * edge) * open;
  lit.diffuse = light * mix(1.0, 0.78, surface.y) + surface.y * 0.88 * shine;
  lit.added += surface.y * (0.22 * shine + 0.5 * pow(h, 90.0) * open);
  return lit;
}

Lit Skin(vec3 p, vec3 n, float open, vec3 surface, float under_chin, vec3 lamp_seen) {
  Lit lit = SoftSkin(p, n, open, surface, lamp_seen);
  float soft = fill.w;
  lit.diffuse *= mix(vec3(1.0), kFlushed, surface.z);
  lit.diffuse = mix(vec3(PlainLight(n)) * key.w, Shoulder(lit.diffuse * under_chin * key.w), soft);
  lit.added *= soft * key.w;
  lit.gloss *= soft * key.w;
  return lit;
}
