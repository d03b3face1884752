// The screens of a graphics card: several as one wall, pulled and plugged, without an EDID, and after a
// program that died.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "drivers/scanout/kms_screen.h"
#include "tests/drivers/scanout_fixture.h"

namespace kaori::scanout {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in milliseconds.
using ::testing::HasSubstr;
using tests::FakeCard;
using tests::ModeOf;
using tests::Screens;

TEST_F(Screens, OneScreenShowsThePictureInItsOwnMode) {
  card_.PlugIn(1, {ModeOf(1920, 1080), ModeOf(640, 480, DRM_MODE_TYPE_DRIVER)});
  const auto screen = Open();
  EXPECT_EQ(size_px_, std::pair(1920, 1080));
  const auto flip = Frame(*screen);
  ASSERT_TRUE(flip) << flip.error().message();
  EXPECT_EQ(flip->frame, 1U);
  EXPECT_EQ(flip->at, clock_.now());
  EXPECT_EQ(card_.Value(card_.connectors[1].id, "CRTC_ID"), FakeCard::kFirstCrtc);
}

TEST_F(Screens, AfterTheFirstPictureOnlyThePictureChanges) {
  card_.PlugIn(0);
  const auto screen = Open();
  ASSERT_TRUE(Frames(*screen, 1s));
  EXPECT_EQ(card_.modesets, 1);
  EXPECT_GT(card_.commits, 50);
}

TEST_F(Screens, TwoScreensShowThePictureTogether) {
  card_.PlugIn(0, {ModeOf(1280, 720)});
  card_.PlugIn(2, {ModeOf(1024, 768)});
  const auto screen = Open();
  EXPECT_EQ(size_px_, std::pair(1280 + 1024, 768));
  ASSERT_TRUE(Frame(*screen));
  EXPECT_EQ(card_.Shows(0), card_.Shows(1)) << "one picture";
  EXPECT_EQ(Source(0, "SRC_X"), 0U);
  EXPECT_EQ(Source(1, "SRC_X"), 1280U);
  EXPECT_EQ(Source(1, "SRC_W"), 1024U);
}

TEST_F(Screens, AFrameIsPresentedWhenAllOfThemShowIt) {
  card_.PlugIn(0);
  card_.PlugIn(1);
  const auto screen = Open();
  ASSERT_TRUE(screen->Acquire());
  ASSERT_TRUE(screen->Present(1));
  EXPECT_EQ(screen->Acquire().error().cause, std::errc::resource_unavailable_try_again);
  EXPECT_EQ(screen->ReadFlip().error().cause, std::errc::resource_unavailable_try_again);
  card_.Blank(clock_.now());
  EXPECT_TRUE(screen->ReadFlip());
  EXPECT_FALSE(screen->ReadFlip()) << "once";
}

TEST_F(Screens, TheOthersPlayOnWhenOneIsPulledAndItShowsAgainWithinASecond) {
  card_.PlugIn(0);
  card_.PlugIn(1);
  const auto screen = Open();
  ASSERT_TRUE(Frames(*screen, 1s));
  card_.Pull(0);
  const auto without = Frames(*screen, 3s);
  ASSERT_TRUE(without) << without.error().message();
  const auto stale = card_.Shows(0);
  ASSERT_TRUE(Frame(*screen));
  EXPECT_EQ(card_.Shows(0), stale) << "nothing is sent to a screen that is not there";
  EXPECT_EQ(card_.modesets, 1);
  card_.PlugIn(0);
  ASSERT_TRUE(Frames(*screen, 500ms));
  EXPECT_EQ(card_.Shows(0), card_.Shows(1));
  EXPECT_EQ(card_.modesets, 2) << "the one that came back is set up, once";
}

TEST_F(Screens, AScreenThatIsPulledBeforeItsFlipHoldsNobodyUp) {
  card_.PlugIn(0);
  card_.PlugIn(1);
  const auto screen = Open();
  ASSERT_TRUE(Frames(*screen, 1s));
  ASSERT_TRUE(screen->Acquire());
  ASSERT_TRUE(screen->Present(++frame_));
  card_.Pull(1);
  clock_.Advance(300ms);
  EXPECT_FALSE(screen->Acquire()) << "the other one's flip is pending";
  card_.Blank(clock_.now());
  ASSERT_TRUE(screen->ReadFlip());
  EXPECT_TRUE(Frames(*screen, 1s));
}

TEST_F(Screens, TheLastOneThatIsPulledIsGoneAndComesBackWhenItIsOpenedAnew) {
  card_.PlugIn(0);
  auto screen = Open();
  ASSERT_TRUE(Frames(*screen, 1s));
  card_.Pull(0);
  const auto gone = Frames(*screen, 1s);
  ASSERT_FALSE(gone);
  EXPECT_EQ(gone.error().cause, std::errc::no_such_device);
  screen.reset();
  EXPECT_EQ(TryOpen().error().cause, std::errc::no_such_device);
  card_.PlugIn(0);
  screen = Open();
  EXPECT_TRUE(Frame(*screen));
}

TEST_F(Screens, AnotherScreenMakesThemAllBeArrangedAnew) {
  card_.PlugIn(0);
  auto screen = Open();
  ASSERT_TRUE(Frames(*screen, 1s));
  card_.PlugIn(1);
  EXPECT_EQ(Frames(*screen, 1s).error().cause, std::errc::no_such_device);
  screen = Open();
  EXPECT_EQ(size_px_, std::pair(1280, 480));
  EXPECT_TRUE(Frames(*screen, 1s));
}

TEST_F(Screens, OneThatComesBackWithAnotherModeMakesThemAllBeArrangedAnew) {
  card_.PlugIn(0);
  card_.PlugIn(1);
  const auto screen = Open();
  ASSERT_TRUE(Frames(*screen, 1s));
  card_.Pull(1);
  ASSERT_TRUE(Frames(*screen, 1s));
  card_.PlugIn(1, {ModeOf(800, 600)});
  EXPECT_EQ(Frames(*screen, 1s).error().cause, std::errc::no_such_device);
}

TEST_F(Screens, ACardThatNoticesNothingByItselfIsProbedWhenTheKernelReportsAHotplug) {
  card_.blind = true;
  card_.PlugIn(0);
  card_.PlugIn(1);
  EXPECT_FALSE(TryOpen()) << "nobody has probed it yet";
  card_.hotplug = true;
  const auto screen = Open();
  ASSERT_TRUE(Frames(*screen, 1s));
  card_.Pull(0);
  card_.hotplug = true;
  ASSERT_TRUE(Frames(*screen, 1s));
  const auto stale = card_.Shows(0);
  ASSERT_TRUE(Frame(*screen));
  EXPECT_EQ(card_.Shows(0), stale);
  card_.PlugIn(0);
  card_.hotplug = true;
  ASSERT_TRUE(Frames(*screen, 500ms));
  EXPECT_EQ(card_.Shows(0), card_.Shows(1));
  card_.PlugIn(2);
  card_.hotplug = true;
  EXPECT_EQ(Frames(*screen, 1s).error().cause, std::errc::no_such_device) << "a new screen";
}

TEST_F(Screens, AScreenThatGivesWayToAnotherWithoutAPauseIsNoticed) {
  card_.PlugIn(0, {ModeOf(1920, 1080)});
  const auto screen = Open();
  ASSERT_TRUE(Frames(*screen, 1s));
  card_.PlugIn(0, {ModeOf(1280, 720)});
  card_.hotplug = true;
  EXPECT_EQ(Frames(*screen, 1s).error().cause, std::errc::no_such_device);
}

TEST_F(Screens, OneWhoseLinkFailedIsSetUpAnew) {
  card_.PlugIn(0);
  card_.PlugIn(1);
  const auto screen = Open();
  ASSERT_TRUE(Frames(*screen, 1s));
  EXPECT_EQ(card_.modesets, 1);
  ASSERT_TRUE(screen->Acquire());
  ASSERT_TRUE(screen->Present(++frame_));
  card_.connectors[1].link_is_bad = true;
  card_.hotplug = true;
  clock_.Advance(300ms);
  EXPECT_FALSE(screen->Acquire()) << "the flip is pending";
  card_.Blank(clock_.now());
  ASSERT_TRUE(screen->ReadFlip());
  ASSERT_TRUE(Frames(*screen, 500ms));
  EXPECT_FALSE(card_.connectors[1].link_is_bad);
  EXPECT_FALSE(card_.state_.contains({card_.connectors[0].id, "link-status"})) << "the other one plays on";
  ASSERT_TRUE(Frames(*screen, 20s));
  EXPECT_EQ(card_.modesets, 2) << "once";
}

TEST_F(Screens, OneWhoseLinkFailsAgainIsSetUpNowAndThen) {
  card_.PlugIn(0);
  card_.connectors[0].link_is_bad = true;
  card_.trains_no_link = true;
  const auto screen = Open();
  ASSERT_TRUE(Frames(*screen, 35s));
  EXPECT_EQ(card_.modesets, 4) << "all screens wait for it each time";
  card_.trains_no_link = false;
  ASSERT_TRUE(Frames(*screen, 11s));
  EXPECT_FALSE(card_.connectors[0].link_is_bad);
}

TEST_F(Screens, WithoutAHotplugReportNoScreenIsProbed) {
  card_.PlugIn(0);
  const auto screen = Open();
  const int before = card_.probes;
  ASSERT_TRUE(Frames(*screen, 10s));
  EXPECT_EQ(card_.probes, before) << "reading an EDID would cost a frame";
}

TEST_F(Screens, AConnectorThatOnlyOneCrtcCanDriveGetsIt) {
  card_.connectors[1].crtcs = 1;  // The first CRTC alone, which the first connector would get.
  card_.PlugIn(0);
  card_.PlugIn(1);
  ASSERT_TRUE(Frame(*Open()));
  EXPECT_EQ(card_.Value(card_.connectors[1].id, "CRTC_ID"), FakeCard::kFirstCrtc);
  EXPECT_EQ(card_.Value(card_.connectors[0].id, "CRTC_ID"), FakeCard::kFirstCrtc + 1);
}

TEST_F(Screens, NoConnectorThatIsKnownToBeEmptyIsProbed) {
  EXPECT_FALSE(TryOpen());
  EXPECT_EQ(card_.probes, 0);
}

TEST_F(Screens, AFlipOfAProgramThatDiedIsPassedOver) {
  card_.PlugIn(0);
  const auto screen = Open();
  card_.StrayFlip(FakeCard::kFirstCrtc, 0xdeadbeef);
  EXPECT_FALSE(screen->ReadFlip());
  EXPECT_TRUE(Frame(*screen));
}

TEST_F(Screens, ThePicturesOfAProgramThatDiedGoOnlyWhenOursIsShown) {
  card_.framebuffers = {7, 8};
  card_.PlugIn(0);
  const auto screen = Open();
  ASSERT_TRUE(screen->Acquire());
  ASSERT_TRUE(screen->Present(1));
  EXPECT_TRUE(card_.framebuffers.contains(7)) << "removing it now would blank the screen";
  card_.Blank(clock_.now());
  ASSERT_TRUE(screen->ReadFlip());
  EXPECT_FALSE(card_.framebuffers.contains(7));
  EXPECT_FALSE(card_.framebuffers.contains(8));
}

TEST_F(Screens, ACrtcThatADeadProgramLeftOnAnotherConnectorIsFreedForThisOne) {
  card_.state_[{FakeCard::kFirstConnector, "CRTC_ID"}] = FakeCard::kFirstCrtc;
  card_.state_[{FakeCard::kFirstConnector + 1, "CRTC_ID"}] = FakeCard::kFirstCrtc + 1;
  for (std::uint32_t crtc : {FakeCard::kFirstCrtc, FakeCard::kFirstCrtc + 1})
    card_.state_[{crtc, "ACTIVE"}] = 1;
  card_.PlugIn(2);
  ASSERT_TRUE(Frame(*Open()));
  EXPECT_EQ(card_.Value(FakeCard::kFirstConnector, "CRTC_ID"), 0U);
  EXPECT_EQ(card_.Value(FakeCard::kFirstConnector + 2, "CRTC_ID"), FakeCard::kFirstCrtc);
  EXPECT_EQ(card_.Value(FakeCard::kFirstCrtc + 1, "ACTIVE"), 0U);
}

TEST_F(Screens, ACardThatNeverFlipsIsGivenUpAfterTwoSeconds) {
  card_.PlugIn(0);
  const auto screen = Open();
  ASSERT_TRUE(screen->Acquire());
  ASSERT_TRUE(screen->Present(1));
  clock_.Advance(1900ms);
  EXPECT_EQ(screen->Acquire().error().cause, std::errc::resource_unavailable_try_again);
  clock_.Advance(200ms);
  EXPECT_EQ(screen->Acquire().error().cause, std::errc::no_such_device);
}

TEST_F(Screens, WhatTheCardRefusesIsSaid) {
  card_.PlugIn(0);
  const auto screen = Open();
  ASSERT_TRUE(screen->Acquire());
  card_.commit_fault = std::errc::permission_denied;
  EXPECT_EQ(screen->Present(1).error().cause, std::errc::permission_denied);
  EXPECT_EQ(screen->Present(2).error().cause, std::errc::invalid_argument) << "nothing was acquired";
}

TEST_F(Screens, AModesBlobIsDestroyedWithItsScreen) {
  card_.PlugIn(0);
  card_.PlugIn(1);
  auto screen = Open();
  ASSERT_TRUE(Frames(*screen, 1s));
  EXPECT_EQ(card_.mode_blobs.size(), 2U);
  screen.reset();
  EXPECT_TRUE(card_.mode_blobs.empty());
}

TEST_F(Screens, AScreenThatPrefersNoModeIsReportedAsSuch) {
  card_.PlugIn(0, {ModeOf(1024, 768, DRM_MODE_TYPE_DRIVER)});
  EXPECT_THAT(Describe(Open()->wall()), HasSubstr("HDMI-A-1 1024 x 768 at 60 Hz, which is safe"));
}

}  // namespace
}  // namespace kaori::scanout
