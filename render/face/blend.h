// The sum at the heart of every frame: weighted arrays of floats, added up at the speed of memory. It is what
// equation 1 of Arai et al. 1994 asks for, once faces and expressions are composed (composites.h). A vertex
// is three packed floats, so that one loop serves x, y and z and the result needs no rearranging.
//
// Both functions are pure, allocate nothing and may run on any thread. On x86-64 they choose the wide units
// (AVX2 and FMA) at run time where the processor has them, on 64-bit ARM they are NEON; results then differ
// in the last bits, since a fused multiplication and addition rounds once.
#pragma once

#include <cstddef>
#include <span>

namespace kaori::face {

// One array of the sum.
struct Stream {
  // Borrowed; aligned to a cache line and readable up to a whole cache line (AlignedFloats).
  const float* values = nullptr;
  float weight = 0;
};

// Streams that give way: their sum is multiplied, float by float, by 1 - given_away * share. By this the
// mouth of an expression yields to the channels that speak.
struct Yielding {
  // Borrowed.
  std::span<const Stream> streams;
  // 0..1 for each float; aligned and padded like a stream. Not looked at where there are no streams.
  const float* share = nullptr;
  // 0: nothing .. 1: all that `share` says.
  float given_away = 0;
};

// out[i] = sum of weight * values[i] for i in [0, floats). `floats` is a multiple of kLineFloats, `out`
// aligned to a cache line and no part of any stream. No stream gives zeros.
void Blend(std::span<const Stream> streams, std::size_t floats, float* out);

// The same, plus the streams that give way.
void Blend(std::span<const Stream> streams, const Yielding& yielding, std::size_t floats, float* out);

}  // namespace kaori::face
