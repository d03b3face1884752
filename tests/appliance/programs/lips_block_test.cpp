// Every way of keying gives the same bits as the key itself.
#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "appliance/programs/lips/paint_block.h"

namespace kaori::lips {
namespace {

constexpr std::size_t kBlocks = 5;
constexpr std::size_t kSamples = kBlocks * kBlock;

// Chroma in memory as a packing has it.
class Row {
 public:
  Row(Packing packing, std::mt19937& random) : bytes_(kSamples * 4 + 4) {
    std::ranges::generate(bytes_, [&] { return static_cast<std::uint8_t>(random()); });
    const std::uint8_t* at = bytes_.data();
    if (packing == Packing::kYuyv) row_ = {at + 1, at + 3, 4};
    if (packing == Packing::kNv12) row_ = {at, at + 1, 2};
    if (packing == Packing::kPlanar) row_ = {at, at + kSamples, 1};
  }
  const ChromaRow& row() const { return row_; }

 private:
  std::vector<std::uint8_t> bytes_;
  ChromaRow row_;
};

Paint AnyPaint(std::mt19937& random) {
  const auto level = [&] { return static_cast<std::uint8_t>(random()); };
  return {level(), level(), level()};
}

KeySettings AnySettings(std::mt19937& random) {
  const auto value = [&] { return static_cast<float>(1 + random() % 1000); };
  return {value(), value(), value()};
}

void ExpectSameBits(KeyBlocks key, Packing packing) {
  std::mt19937 random(5);
  for (int round = 0; round < 300; ++round) {
    const PaintKey paint(AnyPaint(random), AnySettings(random));
    const Row memory(packing, random);
    const ChromaRow& row = memory.row();
    std::vector<std::uint64_t> bits(kBlocks);
    key(row, kBlocks, paint.weak(), bits.data());
    for (std::size_t n = 0; n < kSamples; ++n) {
      const bool is_paint = paint.at(row.cb[n * row.step], row.cr[n * row.step]);
      ASSERT_EQ((bits[n / kBlock] >> n % kBlock & 1) != 0, is_paint)
          << "sample " << n << " of round " << round;
    }
  }
}

class KeyOfBlocks : public ::testing::TestWithParam<Packing> {};

TEST_P(KeyOfBlocks, IsTheKeyOfEachSample) {
  ExpectSameBits(PlainKey(GetParam()), GetParam());
  ExpectSameBits(WidestKey(GetParam()), GetParam());
}

TEST_P(KeyOfBlocks, IsTheSameWithEveryProcessorsInstructions) {
  int compared = 0;
  for (const KeyBlocks key : {Sse2Key(GetParam()), Avx2Key(GetParam()), NeonKey(GetParam())}) {
    if (key == nullptr) continue;
    ExpectSameBits(key, GetParam());
    ++compared;
  }
  if (compared == 0) GTEST_SKIP() << "this processor has neither SSE2 nor AVX2 nor NEON";
#if defined(__x86_64__)
  if (Avx2Key(GetParam()) == nullptr) GTEST_SKIP() << "SSE2 is as it should be; this processor has no AVX2";
#endif
}

INSTANTIATE_TEST_SUITE_P(Of, KeyOfBlocks,
                         ::testing::Values(Packing::kYuyv, Packing::kNv12, Packing::kPlanar));

}  // namespace
}  // namespace kaori::lips
