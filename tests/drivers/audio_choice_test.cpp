// Which sound device, where nobody named any.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>
#include <map>

#include "drivers/audio/sound_choice.h"
#include "tests/drivers/audio_fake_pcm.h"

namespace kaori::audio {
namespace {

using std::chrono::seconds;
using ::testing::ElementsAre;

const SoundDevice kOwn{.name = "hw:0,0"};
const SoundDevice kScreen{.name = "hw:0,3", .on_screen_cable = true};
const SoundDevice kUsb{.name = "hw:1,0", .usb = true};
const SoundDevice kOtherUsb{.name = "hw:2,0", .usb = true};

TEST(NearestSound, IsTheFirstOnUsbElseTheBoxsOwnElseAScreens) {
  EXPECT_EQ(Nearest(std::vector{kScreen, kOwn, kUsb, kOtherUsb}), "hw:1,0");
  EXPECT_EQ(Nearest(std::vector{kScreen, kOwn}), "hw:0,0");
  EXPECT_EQ(Nearest(std::vector{kScreen}), "hw:0,3");
  EXPECT_EQ(Nearest({}), "");
}

// A machine with cards that come and go.
class ChosenSound : public ::testing::Test {
 protected:
  Result<std::unique_ptr<AlsaPcm>> Open(const std::string& name) {
    return opener_(name, Direction::kCapture, {});
  }
  long Read(AlsaPcm& pcm) {
    sound_.heard = {1};
    std::array<std::int16_t, 1> into{};
    return pcm.Read(into);
  }

  ManualClock clock_;
  tests::FakeSound sound_;
  std::vector<SoundDevice> cards_{kOwn};
  std::vector<std::string> opened_, made_audible_;
  std::map<std::string, std::errc> refusals_;
  const PcmOpener opener_ = ChoosingPcmOpener(
      clock_, {.list = [this](Direction) { return cards_; },
               .make_audible = [this](const std::string& card, Direction) { made_audible_.push_back(card); },
               .open = [this](const std::string& card, Direction,
                              const AlsaPreferences&) -> Result<std::unique_ptr<AlsaPcm>> {
                 opened_.push_back(card);
                 if (refusals_.contains(card)) return Fail(refusals_[card], "open " + card);
                 return std::make_unique<tests::FakePcm>(sound_);
               }});
};

TEST_F(ChosenSound, IsTheNearestAndIsMadeAudible) {
  ASSERT_TRUE(Open(kAnySound));
  EXPECT_THAT(opened_, ElementsAre("hw:0,0"));
  EXPECT_THAT(made_audible_, ElementsAre("hw:0,0"));
}

TEST_F(ChosenSound, IsLeftAsItIsWhereSomebodyNamedIt) {
  ASSERT_TRUE(Open("hw:7"));
  EXPECT_THAT(opened_, ElementsAre("hw:7"));
  EXPECT_TRUE(made_audible_.empty());
}

TEST_F(ChosenSound, IsNoneWhereThereIsNoCard) {
  cards_.clear();
  EXPECT_EQ(Open(kAnySound).error().cause, std::errc::no_such_device);
  EXPECT_TRUE(opened_.empty());
}

TEST_F(ChosenSound, GivesWayWithinTwoSecondsToANearerOne) {
  const auto pcm = std::move(Open(kAnySound).value());
  clock_.Advance(seconds(10));
  EXPECT_EQ(Read(*pcm), 1) << "nothing came";
  cards_ = {kOwn, kUsb};
  EXPECT_EQ(Read(*pcm), 1) << "not asked at every read";
  clock_.Advance(seconds(2));
  EXPECT_EQ(Read(*pcm), -ENODEV);
  ASSERT_TRUE(Open(kAnySound));
  EXPECT_EQ(opened_.back(), "hw:1,0");
}

TEST_F(ChosenSound, StaysWhenOneThatIsFartherComes) {
  cards_ = {kUsb};
  const auto pcm = std::move(Open(kAnySound).value());
  cards_ = {kOwn, kUsb, kOtherUsb};
  clock_.Advance(seconds(10));
  EXPECT_EQ(Read(*pcm), 1);
}

TEST_F(ChosenSound, IsTheNearestThatOpensUntilDevicesComeOrGo) {
  cards_ = {kUsb, kOtherUsb};
  refusals_[kUsb.name] = std::errc::not_supported;
  const auto opened = Open(kAnySound);
  ASSERT_TRUE(opened);
  EXPECT_THAT(opened_, ElementsAre("hw:1,0", "hw:2,0"));
  clock_.Advance(seconds(10));
  EXPECT_EQ(Read(**opened), 1) << "it stays";
  ASSERT_TRUE(Open(kAnySound));
  EXPECT_THAT(opened_, ElementsAre("hw:1,0", "hw:2,0", "hw:2,0")) << "one that refused is not asked again";
  cards_ = {kUsb, kOtherUsb, kOwn};
  refusals_.clear();
  clock_.Advance(seconds(10));
  EXPECT_EQ(Read(**opened), -ENODEV);
  ASSERT_TRUE(Open(kAnySound));
  EXPECT_EQ(opened_.back(), "hw:1,0");
}

TEST_F(ChosenSound, IsNotGivenUpForAMomentInWhichItIsBusy) {
  cards_ = {kUsb, kOwn};
  refusals_[kUsb.name] = std::errc::device_or_resource_busy;
  EXPECT_EQ(Open(kAnySound).error().cause, std::errc::device_or_resource_busy);
  clock_.Advance(seconds(1));
  EXPECT_FALSE(Open(kAnySound));
  EXPECT_THAT(opened_, ElementsAre("hw:1,0", "hw:1,0"));
  clock_.Advance(seconds(1));
  ASSERT_TRUE(Open(kAnySound));
  EXPECT_EQ(opened_.back(), "hw:0,0");
}

TEST_F(ChosenSound, IsAskedForAgainWhereAllRefused) {
  cards_ = {kUsb, kOwn};
  refusals_ = {{kUsb.name, std::errc::io_error}, {kOwn.name, std::errc::not_supported}};
  EXPECT_EQ(Open(kAnySound).error().cause, std::errc::io_error) << "that of the nearest";
  refusals_.clear();
  ASSERT_TRUE(Open(kAnySound));
  EXPECT_EQ(opened_.back(), "hw:1,0");
}

}  // namespace
}  // namespace kaori::audio
