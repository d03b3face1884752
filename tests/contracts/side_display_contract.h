// The contract of ports::SideDisplay.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/ports/side_display.h"
#include "tests/contracts/contract.h"

namespace kaori::contracts {

// A display, and the eyes before it.
class SideDisplaySubject : public AnySubject {
 public:
  virtual ports::SideDisplay& display() = 0;
  // The display has had the time that a Show may pend.
  virtual void Blank() {}
  // R, G and B of what is seen there; row 0 is the bottom row. To be asked after Blank.
  virtual std::array<std::uint8_t, 3> Seen(int x_px, int y_px) = 0;

  ManualClock clock;
};

class SideDisplayContract : public Contract<SideDisplaySubject> {
 protected:
  ports::SideDisplay& display() { return subject_->display(); }
  int width() { return display().width_px(); }
  int height() { return display().height_px(); }
  ports::DisplayArea Whole() { return {0, 0, width(), height()}; }

  // A picture whose pixels tell their place, and which picture it is.
  std::vector<std::uint8_t> Picture(std::uint8_t which) {
    std::vector<std::uint8_t> rgbx;
    for (int y = 0; y < height(); ++y)
      for (int x = 0; x < width(); ++x)
        rgbx.insert(rgbx.end(), {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), which, 0});
    return rgbx;
  }
  std::array<std::uint8_t, 3> Pixel(int x, int y, std::uint8_t which) {
    return {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), which};
  }
  Result<void> Show(const std::vector<std::uint8_t>& rgbx, const std::vector<ports::DisplayArea>& areas) {
    auto shown = display().Show(rgbx, areas);
    for (int n = 0; n < 3 && Cause(shown) == std::errc::device_or_resource_busy; ++n) {
      subject_->Blank();
      shown = display().Show(rgbx, {});
    }
    subject_->Blank();
    return shown;
  }
};

TEST_P(SideDisplayContract, IsFreshUntilTheFirstPictureIsShown) {
  EXPECT_TRUE(display().fresh());
  ASSERT_TRUE(Show(Picture(1), {Whole()}));
  EXPECT_FALSE(display().fresh());
}

TEST_P(SideDisplayContract, ShowsThePictureTheRightWayUp) {
  ASSERT_TRUE(Show(Picture(7), {Whole()}));
  for (const auto& [x, y] :
       {std::pair{0, 0}, {width() - 1, 0}, {0, height() - 1}, {width() / 2, height() / 3}})
    EXPECT_EQ(subject_->Seen(x, y), Pixel(x, y, 7)) << x << ", " << y;
}

TEST_P(SideDisplayContract, ShowsTheAreasTogetherAndLeavesTheRest) {
  ASSERT_TRUE(Show(Picture(1), {Whole()}));
  const int low = height() / 4, high = height() / 2;
  // Beside an area the picture is as it was, so that whoever copies more than the area does no harm.
  auto picture = Picture(1);
  for (int x = 0; x < width(); ++x)
    for (const int y : {low, high})
      picture[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width()) +
                   static_cast<std::size_t>(x)) +
              2] = 2;
  ASSERT_TRUE(Show(picture, {{0, low, width(), low + 1}, {0, high, width(), high + 1}}));
  EXPECT_EQ(subject_->Seen(3, low), Pixel(3, low, 2));
  EXPECT_EQ(subject_->Seen(3, high), Pixel(3, high, 2));
  EXPECT_EQ(subject_->Seen(3, low + 1), Pixel(3, low + 1, 1));
}

TEST_P(SideDisplayContract, RefusesAPictureOfAnotherSizeAndAreasBeyondIt) {
  ASSERT_TRUE(Show(Picture(1), {Whole()}));
  auto small = Picture(2);
  small.resize(small.size() - 4);
  EXPECT_EQ(Cause(display().Show(small, {})), std::errc::invalid_argument);
  for (const ports::DisplayArea& wrong :
       {ports::DisplayArea{-1, 0, 1, 1}, ports::DisplayArea{0, -1, 1, 1},
        ports::DisplayArea{0, 0, width() + 1, 1}, ports::DisplayArea{0, 0, 1, height() + 1},
        ports::DisplayArea{2, 0, 1, 1}, ports::DisplayArea{0, 2, 1, 1}})
    EXPECT_EQ(Cause(display().Show(Picture(2), std::array{wrong})), std::errc::invalid_argument)
        << wrong.left_px << ", " << wrong.bottom_px << " to " << wrong.right_px << ", " << wrong.top_px;
  EXPECT_EQ(subject_->Seen(0, 0), Pixel(0, 0, 1)) << "nothing of it was shown";
}

TEST_P(SideDisplayContract, ShowsAgainWithoutAnyArea) {
  ASSERT_TRUE(Show(Picture(1), {Whole()}));
  ASSERT_TRUE(Show(Picture(1), {}));
  EXPECT_EQ(subject_->Seen(1, 2), Pixel(1, 2, 1));
}

}  // namespace kaori::contracts
