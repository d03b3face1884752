// The sum at the heart of every frame: weighted arrays of floats, added up at the speed of memory.
// A vertex is three packed floats, so that one loop serves x, y and z and the result needs no rearranging.
#pragma once

#include <cstddef>
#include <span>

namespace kaori::face {

// One array of the sum. `values` is aligned to a cache line and readable up to a whole cache line.
struct Stream {
  const float* values = nullptr;
  float weight = 0;
};

// Streams that give way where `share` (per float, 0..1) is high: each sum is multiplied by 1 - given_away *
// share.
struct Yielding {
  std::span<const Stream> streams;
  const float* share = nullptr;  // Aligned and padded like a stream.
  float given_away = 0;
};

// out[i] = sum of weight * values[i] for i in [0, floats). `floats` is a multiple of kLineFloats, `out`
// aligned to a cache line and no part of any stream. No stream gives zeros.
void Blend(std::span<const Stream> streams, std::size_t floats, float* out);

// The same, plus the streams that give way.
void Blend(std::span<const Stream> streams, const Yielding& yielding, std::size_t floats, float* out);

}  // namespace kaori::face
