// Figures beside what is wanted of them.
#include "tests/benchmark/bars.h"

#include <gmock/gmock.h>

#include <array>
#include <limits>

namespace kaori::benchmark {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr std::array kWanted{Bar{"blend.ratio", 1.1}, Bar{"build.s", 480}};

Metric Measured(const char* name, double median) {
  return {.name = name, .unit = "", .median = median, .p99 = 1e9};
}

TEST(Bars, FindAFigureAboveItsBarAndNoneAtOrBelowIt) {
  const std::array figures{Measured("other.ms", 1e6), Measured("blend.ratio", 1.11),
                           Measured("build.s", 480)};
  const Comparison compared = CompareWithBars(figures, kWanted);
  EXPECT_THAT(compared.above, ElementsAre("too high: blend.ratio is 1.11, and at most 1.1 is wanted"));
  EXPECT_THAT(compared.missing, IsEmpty());
}

TEST(Bars, NameAFigureThatIsMissingAndDoNotTakeItForAGoodOne) {
  const std::array figures{Measured("blend.ratio", 1.0)};
  const Comparison compared = CompareWithBars(figures, kWanted);
  EXPECT_THAT(compared.above, IsEmpty());
  EXPECT_THAT(compared.missing, ElementsAre(HasSubstr("not measured: build.s, of which at most 480")));
}

TEST(Bars, DoNotLetPassWhatIsNoNumber) {
  const std::array figures{Measured("blend.ratio", std::numeric_limits<double>::quiet_NaN()),
                           Measured("build.s", 1)};
  EXPECT_THAT(CompareWithBars(figures, kWanted).above, ElementsAre(HasSubstr("blend.ratio is nan")));
}

TEST(Bars, AreOfRatiosAndOfBuilds) {
  ASSERT_NE(BarOf("blend.over_bare_loop", Bars()), nullptr);
  EXPECT_EQ(BarOf("blend.over_bare_loop", Bars())->most, 1.1);
  EXPECT_EQ(BarOf("frame.default.960x540.wall_ms", Bars()), nullptr);
  EXPECT_THAT(CompareWithBars({}, Bars()).missing, ::testing::Contains(HasSubstr("build.kernel_cpu_s")));
}

}  // namespace
}  // namespace kaori::benchmark
