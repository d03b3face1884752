#include "appliance/authoring/sculpt/sculpt.h"

#include <utility>

#include "appliance/authoring/sculpt/cage.h"
#include "appliance/authoring/sculpt/control_net.h"
#include "appliance/authoring/sculpt/expression_file.h"
#include "appliance/authoring/sculpt/expressions.h"
#include "appliance/authoring/sculpt/faces.h"
#include "appliance/authoring/sculpt/outgrowth.h"
#include "appliance/authoring/sculpt/recipe_file.h"
#include "appliance/authoring/sculpt/topology.h"

namespace kaori::sculpt {
namespace {

// The head turns where the neck meets the skull; teeth are scaled about the middle of the lips. Metres, on
// the reference face.
constexpr glm::vec3 kNeckPivot_m{0, -0.06F, -0.015F};
constexpr glm::vec3 kMouthAnchor_m{0, -0.0585F, 0.083F};

}  // namespace

Result<void> Sculpt(const std::filesystem::path& show_folder, face::Cast& cast) {
  const Result<CastRecipe> recipe = ReadCastRecipe(show_folder / "faces");
  if (!recipe) return tl::unexpected(recipe.error());
  const Cage cage = BuildCage();
  const Result<std::vector<ShapedFace>> shaped = ShapeFaces(cage, *recipe);
  if (!shaped) return tl::unexpected(shaped.error());
  // The first face, on which expressions are written.
  const HalfShape& reference = shaped->front().shape;

  const std::filesystem::path expressions = show_folder / "expressions.toml";
  const Result<ExpressionFile> file = ReadExpressionFile(expressions, cage.half, reference);
  if (!file) return tl::unexpected(file.error());
  Result<face::ControlNet> net = MakeControlNet(cage, reference, *file);
  if (!net) return FailInput(expressions.string() + ": " + net.error().attempt);

  // Nothing of `cast` is touched until all that can fail is done.
  cast.topology = MakeTopology(cage, reference);
  cast.net = std::move(*net);
  cast.expressions = MakeExpressions(*file);
  cast.faces.clear();
  for (std::size_t i = 0; i < shaped->size(); ++i) {
    cast.faces.push_back(MakeFace(cage, recipe->faces[i], (*shaped)[i]));
  }
  AddOutgrowths(cage, *shaped, *recipe, cast);
  cast.neck_pivot = kNeckPivot_m;
  cast.mouth_anchor = kMouthAnchor_m;
  return {};
}

}  // namespace kaori::sculpt
