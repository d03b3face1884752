// The blend as the least code that sums four arrays of floats in one pass: what the blend is compared with.
#pragma once

#include <array>
#include <cstddef>

namespace kaori::benchmark {

// out[i] = the sum over k of weights[k] * shapes[k][i] for i in [0, floats). `floats` is a multiple of 16, and no
// array overlaps `out`. On x86-64 the compiler vectorizes it for the widest unit that the processor has, as the
// blend chooses its own.
void BareLoop(const std::array<const float*, 4>& shapes, const std::array<float, 4>& weights,
              std::size_t floats, float* out);

}  // namespace kaori::benchmark
