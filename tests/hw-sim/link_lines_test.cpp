// The simulated panel of switches and its lamp, and the driver at the other end of the link.
#include "firmware/wire/link_lines.h"
#include "drivers/base/packet_socket.h"
#include "drivers/gpio/local_lines.h"
#include "tests/hw-sim/link_fixture.h"

namespace kaori::sim {
namespace {

using namespace std::chrono_literals;

constexpr int kGo = 0, kBlackout = 1;

class LinesLink : public LinkFixture {
 protected:
  void Connect() {
    auto connected = gpio::LocalLines::Connect(folder.path());
    ASSERT_TRUE(connected) << connected.error().message();
    lines = std::move(*connected);
    rig->Pump();
    const auto greeted = lines->Greet(0ms);
    ASSERT_TRUE(greeted) << greeted.error().message();
  }
  std::errc CauseOfNextEdge() { return lines->ReadEdge().error().cause; }

  std::unique_ptr<gpio::LocalLines> lines;
};

TEST_F(LinesLink, ASwitchIsAnEdgeWithItsTime) {
  Connect();
  EXPECT_EQ(lines->Levels(), 0U);
  EXPECT_EQ(CauseOfNextEdge(), std::errc::resource_unavailable_try_again);
  Step(5ms);
  const Time closed = clock.now();
  rig->lines().Close(kGo);
  clock.Advance(3ms);
  rig->lines().Open(kGo);
  rig->Pump();
  const auto down = lines->ReadEdge();
  ASSERT_TRUE(down);
  EXPECT_EQ(down->line, 0U);
  EXPECT_TRUE(down->active);
  EXPECT_EQ(down->at, closed);
  EXPECT_EQ(lines->Levels(), 1U) << "the levels are those after the edge that was read";
  const auto up = lines->ReadEdge();
  ASSERT_TRUE(up);
  EXPECT_FALSE(up->active);
  EXPECT_EQ(up->at, closed + 3ms);
  EXPECT_EQ(lines->Levels(), 0U);
}

TEST_F(LinesLink, WhatIsOnWhenTheDriverComesIsALevelAndNoEdge) {
  rig->lines().Close(kBlackout);
  Connect();
  EXPECT_EQ(lines->Levels(), 2U);
  EXPECT_EQ(CauseOfNextEdge(), std::errc::resource_unavailable_try_again);
}

TEST_F(LinesLink, TheTallyLampIsDrivenAndGoesDarkWithItsDriver) {
  Connect();
  ASSERT_TRUE(lines->Drive(0, true));
  rig->Pump();
  EXPECT_TRUE(rig->lines().tally());
  EXPECT_EQ(lines->Drive(1, true).error().cause, std::errc::invalid_argument);
  lines.reset();
  rig->Pump();
  EXPECT_FALSE(rig->lines().tally());
}

// Nobody pumps the rig, so that the socket to the panel fills.
TEST_F(LinesLink, APanelThatReadsTooSlowlyIsNotGone) {
  Connect();
  auto driven = lines->Drive(0, true);
  for (int n = 0; driven && n < 100'000; ++n) driven = lines->Drive(0, true);
  ASSERT_FALSE(driven);
  EXPECT_EQ(driven.error().cause, std::errc::resource_unavailable_try_again);
  EXPECT_EQ(lines->Levels(), 0U) << "the switches are still told";
  for (int n = 0; n < 4; ++n) rig->Pump();
  EXPECT_TRUE(lines->Drive(0, false));
}

TEST_F(LinesLink, EdgesThatADriverReadsTooSlowlyComeLaterInTheirOrder) {
  Connect();
  constexpr int kMoves = 600;  // More than the socket holds.
  for (int n = 0; n < kMoves; ++n) {
    clock.Advance(1ms);
    n % 2 == 0 ? rig->lines().Close(kGo) : rig->lines().Open(kGo);
  }
  rig->Pump();
  EXPECT_NE(rig->next_due(), Time::max()) << "the rest is due by time";
  Time before{};
  for (int n = 0; n < kMoves; ++n) {
    auto edge = lines->ReadEdge();
    if (!edge) {
      rig->Pump();
      edge = lines->ReadEdge();
    }
    ASSERT_TRUE(edge) << n << ": " << edge.error().message();
    ASSERT_EQ(edge->active, n % 2 == 0) << n;
    ASSERT_GT(edge->at, before) << n;
    before = edge->at;
  }
  EXPECT_EQ(CauseOfNextEdge(), std::errc::resource_unavailable_try_again);
}

// Far more than anything holds: pushes of one line are lost, and no level of any.
TEST_F(LinesLink, ADriverThatWasStoppedForLongFindsTheLevelsAsTheyAre) {
  Connect();
  rig->lines().Close(kBlackout);
  for (int n = 0; n < 4001; ++n) n % 2 == 0 ? rig->lines().Close(kGo) : rig->lines().Open(kGo);
  int read = 0;
  do {
    rig->Pump();
    while (lines->ReadEdge()) ++read;
  } while (rig->next_due() != Time::max());
  EXPECT_EQ(lines->Levels(), 3U);
  EXPECT_LE(read, 1024);
}

TEST_F(LinesLink, APulledCableIsNoDevice) {
  Connect();
  ASSERT_TRUE(rig->Unplug("lines"));
  EXPECT_EQ(CauseOfNextEdge(), std::errc::no_such_device);
  EXPECT_EQ(lines->Drive(0, true).error().cause, std::errc::no_such_device);
  EXPECT_EQ(gpio::LocalLines::Connect(folder.path()).error().cause, std::errc::no_such_device);
  ASSERT_TRUE(rig->Plug("lines"));
  Connect();
}

TEST_F(LinesLink, APanelThatDoesNotAnswerIsNotWaitedFor) {
  auto connected = gpio::LocalLines::Connect(folder.path());
  ASSERT_TRUE(connected);
  EXPECT_EQ((*connected)->Greet(1ms).error().cause, std::errc::timed_out) << "nobody pumps the rig";
}

// A socket that stands where the panel should be, and says something else.
TEST(LinesPeer, PacketsThatAreNoneOfTheProtocolAreAnError) {
  const TempFolder folder;
  const auto listener = ListenForPackets(folder.path() + "/lines.lines");
  ASSERT_TRUE(listener);
  auto lines = gpio::LocalLines::Connect(folder.path());
  ASSERT_TRUE(lines);
  const auto peer = AcceptPeer(listener->get());
  ASSERT_TRUE(peer);
  ASSERT_TRUE(SendPacket(peer->get(), wire::Encode(wire::LinesHello{4, 1, 0})));
  ASSERT_TRUE((*lines)->Greet(100ms));
  ASSERT_TRUE(SendPacket(peer->get(), wire::Encode(wire::LineEdge{0, 4, 1})));  // There are lines 0 to 3.
  EXPECT_EQ((*lines)->ReadEdge().error().cause, std::errc::io_error);
  ASSERT_TRUE(SendPacket(peer->get(), wire::Encode(wire::LineEdge{0, 0, 1})));
  EXPECT_EQ((*lines)->ReadEdge().error().cause, std::errc::io_error) << "and stays one";
}

}  // namespace
}  // namespace kaori::sim
