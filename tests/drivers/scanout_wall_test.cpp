// How screens are arranged that show one picture together.
#include "drivers/scanout/kms_wall.h"

#include <gtest/gtest.h>

#include "drivers/scanout/kms_screen.h"
#include "tests/drivers/scanout_fake_card.h"

namespace kaori::scanout {
namespace {

using tests::FakeCard;
using tests::FakeSurface;
using tests::ModeOf;

TEST(Wall, ScreensFormAFullRectangleWhereTheirNumberMakesOne) {
  const std::vector<std::pair<int, int>> expected_px{{100, 50},  {200, 50}, {300, 50},  {200, 100}, {500, 50},
                                                     {300, 100}, {700, 50}, {400, 100}, {300, 150}};
  for (std::size_t count = 1; count <= expected_px.size(); ++count) {
    std::vector<KmsOutput> outputs(count);
    for (auto& output : outputs) output.chosen.mode = ModeOf(100, 50);
    const KmsWall wall = Arrange(outputs);
    EXPECT_EQ(std::pair(wall.width_px, wall.height_px), expected_px[count - 1]) << count << " screens";
    EXPECT_EQ(wall.panels.back().x_px, wall.width_px - 100);
    EXPECT_EQ(wall.panels.back().y_px, wall.height_px - 50);
  }
}

TEST(Wall, NoScreenIsNoWall) {
  const KmsWall wall = Arrange({});
  EXPECT_TRUE(wall.panels.empty());
  EXPECT_EQ(wall.width_px, 0);
}

TEST(Wall, MoreScreensThanTheCardCanDriveDisturbNobody) {
  FakeCard card(3, 2);
  ManualClock clock;
  for (std::size_t i = 0; i < 3; ++i) card.PlugIn(i);
  const auto make = [&card](int, int) -> Result<std::unique_ptr<KmsSurface>> {
    return std::make_unique<FakeSurface>(card, 1);
  };
  KmsPreferences preferences;
  const auto screen = KmsScreen::Open(card, make, clock, preferences).value();
  EXPECT_EQ(screen->wall().panels.size(), 2U);
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(screen->Acquire()) << "the third one is not new";
    ASSERT_TRUE(screen->Present(std::uint64_t(i)));
    clock.Advance(std::chrono::milliseconds(16));
    card.Blank(clock.now());
    ASSERT_TRUE(screen->ReadFlip());
  }
}

}  // namespace
}  // namespace kaori::scanout
