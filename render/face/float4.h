// Four floats at once: a packed vertex and the float behind it, which is carried along and ignored. GCC's
// vector extension makes SSE or NEON of it.
#pragma once

#include <cstring>

namespace kaori::face {

using Float4 [[gnu::vector_size(16)]] = float;

// Sixteen bytes from any float on: they need not be aligned, but must be there.
inline Float4 Load4(const float* at) {
  Float4 value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

// Overwrites the float behind the vertex too: write vertices in ascending order.
inline void Store4(float* at, Float4 value) {
  std::memcpy(at, &value, sizeof value);
}

// The cross product of the first three; the fourth is of no use.
inline Float4 Cross(Float4 a, Float4 b) {
  const Float4 a_yzx = __builtin_shufflevector(a, a, 1, 2, 0, 3);
  const Float4 b_yzx = __builtin_shufflevector(b, b, 1, 2, 0, 3);
  const Float4 c = a * b_yzx - a_yzx * b;
  return __builtin_shufflevector(c, c, 1, 2, 0, 3);
}

}  // namespace kaori::face
