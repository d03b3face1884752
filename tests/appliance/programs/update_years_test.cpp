// Whatever happens to a box in years, and wherever the power goes, it starts with a system that is whole and was seen to do well.
#include <gmock/gmock.h>

#include "tests/appliance/programs/update_years.h"

namespace kaori::update {
namespace {

// The effort of a release is in the hundreds; a box of 300 starts takes a quarter of a second.
std::uint32_t Boxes() {
  return 10 * std::max(1U, static_cast<std::uint32_t>(Effort() / 10));
}

// What the boxes before the first wrong one have lived through, and what is wrong with that.
std::pair<Lived, std::vector<std::string>> LiveYears(std::uint32_t boxes, BoxOfYears::Fault fault) {
  constexpr int kStarts = 300;
  Lived all;
  for (std::uint32_t seed = 1; seed <= boxes; ++seed) {
    BoxOfYears box(seed, fault);
    box.Live(kStarts);
    box.ComeToAGoodVersion();
    all += box.lived();
    if (!box.wrong().empty()) return {all, box.wrong()};
  }
  return {all, {}};
}

TEST(UpdateYears, OfABoxWhosePowerGoesAtAnyMomentAllStartWithWhatIsWholeAndWasSeenToDoWell) {
  const std::uint32_t boxes = Boxes();
  const auto [lived, wrong] = LiveYears(boxes, BoxOfYears::Fault::kNone);
  EXPECT_THAT(wrong, ::testing::IsEmpty());
  // Each thing has happened often enough to be worth anything.
  const auto each = static_cast<int>(boxes);
  EXPECT_GE(lived.starts, 300 * each);
  EXPECT_GE(lived.cuts, 40 * each);
  EXPECT_GE(lived.written, 20 * each);
  EXPECT_GE(lived.tries, 40 * each);
  EXPECT_GE(lived.stayed, 10 * each);
  EXPECT_GE(lived.gave_way, 5 * each);
  EXPECT_GE(lived.went_back, 5 * each);
  RecordProperty("years_starts", lived.starts);
  RecordProperty("years_cuts", lived.cuts);
  RecordProperty("years_wrong", static_cast<int>(wrong.size()));
}

// The controls: a disk that says it has flushed, a box that knows no lowest version, one that looks at no picture, and one that forgets what
// lay in a slot as soon as that is written.
TEST(UpdateYears, WouldGoWrongWithAnyOfFourFaults) {
  using enum BoxOfYears::Fault;
  bool are_found = true;
  for (const auto fault : {kDoesNotFlush, kKnowsNoLeast, kLooksAtNoPicture, kForgetsWhatLayThere}) {
    const auto wrong = LiveYears(60, fault).second;
    EXPECT_THAT(wrong, ::testing::Not(::testing::IsEmpty())) << static_cast<int>(fault);
    are_found = are_found && !wrong.empty();
  }
  RecordProperty("control_found", are_found ? 1 : 0);
}

}  // namespace
}  // namespace kaori::update
