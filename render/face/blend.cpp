#include "render/face/blend.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "render/face/aligned.h"

// Shapes are floats on purpose. Kept as 16-bit numbers four shapes of 25 000 vertices blend in 7.3 to 10.6 us
// instead of 15, of a frame of 17 ms; a pack would be smaller by half of its positions, which are 1 % of it
// (most are textures), and each reader, check and importer would have a scale for each shape to keep.

// The build aims at any machine; on a PC, its wider units are used where it has them. Wider than eight floats
// does not pay: the sum waits for memory.
#if defined(__x86_64__)
#define KAORI_WIDE_UNITS [[gnu::target("avx2,fma")]]
#endif

namespace kaori::face {
namespace {

// Streams that are read side by side; more confuse the prefetcher.
constexpr std::size_t kGroup = 8;
constexpr std::size_t kChunk_floats =
    1024;  // Between groups, a chunk of the result stays in the first cache.

// GCC's vector extension: four floats are SSE or NEON, eight are AVX.
using Lane4 [[gnu::vector_size(16)]] = float;
using Lane8 [[gnu::vector_size(32)]] = float;

// By memcpy, which is a load here: addresses are aligned, types are not the same.
template <class Lane>
[[gnu::always_inline]] inline void Load(Lane& lane, const float* at) {
  std::memcpy(&lane, at, sizeof lane);
}

// The number of streams is known to the compiler, so that weights and addresses stay in registers.
template <class Lane, std::size_t... kStream>
[[gnu::always_inline]] inline void SumOf(const Stream* streams, std::size_t floats, float* out,
                                         std::index_sequence<kStream...>) {
  const float* const values[]{streams[kStream].values...};
  // The weight in every lane.
  const Lane weights[]{(Lane{} + streams[kStream].weight)...};
  for (std::size_t at = 0; at < floats; at += sizeof(Lane) / sizeof(float)) {
    Lane sum{};
    Lane lane;
    ((Load(lane, values[kStream] + at), sum += lane * weights[kStream]), ...);
    std::memcpy(out + at, &sum, sizeof sum);
  }
}

// out[i] *= 1 - given_away * share[i].
template <class Lane>
[[gnu::always_inline]] inline void GiveWay(const float* share, float given_away, std::size_t floats,
                                           float* out) {
  for (std::size_t at = 0; at < floats; at += sizeof(Lane) / sizeof(float)) {
    Lane shared;
    Lane value;
    Load(shared, share + at);
    Load(value, out + at);
    value *= 1.0F - shared * given_away;
    std::memcpy(out + at, &value, sizeof value);
  }
}

// What one kind of vector unit offers: sums of 0 to kGroup streams, and giving way.
struct Kernels {
  using Sum = void (*)(const Stream* streams, std::size_t floats, float* out);
  std::array<Sum, kGroup + 1> sums{};
  void (*give_way)(const float* share, float given_away, std::size_t floats, float* out) = nullptr;
};

template <std::size_t kStreams>
void BaselineSum(const Stream* streams, std::size_t floats, float* out) {
  SumOf<Lane4>(streams, floats, out, std::make_index_sequence<kStreams>());
}

void BaselineGiveWay(const float* share, float given_away, std::size_t floats, float* out) {
  GiveWay<Lane4>(share, given_away, floats, out);
}

void Clear(const Stream* /*streams*/, std::size_t floats, float* out) {
  std::fill_n(out, floats, 0.0F);
}

// One function for each number of streams, by its index: sums[n] adds up n.
template <std::size_t... kBefore>
constexpr Kernels BaselineKernels(std::index_sequence<kBefore...> /*below*/) {
  return {{Clear, BaselineSum<kBefore + 1>...}, BaselineGiveWay};
}

#if defined(KAORI_WIDE_UNITS)
template <std::size_t kStreams>
KAORI_WIDE_UNITS void WideSum(const Stream* streams, std::size_t floats, float* out) {
  SumOf<Lane8>(streams, floats, out, std::make_index_sequence<kStreams>());
}

KAORI_WIDE_UNITS void WideGiveWay(const float* share, float given_away, std::size_t floats, float* out) {
  GiveWay<Lane8>(share, given_away, floats, out);
}

template <std::size_t... kBefore>
constexpr Kernels WideKernels(std::index_sequence<kBefore...> /*below*/) {
  return {{Clear, WideSum<kBefore + 1>...}, WideGiveWay};
}
#endif

// Both extensions are asked for: AVX2 without FMA exists.
Kernels FastestKernels() {
#if defined(KAORI_WIDE_UNITS)
  if (__builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0) {
    return WideKernels(std::make_index_sequence<kGroup>());
  }
#endif
  return BaselineKernels(std::make_index_sequence<kGroup>());
}

// Asked once: the processor does not change.
const Kernels& FastestKernelsHere() {
  static const Kernels kernels = FastestKernels();
  return kernels;
}

// Sums the streams from `at` on into `out`, which counts as one stream more where something is there already.
void SumChunk(std::span<const Stream> streams, std::size_t at, std::size_t floats, float* out, bool add) {
  std::array<Stream, kGroup> group;
  do {
    std::size_t size = 0;
    if (add) group[size++] = {out, 1};
    // The result so far takes the place of one stream.
    const std::size_t taken = std::min(streams.size(), kGroup - size);
    for (const Stream& s : streams.first(taken)) group[size++] = {s.values + at, s.weight};
    FastestKernelsHere().sums[size](group.data(), floats, out);
    streams = streams.subspan(taken);
    add = true;
  } while (!streams.empty());
}

}  // namespace

void Blend(std::span<const Stream> streams, std::size_t floats, float* out) {
  Blend(streams, {}, floats, out);
}

// One group is summed in one go. More streams, or streams that yield, are summed chunk by chunk, so that what
// lies between two passes stays in the first cache.
void Blend(std::span<const Stream> streams, const Yielding& yielding, std::size_t floats, float* out) {
  const bool one_pass = yielding.streams.empty() && streams.size() <= kGroup;
  const std::size_t chunk = one_pass ? std::max<std::size_t>(floats, 1) : kChunk_floats;
  for (std::size_t at = 0; at < floats; at += chunk) {
    const std::size_t size = std::min(chunk, floats - at);
    // The yielding sum first, so that it alone gives way; all else is added to it.
    if (!yielding.streams.empty()) {
      SumChunk(yielding.streams, at, size, out + at, false);
      FastestKernelsHere().give_way(yielding.share + at, yielding.given_away, size, out + at);
    }
    // Without any stream at all the chunk is still cleared.
    if (yielding.streams.empty() || !streams.empty()) {
      SumChunk(streams, at, size, out + at, !yielding.streams.empty());
    }
  }
}

}  // namespace kaori::face
