// The method once more, in double precision and in its plainest form: what the fast code is compared with.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "render/face/cast.h"
#include "render/face/weights.h"

namespace kaori::tests {

using Positions = std::vector<glm::dvec3>;

// P_ij: face i wearing expression j, without lids.
Positions ReferenceComposite(const face::Cast& cast, std::size_t face, std::size_t expression);

// sum_i s_i ( B_i + sum_j t_j E_ij (1 - given_away m) + sum_k c_k A_ik ), without lids. Weights are taken as
// they are.
Positions ReferenceShape(const face::Cast& cast, const face::Weights& weights);

// The height of the reference face, metres.
double HeadHeight_m(const face::Cast& cast);

// The largest distance between the two, metres; both have the same number of vertices.
double LargestError_m(const Positions& wanted, std::span<const glm::vec3> got);

}  // namespace kaori::tests
