#include "tests/benchmark/textbook_blend.h"

namespace kaori::benchmark {

void TextbookBlend(const Shapes& shapes, const std::vector<float>& weights, std::vector<glm::vec3>& out) {
  for (std::size_t v = 0; v < out.size(); ++v) {
    glm::vec3 sum{0, 0, 0};
    for (std::size_t k = 0; k < shapes.size(); ++k) sum += weights[k] * shapes[k][v];
    out[v] = sum;
  }
}

}  // namespace kaori::benchmark
