#include "appliance/authoring/sculpt/animal.h"

#include <array>
#include <cmath>

#include "appliance/authoring/sculpt/ear_tube.h"
#include "appliance/authoring/sculpt/warp.h"

namespace kaori::sculpt {
namespace {

// Nearer to x = 0 than this lies in the middle: less than any two vertices are apart.
constexpr double kOnMiddle_cm = 1e-6;

// Corners, top and bottom of the lids' edge.
constexpr std::array<int, 4> kLidLandmarks{0, kEyeRim / 4, kEyeRim / 2, 3 * kEyeRim / 4};

// What the recipe says of the left half and the middle: its landmarks, four points of the lids' edge carried
// with the ball, and the ball's centre itself.
std::vector<Pull> LeftPulls(const HalfTopology& half, const HalfShape& reference, const EyeRecipe& eye,
                            const Warped& recipe) {
  std::vector<Pull> pulls;
  for (const Landmark& mark : recipe.landmarks) {
    pulls.push_back(
        {reference.position[half.At(mark.vertex.region, mark.vertex.a, mark.vertex.b)], mark.target});
  }
  const glm::dvec3 centre = eye.centre + recipe.eye_shift;
  for (int j : kLidLandmarks) {
    const glm::dvec3 p = reference.position[half.At(Region::kEye, j, kLidRing)];
    pulls.push_back({p, centre + (p - eye.centre) * recipe.eye_scale});
  }
  pulls.push_back({eye.centre, centre});
  return pulls;
}

// Mirrored, the warp is symmetric, and what lies in the middle has no reason to leave it.
std::vector<Pull> BothSides(std::vector<Pull> pulls) {
  const glm::dvec3 mirror(-1, 1, 1);
  const std::size_t left = pulls.size();
  for (std::size_t i = 0; i < left; ++i) {
    const Pull pull = pulls[i];
    if (std::abs(pull.from.x) > kOnMiddle_cm) pulls.push_back({pull.from * mirror, pull.to * mirror});
  }
  return pulls;
}

// Moves the grid half-way to the mean of its neighbours, `steps` times; rings and the neck's end stay. A warp
// that pulls a snout out of a nose stretches the cells around it unevenly; two or three steps even them out.
void SmoothGrid(const Cage& cage, int steps, HalfShape& shape) {
  const std::vector<std::vector<Index>> neighbours = Neighbours(cage);
  for (int step = 0; step < steps; ++step) {
    const std::vector<glm::dvec3> whole = WholePositions(cage, shape.position);
    for (Index half = 0; half < shape.position.size(); ++half) {
      const Key& key = cage.half.keys[half];
      if (key.region != Region::kGrid || key.b == 0) continue;
      const std::vector<Index>& around = neighbours[cage.Weld(cage.left[half])];
      glm::dvec3 mean{};
      for (Index v : around) mean += whole[v] / static_cast<double>(around.size());
      shape.position[half] = 0.5 * (shape.position[half] + mean);
    }
  }
}

}  // namespace

Ball BallOf(const Warped& recipe, const EyeRecipe& reference) {
  return {reference.centre + recipe.eye_shift, recipe.eye_radius, recipe.lid_thickness};
}

// The warp moves every vertex; lids and grid are put right after it, and the ear grows out of the finished
// grid.
Result<HalfShape> PullToLandmarks(const Cage& cage, const HalfShape& reference, const EyeRecipe& eye,
                                  const Warped& recipe) {
  const auto warp = Warp::Through(BothSides(LeftPulls(cage.half, reference, eye, recipe)));
  if (!warp) return FailInput("landmarks: two of them pull the same point");
  HalfShape shape = reference;
  for (glm::dvec3& p : shape.position) {
    const bool middle = std::abs(p.x) < kOnMiddle_cm;
    p = (*warp)(p);
    // To the last bit: the halves share these vertices.
    if (middle) p.x = 0;
  }
  const Ball ball = BallOf(recipe, eye);
  FitLids(cage.half, ball, ball.lid_thickness + kSkinOverLid_cm, shape);
  SmoothGrid(cage, recipe.smoothing_steps, shape);
  // Last: the ear's rings start from the grid about them.
  DrawOutEar(cage.half, recipe.ear, shape);
  return shape;
}

}  // namespace kaori::sculpt
