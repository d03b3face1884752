#include "tests/benchmark/bare_loop.h"

#if defined(__x86_64__)
#define KAORI_EACH_UNIT [[gnu::target_clones("arch=haswell", "default")]]
#else
#define KAORI_EACH_UNIT
#endif

namespace kaori::benchmark {

KAORI_EACH_UNIT void BareLoop(const std::array<const float*, 4>& shapes, const std::array<float, 4>& weights,
                              std::size_t floats, float* __restrict out) {
  const auto [a, b, c, d] = shapes;
  const auto [s, t, u, v] = weights;
  for (std::size_t i = 0; i < floats; ++i) out[i] = s * a[i] + t * b[i] + u * c[i] + v * d[i];
}

}  // namespace kaori::benchmark
