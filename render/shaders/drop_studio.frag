// A sweep of paper that comes down from the wall to the floor, and a lamp on it behind the head.
#include "drop.glsl"
void main() {
  float floor_share = Below(uv.y, -0.62, 0.22);
  vec3 paper = mix(Wall(), bottom * 1.25, floor_share);
  float pool = Pool(vec2(0.10, 0.12), vec2(1.05, 0.80));
  float on_floor = Pool(vec2(0.15, -1.05), vec2(1.30, 0.40));
  float seam = 0.22 * Pool(vec2(0.0, -0.60), vec2(3.0, 0.16));
  Show(paper * (0.50 - seam) + (paper * 1.5 + 0.03) * glow * (pool + 0.35 * on_floor));
}
