#include "render/face/blend.h"

#include <cstring>

#include "render/face/aligned.h"

namespace kaori::face {
namespace {

#if defined(__x86_64__)
// The build aims at any 64-bit PC; the wider units of the machine at hand are chosen when the program runs.
#define KAORI_TARGET(name) [[gnu::target(name)]]
#endif

using Lane4 [[gnu::vector_size(16)]] = float;
using Lane8 [[gnu::vector_size(32)]] = float;
using Lane16 [[gnu::vector_size(64)]] = float;

// A block of the sum that stays in registers.
template <class Lane, std::size_t kLanes>
struct Block {
  static constexpr std::size_t kLaneFloats = sizeof(Lane) / sizeof(float);
  static constexpr std::size_t kFloats = kLaneFloats * kLanes;
  Lane lanes[kLanes];

  [[gnu::always_inline]] void Clear() { std::memset(lanes, 0, sizeof lanes); }

  [[gnu::always_inline]] void Add(const Stream& stream, std::size_t at) {
    const float* values = stream.values + at;
    for (std::size_t i = 0; i < kLanes; ++i) {
      Lane lane;
      std::memcpy(&lane, values + i * kLaneFloats, sizeof lane);
      lanes[i] += lane * stream.weight;
    }
  }

  [[gnu::always_inline]] void GiveWay(const Yielding& yielding, std::size_t at) {
    const float* share = yielding.share + at;
    for (std::size_t i = 0; i < kLanes; ++i) {
      Lane lane;
      std::memcpy(&lane, share + i * kLaneFloats, sizeof lane);
      lanes[i] *= 1.0F - lane * yielding.given_away;
    }
  }

  [[gnu::always_inline]] void Store(float* out) const { std::memcpy(out, lanes, sizeof lanes); }
};

struct Sum {
  std::span<const Stream> streams;
  Yielding yielding;
  std::size_t floats = 0;
  float* out = nullptr;
};

template <class AnyBlock>
[[gnu::always_inline]] inline void SumBlock(const Sum& sum, std::size_t at) {
  AnyBlock block;
  block.Clear();
  if (!sum.yielding.streams.empty()) {
    for (const Stream& stream : sum.yielding.streams) block.Add(stream, at);
    block.GiveWay(sum.yielding, at);
  }
  for (const Stream& stream : sum.streams) block.Add(stream, at);
  block.Store(sum.out + at);
}

template <class Wide, class Line>
[[gnu::always_inline]] inline void SumAll(const Sum& sum) {
  std::size_t at = 0;
  for (; at + Wide::kFloats <= sum.floats; at += Wide::kFloats) SumBlock<Wide>(sum, at);
  for (; at < sum.floats; at += Line::kFloats) SumBlock<Line>(sum, at);
}

void SumBaseline(const Sum& sum) {
  SumAll<Block<Lane4, 8>, Block<Lane4, 4>>(sum);
}

#if defined(KAORI_TARGET)
KAORI_TARGET("avx2,fma") void SumAvx2(const Sum& sum) {
  SumAll<Block<Lane8, 8>, Block<Lane8, 2>>(sum);
}
KAORI_TARGET("avx512f") void SumAvx512(const Sum& sum) {
  SumAll<Block<Lane16, 8>, Block<Lane16, 1>>(sum);
}
#endif

using Kernel = void (*)(const Sum&);

Kernel FastestKernel() {
#if defined(KAORI_TARGET)
  if (__builtin_cpu_supports("avx512f") != 0) return SumAvx512;
  if (__builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0) return SumAvx2;
#endif
  return SumBaseline;
}

void RunFastest(const Sum& sum) {
  static const Kernel kernel = FastestKernel();
  kernel(sum);
}

}  // namespace

void Blend(std::span<const Stream> streams, std::size_t floats, float* out) {
  RunFastest({.streams = streams, .yielding = {}, .floats = floats, .out = out});
}

void Blend(std::span<const Stream> streams, const Yielding& yielding, std::size_t floats, float* out) {
  RunFastest({.streams = streams, .yielding = yielding, .floats = floats, .out = out});
}

}  // namespace kaori::face
