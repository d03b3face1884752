// Dials by edges with numbers: none is lost silently, and none that is missing becomes a turn.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <random>
#include <vector>

#include "drivers/decode/quadrature.h"
#include "tests/drivers/hid_devices.h"
#include "tests/firmware/figures.h"

namespace kaori::decode {
namespace {

// A hand on the shafts of eight encoders, and a kernel that numbers their edges.
class Shafts {
 public:
  std::uint32_t levels() const {
    std::uint32_t levels = 0;
    for (std::size_t n = 0; n < places.size(); ++n) {
      const auto quarter = static_cast<unsigned>(places[n]) & 3U;
      const unsigned a = quarter == 1 || quarter == 2 ? 1 : 0, b = quarter >= 2 ? 1 : 0;
      levels |= (a | b << 1U) << 2 * n;
    }
    return levels;
  }
  DialEdge Step(std::size_t dial, bool forth) {
    const std::uint32_t before = levels();
    places[dial] += forth ? 1 : -1;
    const std::uint32_t changed = before ^ levels();
    const auto line = static_cast<std::uint32_t>(std::countr_zero(changed));
    now += std::chrono::microseconds(20);
    return {.at = now, .line = line, .active = (levels() & changed) != 0, .sequence = ++sequence};
  }
  std::array<std::int32_t, 8> places{};
  Time now = tests::At(1);
  std::uint32_t sequence = 0;
};

TEST(Quadrature, EveryEdgeOfAHandIsACountEachWay) {
  Shafts shafts;
  QuadratureDials dials(shafts.levels());
  std::mt19937 dice(17);
  constexpr int kEdges = 1'000'000;
  for (int n = 0; n < kEdges; ++n) EXPECT_TRUE(dials.Accept(shafts.Step(dice() % 8, dice() % 3 != 0)));
  EXPECT_EQ(dials.counts(), shafts.places);
  EXPECT_EQ(dials.gaps(), 0U);
}

TEST(Quadrature, AGapIsCountedAndMovesNothingAndTheDialGoesOnFromItsLevels) {
  Shafts shafts;
  QuadratureDials dials(shafts.levels());
  for (int n = 0; n < 5; ++n) dials.Accept(shafts.Step(2, true));
  for (int n = 0; n < 16; ++n) shafts.Step(2, true);  // The kernel drops these.
  EXPECT_FALSE(dials.Accept(shafts.Step(2, true)));
  EXPECT_TRUE(dials.needs_levels());
  const DialEdge waits = shafts.Step(2, true);  // It came before the levels were read.
  dials.Resume(shafts.levels(), shafts.now);
  EXPECT_FALSE(dials.Accept(waits));
  EXPECT_EQ(dials.counts()[2], 5);
  for (int n = 0; n < 3; ++n) EXPECT_TRUE(dials.Accept(shafts.Step(2, false)));
  EXPECT_EQ(dials.counts()[2], 2);
  EXPECT_EQ(dials.gaps(), 1U);
}

TEST(Quadrature, OverManyGapsNoDialMovesMoreThanTheEdgesThatCame) {
  Shafts shafts;
  QuadratureDials dials(shafts.levels());
  std::mt19937 dice(3);
  std::uint64_t gaps = 0;
  for (int n = 0; n < 20'000; ++n) {
    const auto before = dials.counts();
    std::array<std::int32_t, 8> came{};
    for (unsigned edge = 0; edge < 1 + dice() % 40; ++edge) {
      const std::size_t dial = dice() % 8;
      const auto at = shafts.places[dial];
      if (dials.Accept(shafts.Step(dial, dice() % 2 == 0))) came[dial] += shafts.places[dial] - at;
    }
    for (std::size_t dial = 0; dial < 8; ++dial) ASSERT_EQ(dials.counts()[dial] - before[dial], came[dial]);
    for (unsigned lost = 0; lost < 1 + dice() % 9; ++lost) shafts.Step(dice() % 8, dice() % 2 == 0);
    ASSERT_FALSE(dials.Accept(shafts.Step(0, true)));
    shafts.now += QuadratureDials::kLongestEarly;
    ASSERT_TRUE(dials.Expire(shafts.now));
    dials.Resume(shafts.levels(), shafts.now);
    ++gaps;
  }
  EXPECT_EQ(dials.gaps(), gaps);
  proof::Figure("gpio_gaps_counted", gaps);
}

// As by threads of two lines on two processors.
TEST(Quadrature, EdgesThatOvertakeEachOtherAllCount) {
  Shafts shafts;
  QuadratureDials dials(shafts.levels());
  std::mt19937 dice(5);
  for (int n = 0; n < 20'000; ++n) {
    std::vector<DialEdge> flying;
    for (unsigned edge = 0; edge < 1 + dice() % 16; ++edge)
      flying.push_back(shafts.Step(dice() % 8, dice() % 3 != 0));
    std::ranges::shuffle(flying, dice);
    for (const DialEdge& edge : flying) dials.Accept(edge);
    ASSERT_EQ(dials.counts(), shafts.places);
  }
  EXPECT_EQ(dials.gaps(), 0U);
}

TEST(Quadrature, AnEdgeWaitsForTheOneBeforeNoLongerThanItMay) {
  Shafts shafts;
  QuadratureDials dials(shafts.levels());
  const DialEdge late = shafts.Step(1, true), early = shafts.Step(3, true);
  EXPECT_FALSE(dials.Accept(early));
  EXPECT_FALSE(dials.Expire(early.at + QuadratureDials::kLongestEarly - Duration(1)));
  EXPECT_TRUE(dials.Expire(early.at + QuadratureDials::kLongestEarly));
  dials.Resume(shafts.levels(), early.at + QuadratureDials::kLongestEarly);
  EXPECT_FALSE(dials.Accept(late)) << "it is in the levels";
  EXPECT_EQ(dials.counts(), (std::array<std::int32_t, 8>{}));
  EXPECT_EQ(dials.gaps(), 1U);
}

TEST(Quadrature, AnEdgeToTheLevelThatALineHasIsNoTurn) {
  QuadratureDials dials(0);
  EXPECT_TRUE(dials.Accept({.at = tests::At(1), .line = 0, .active = true, .sequence = 1}));
  EXPECT_FALSE(dials.Accept({.at = tests::At(2), .line = 0, .active = true, .sequence = 2}));
  EXPECT_FALSE(dials.Accept({.at = tests::At(3), .line = 99, .active = true, .sequence = 3}));
  EXPECT_EQ(dials.counts()[0], 1);
}

}  // namespace
}  // namespace kaori::decode
