// Surfaces that people own, by their simulated twins and by the files that ship: what is turned, pushed and moved there stands on
// the board, and their lamps and keys show what it says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hw-sim/devices/dial_box.h"
#include "hw-sim/devices/owned_device.h"
#include "hw-sim/devices/stream_deck.h"
#include "tests/appliance/programs/input_owned_fixture.h"

namespace kaori::input {
namespace {

using board::SourceState;
using sim::OwnedKind;
using std::chrono::milliseconds;
using ::testing::FloatNear;

TEST_F(OwnedDevices, APowerMateIsOneDialOfTheBoardWhoseTurnIsATurn) {
  sim::OwnedDevice knob(OwnedKind::kPowerMate);
  PlugIn("knob", knob);
  RecordProperty("twin", knob.device_name().name);
  Start();
  for (int n = 0; n < 47; ++n) knob.Turn(1);
  knob.Push(0);
  Play(milliseconds(80));
  EXPECT_EQ(Board().surface.value.counts[2], 128) << "half of 94 clicks is half of 256 counts";
  EXPECT_EQ(Board().surface.value.buttons_down, 1U << 10U);
  knob.Turn(-94);
  knob.Release(0);
  Play(milliseconds(5));
  EXPECT_EQ(Board().surface.value.counts[2], -128);
  EXPECT_EQ(Board().surface.value.pushes[10], 1U);
}

TEST_F(OwnedDevices, AShuttlesJogWheelTurnsOverItsEndAndItsRingTurnsNothing) {
  sim::OwnedDevice shuttle(OwnedKind::kShuttlePro);
  PlugIn("shuttle", shuttle);
  RecordProperty("twin", shuttle.device_name().name);
  Start();
  shuttle.Ring(5);
  Play(milliseconds(5));
  for (int n = 0; n < 30; ++n) shuttle.Turn(-10);
  Play(milliseconds(400));
  EXPECT_EQ(Board().surface.value.counts[2], -30 * 256);
  shuttle.Push(12);
  Play(milliseconds(5));
  EXPECT_EQ(Board().surface.value.buttons_down, 1U << 12U);
}

TEST_F(OwnedDevices, ADialBoxAndFurtherSurfacesPlayTogether) {
  sim::DeviceContext context{clock_, {}};
  sim::DialBox box(context);
  sim::OwnedDevice knob(OwnedKind::kPowerMate);
  sim::StreamDeck deck(sim::StreamDeck::Kind::kMk2);
  PlugIn("dial-box", box);
  PlugIn("knob", knob);
  PlugIn("deck", deck);
  Start();
  EXPECT_EQ(service_->attached_devices(), 3);
  box.Turn(2, 0.5);
  knob.Turn(94);
  box.Push(4);
  deck.Push(4);
  Play(milliseconds(10));
  EXPECT_EQ(Board().surface.value.counts[2], 128 + 256);
  box.Release(4);
  Play(milliseconds(10));
  EXPECT_EQ(Board().surface.value.buttons_down, 1U << 4U) << "the deck still holds it";
  EXPECT_EQ(Board().surface.value.pushes[4], 2U);
  cables_[2]->Unplug();
  Play(milliseconds(10));
  EXPECT_EQ(Board().surface.value.buttons_down, 0U);
  EXPECT_EQ(Board().surface.source, SourceState::kLive) << "the others are there";
}

TEST_F(OwnedDevices, AButtonThatADialBoxHeldBeforeARestartIsLetGoWhereItDoesNotComeBack) {
  sim::DeviceContext context{clock_, {}};
  sim::DialBox box(context);
  sim::OwnedDevice knob(OwnedKind::kPowerMate);
  PlugIn("dial-box", box);
  PlugIn("knob", knob);
  Start();
  box.Push(4);
  Play(milliseconds(10));
  ASSERT_EQ(Board().surface.value.buttons_down, 1U << 4U);
  service_.reset();
  cables_[0]->Unplug();
  Start();
  Play(milliseconds(600));
  EXPECT_EQ(Board().surface.value.buttons_down, 0U);
  EXPECT_EQ(Board().surface.source, SourceState::kLive) << "the knob is there";
}

class OwnedSticks : public OwnedDevices, public ::testing::WithParamInterface<OwnedKind> {};
INSTANTIATE_TEST_SUITE_P(All, OwnedSticks,
                         ::testing::Values(OwnedKind::kExtreme3dPro, OwnedKind::kAttack3,
                                           OwnedKind::kT16000m));

TEST_P(OwnedSticks, WhatMovesStandsOnTheBoard) {
  sim::OwnedDevice stick(GetParam());
  PlugIn("stick", stick);
  RecordProperty("twin", stick.device_name().name);
  Start();
  stick.Move(-0.5F, 1);
  stick.Push(10);
  Play(milliseconds(10));
  const bool is_attack = GetParam() == OwnedKind::kAttack3;
  EXPECT_EQ(Board().sticks[0].source, SourceState::kLive);
  EXPECT_THAT(Board().sticks[0].value.x, FloatNear(-0.48F, 0.05F));
  EXPECT_THAT(Board().sticks[0].value.y, FloatNear(1, 0.01F));
  EXPECT_EQ(Board().sticks[0].value.buttons_down, 1U << 10U);
  stick.Twist(-1);
  stick.Slide(0.75F);
  stick.Hat(3);
  Play(milliseconds(10));
  EXPECT_THAT(Board().sticks[0].value.slider, FloatNear(0.75F, 0.01F));
  if (is_attack) return;  // It has neither twist nor hat.
  EXPECT_THAT(Board().sticks[0].value.twist, FloatNear(-1, 0.01F));
  EXPECT_EQ(Board().sticks[0].value.hat, 3);
  stick.Hat(-1);
  Play(milliseconds(10));
  EXPECT_EQ(Board().sticks[0].value.hat, -1);
}

}  // namespace
}  // namespace kaori::input
