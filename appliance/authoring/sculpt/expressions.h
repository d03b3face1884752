// Expressions as they are played: a displacement for each control point of both sides.
#pragma once

#include <vector>

#include "appliance/authoring/sculpt/expression_file.h"
#include "render/face/cast.h"

namespace kaori::sculpt {

// In metres; displacements stand in the order of MakeControlNet's points. What an expression builds on is
// added up here, so that each stands alone at run time. The file must have been read without a fault.
std::vector<face::Expression> MakeExpressions(const ExpressionFile& file);

}  // namespace kaori::sculpt
