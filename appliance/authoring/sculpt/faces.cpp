#include "appliance/authoring/sculpt/faces.h"

#include <utility>

#include <glm/geometric.hpp>

#include "appliance/authoring/sculpt/animal.h"
#include "appliance/authoring/sculpt/carve.h"
#include "appliance/authoring/sculpt/kettle.h"

namespace kaori::sculpt {
namespace {

// The only places where lengths of this folder become metres are here and in expressions.cpp.
glm::vec3 Metres(glm::dvec3 p_cm) {
  return glm::vec3(p_cm * kMetresPerCentimetre);
}
float Metres(double length_cm) {
  return static_cast<float>(length_cm * kMetresPerCentimetre);
}

// Shapes a face by the kind of its recipe (a visitor). The reference is carved once, since animals and
// kettles are made from it. Borrows cage and recipes.
class Shaper {
 public:
  Shaper(const Cage& cage, const CastRecipe& cast)
      : cage_(cage), cast_(cast), eye_(std::get<Carved>(cast.faces.front().shape).eye) {
    reference_ = Carve(cage.half, cast.aim, std::get<Carved>(cast.faces.front().shape));
  }

  Result<ShapedFace> operator()(const Carved& recipe) const {
    const EyeRecipe& eye = recipe.eye;
    ShapedFace face{Carve(cage_.half, cast_.aim, recipe), {eye.centre, eye.radius, eye.thickness}};
    // All faces share the reference's uv: one parameter space.
    face.shape.uv_cm = reference_.uv_cm;
    return face;
  }

  Result<ShapedFace> operator()(const Warped& recipe) const {
    Result<HalfShape> shape = PullToLandmarks(cage_, reference_, eye_, recipe);
    if (!shape) return tl::unexpected(shape.error());
    return ShapedFace{std::move(*shape), BallOf(recipe, eye_)};
  }

  Result<ShapedFace> operator()(const Turned& recipe) const {
    Result<Kettle> kettle = Turn(cage_.half, reference_, eye_, recipe);
    if (!kettle) return tl::unexpected(kettle.error());
    return ShapedFace{std::move(kettle->shape), kettle->eye};
  }

  Result<ShapedFace> operator()(const Modelled& recipe) const {
    Result<ModelledHead> head = ReadModelledHead(cage_, reference_, recipe);
    if (!head) return tl::unexpected(head.error());
    ShapedFace face{{{}, reference_.uv_cm}, head->eyes[0]};
    for (const Index vertex : cage_.left) face.shape.position.push_back(head->position[vertex]);
    const Mouth own = MouthOf(*head);
    const Mouth first = MouthOf({WholePositions(cage_, reference_.position), {}});
    // Teeth and tongue are modelled for the reference's mouth.
    face.mouth_scale = own.width / first.width;
    face.mouth_shift = own.middle - first.middle;
    face.whole = std::move(*head);
    return face;
  }

 private:
  // Between the corners of the shut mouth, and in the middle where the lips meet.
  struct Mouth {
    double width = 0;
    glm::dvec3 middle{};
  };
  Mouth MouthOf(const ModelledHead& head) const {
    const auto at = [&](const std::vector<Index>& side, int j) {
      return head.position[side[cage_.half.At(Region::kMouth, j, kLipContactRing)]];
    };
    return {glm::distance(at(cage_.left, kMouthCorner), at(cage_.right, kMouthCorner)),
            0.5 * (at(cage_.left, 0) + at(cage_.left, kMouthRim - 1))};
  }

  const Cage& cage_;
  const CastRecipe& cast_;
  EyeRecipe eye_;
  HalfShape reference_;
};

// On its own side already.
face::EyeBall MakeEye(const Ball& ball) {
  return {Metres(ball.centre), Metres(ball.radius), Metres(ball.lid_thickness)};
}

// [0] is the character's left, at +X.
std::array<face::EyeBall, 2> MakeEyes(const ShapedFace& shaped) {
  if (shaped.whole) return {MakeEye(shaped.whole->eyes[0]), MakeEye(shaped.whole->eyes[1])};
  const face::EyeBall ball = MakeEye(shaped.eye);
  face::EyeBall mirrored = ball;
  mirrored.centre.x = -mirrored.centre.x;
  return {ball, mirrored};
}

}  // namespace

// The first fault ends it; CheckFolder asks for each face by itself.
Result<std::vector<ShapedFace>> ShapeFaces(const Cage& cage, const CastRecipe& cast) {
  const Shaper shaper(cage, cast);
  std::vector<ShapedFace> faces;
  for (const FaceRecipe& recipe : cast.faces) {
    Result<ShapedFace> face = std::visit(shaper, recipe.shape);
    if (!face) return FailInput(recipe.file + ": " + face.error().attempt);
    faces.push_back(std::move(*face));
  }
  return faces;
}

// Only what follows from the recipe's shape; clothes, textures and expressions are added by others.
face::Face MakeFace(const Cage& cage, const FaceRecipe& recipe, const ShapedFace& shaped) {
  face::Face face;
  face.name = recipe.name;
  for (const glm::dvec3& p :
       shaped.whole ? shaped.whole->position : WholePositions(cage, shaped.shape.position))
    face.positions.push_back(Metres(p));
  face.eyes = MakeEyes(shaped);
  face.mouth = {.scale = static_cast<float>(shaped.mouth_scale * recipe.teeth_scale),
                .offset = Metres(shaped.mouth_shift + recipe.teeth_offset),
                .upper_teeth = static_cast<float>(recipe.upper_teeth),
                .lower_teeth = static_cast<float>(recipe.lower_teeth),
                .tongue = static_cast<float>(recipe.tongue)};
  face.expression_gain = static_cast<float>(recipe.expression_gain);
  return face;
}

}  // namespace kaori::sculpt
