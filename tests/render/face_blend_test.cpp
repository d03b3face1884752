// The sum of streams, against the plain loop.
#include "render/face/blend.h"

#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "render/face/aligned.h"

namespace kaori::face {
namespace {

AlignedFloats Random(std::size_t floats, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> value(-0.2F, 0.2F);
  AlignedFloats values(floats);
  for (std::size_t i = 0; i < floats; ++i) values.data()[i] = value(random);
  return values;
}

struct Inputs {
  std::vector<AlignedFloats> arrays;
  std::vector<Stream> streams;
};

Inputs MakeInputs(std::size_t count, std::size_t floats, unsigned seed) {
  Inputs inputs;
  for (unsigned k = 0; k < count; ++k) inputs.arrays.push_back(Random(floats, seed + k));
  for (const AlignedFloats& a : inputs.arrays) {
    inputs.streams.push_back({a.data(), 0.9F - 0.3F * static_cast<float>(inputs.streams.size())});
  }
  return inputs;
}

double SumAt(const std::vector<Stream>& streams, std::size_t i) {
  double sum = 0;
  for (const Stream& s : streams) sum += static_cast<double>(s.weight) * static_cast<double>(s.values[i]);
  return sum;
}

TEST(Blend, SumsAnyNumberOfStreamsOfAnyLength) {
  for (const std::size_t floats : {16UL, 48UL, 128UL, 8448UL, 8464UL}) {
    for (const std::size_t count : {1UL, 2UL, 4UL, 7UL}) {
      const Inputs inputs = MakeInputs(count, floats, 1);
      AlignedFloats out(floats);
      Blend(inputs.streams, floats, out.data());
      for (std::size_t i = 0; i < floats; ++i) {
        ASSERT_NEAR(static_cast<double>(out.data()[i]), SumAt(inputs.streams, i), 3e-7)
            << count << " of " << floats;
      }
    }
  }
}

TEST(Blend, WritesNothingBehindTheEnd) {
  const Inputs inputs = MakeInputs(2, 64, 1);
  AlignedFloats out(96);
  std::fill_n(out.data(), out.size(), 5.0F);
  Blend(inputs.streams, 48, out.data());
  for (std::size_t i = 48; i < out.size(); ++i) ASSERT_EQ(out.data()[i], 5.0F);
}

TEST(Blend, GivesZerosForNoStream) {
  AlignedFloats out(32);
  std::fill_n(out.data(), 32, 5.0F);
  Blend({}, 32, out.data());
  for (std::size_t i = 0; i < 32; ++i) ASSERT_EQ(out.data()[i], 0.0F);
}

TEST(Blend, LetsStreamsGiveWayWhereTheyAreShared) {
  constexpr std::size_t kFloats = 160;
  const Inputs own = MakeInputs(3, kFloats, 1);
  const Inputs others = MakeInputs(2, kFloats, 9);
  AlignedFloats share(kFloats);
  for (std::size_t i = 0; i < kFloats; ++i) share.data()[i] = static_cast<float>(i) / kFloats;
  AlignedFloats out(kFloats);
  Blend(others.streams, {own.streams, share.data(), 0.75F}, kFloats, out.data());
  for (std::size_t i = 0; i < kFloats; ++i) {
    const double kept = 1 - 0.75 * static_cast<double>(share.data()[i]);
    ASSERT_NEAR(static_cast<double>(out.data()[i]), kept * SumAt(own.streams, i) + SumAt(others.streams, i),
                3e-7);
  }
}

}  // namespace
}  // namespace kaori::face
