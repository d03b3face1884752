// The blend as a textbook writes it: arrays of structs, for each vertex a sum over the shapes.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

namespace kaori::benchmark {

using Shapes = std::vector<std::vector<glm::vec3>>;

void TextbookBlend(const Shapes& shapes, const std::vector<float>& weights, std::vector<glm::vec3>& out);

}  // namespace kaori::benchmark
