#include "appliance/authoring/import/shapes_on_show.h"

#include <algorithm>
#include <utility>

#include <glm/vec3.hpp>

#include "appliance/authoring/import/role_names.h"

namespace kaori::import {
namespace {

// The show's lids ride on its eyeballs: a blink shuts them, instead of pulling at control points.
void GiveToLids(const Heads& heads, const Shape& shape, std::size_t side, const face::Topology& topology,
                face::Expression& expression) {
  // The shape itself must be the blink: one that only squints keeps pulling.
  const Role* blink = FindRole(heads, kBlinks[side]);
  if (blink == nullptr || topology.lids[side].columns == 0) return;
  if (heads.shapes[blink->parts.front().shape].name != shape.name) return;
  expression.displacement.assign(expression.displacement.size(), glm::vec3(0));
  expression.residual.clear();
  expression.lids[side] = 1;
}

}  // namespace

// Each is fitted to the control points of the show, which is how all of its faces can wear it.
std::vector<ReportedShape> GiveShapes(const Heads& heads, const Bridge& to_show, face::Cast& cast) {
  std::vector<ReportedShape> reported;
  const ShapeFit fit(cast.net, cast.faces.front().positions);
  for (const Shape& shape : heads.shapes) {
    FitError error;
    // Operators call expressions by name, so that none may hide another.
    const bool taken =
        std::ranges::find(cast.expressions, shape.name, &face::Expression::name) != cast.expressions.end();
    const std::string name = taken ? shape.name + " (shape)" : shape.name;
    face::Expression expression =
        fit.Fit(name, face::ExpressionKind::kChannel, to_show.Carry(shape.offsets), error);
    for (std::size_t side = 0; side < 2; ++side) GiveToLids(heads, shape, side, cast.topology, expression);
    cast.expressions.push_back(std::move(expression));
    reported.push_back({shape.name, MeaningIn(shape), error});
  }
  return reported;
}

}  // namespace kaori::import
