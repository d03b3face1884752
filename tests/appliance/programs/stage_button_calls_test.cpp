// What the stage says on the board of its buttons, by which keys with pictures find theirs.
#include <gtest/gtest.h>

#include "appliance/core/roles/own_buttons.h"
#include "appliance/programs/stage/show_now.h"
#include "tests/render/synthetic_cast.h"

namespace kaori::stage {
namespace {

using show::CallKind, show::CallMode;

show::Show ShowWithButtons() {
  show::Show show;
  show.name = "Small";
  show.cast = kaori::tests::MakeSyntheticCast({.faces = 2});
  show.scenes.emplace_back().name = "studio";
  show.buttons[3] = {CallKind::kFace, 1};
  show.second_buttons[3] = {CallKind::kExpression, 1, CallMode::kMomentary};
  return show;
}

TEST(ButtonCalls, AreThoseOfBothSheetsAndNothingElsewhere) {
  const show::Show show = ShowWithButtons();
  const auto items = roles::ItemsOf(show);
  const board::ButtonCalls calls = ButtonCallsOf(show);
  EXPECT_EQ(calls.sums[0][3], roles::SumOfCall({CallKind::kFace, 1}, "Small", items));
  EXPECT_EQ(calls.sums[1][3], roles::SumOfCall({CallKind::kExpression, 1}, "Small", items));
  EXPECT_NE(calls.sums[0][3], calls.sums[1][3]);
  EXPECT_EQ(calls.sums[0][4], 0U);
}

TEST(ButtonCalls, FollowWhatTheBoxWasTaught) {
  show::Show show = ShowWithButtons();
  const auto of_show = ButtonCallsOf(show);
  roles::Assign({{3, {CallKind::kCue, 0}}}, show);
  const auto taught = ButtonCallsOf(show);
  EXPECT_NE(taught.sums[0][3], of_show.sums[0][3]);
  EXPECT_EQ(taught.sums[0][3], taught.sums[1][3]);
  EXPECT_NE(taught.sums[0][3], 0U);
}

TEST(ButtonCalls, OfAnotherShowAreOthers) {
  show::Show show = ShowWithButtons();
  const auto of_one = ButtonCallsOf(show);
  show.name = "Other";
  EXPECT_NE(ButtonCallsOf(show).sums[0][3], of_one.sums[0][3]);
}

}  // namespace
}  // namespace kaori::stage
