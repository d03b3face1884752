// The simulator's page over real sockets: who says nothing, fills the places, or asks for a path that ends early.
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/event_loop.h"
#include "hw-sim/console/console.h"
#include "hw-sim/links/local/rig.h"
#include "tests/appliance/programs/desk_visitor.h"
#include "tests/hw-sim/link_fixture.h"

namespace kaori::console {
namespace {

using tests::AllowManyDescriptors;
using tests::Asked;
using tests::CrowdOf;
using tests::IsWhole;
using tests::RequestOf;
using tests::StatusOf;
using tests::Visitor;

// As out/trust.json has it of the desk.
constexpr auto kLongestAnswer = std::chrono::milliseconds(1000);
constexpr auto kTick = std::chrono::milliseconds(1);
constexpr int kVisitors = 30;  // More than one address may have.
constexpr int kShare = 24;     // What it may have.

class ConsoleVisitors : public ::testing::Test {
 protected:
  ConsoleVisitors() {
    EXPECT_TRUE(loop_.Every(kTick, [this] {
      if (++ticks_ % 2 == 0) loop_.Stop();
    }));
    const std::string address = console_->address();
    port_ = static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1)));
  }

  // A turn of the console's loop: all that is ready is served between its two ticks, however late the first one is.
  std::function<void()> Pump() {
    return [this] { EXPECT_TRUE(loop_.Run()); };
  }
  std::string Ask(const Asked& asked, std::uint32_t host = 1) {
    Visitor visitor(port_, Pump(), host);
    visitor.Send(RequestOf(asked, port_));
    return visitor.Receive(IsWhole);
  }

  sim::TempFolder folder_;
  SteadyClock clock_;
  EventLoop loop_ = EventLoop::Open().value();
  std::unique_ptr<sim::Rig> rig_ = sim::Rig::Open({.folder = folder_.path() + "/link"}, clock_).value();
  std::unique_ptr<Console> console_ = Console::Open({}, *rig_, loop_).value();
  std::uint16_t port_ = 0;
  int ticks_ = 0;
};

TEST_F(ConsoleVisitors, DoNotWaitForAThousandWhoSayNothingOrHalfAWord) {
  ASSERT_NO_FATAL_FAILURE(AllowManyDescriptors());
  const auto crowd = CrowdOf(1000, port_, Pump(), "GET / HT");
  const auto came = std::chrono::steady_clock::now();
  EXPECT_EQ(StatusOf(Ask({.path = "/state"})), 200) << "of the crowd's own address";
  EXPECT_LT(std::chrono::steady_clock::now() - came, kLongestAnswer);
  EXPECT_TRUE(crowd.front()->IsCutOff()) << "who came first and said nothing";
}

TEST_F(ConsoleVisitors, OfOneAddressWhoAllWatchLeaveRoomForOthers) {
  const auto has_state = [](const std::string& all) { return all.find("data: ") != all.npos; };
  std::vector<std::unique_ptr<Visitor>> crowd;
  int watching = 0;
  for (int n = 0; n < kVisitors; ++n) {
    crowd.push_back(std::make_unique<Visitor>(port_, Pump()));
    crowd.back()->Send(RequestOf({.path = "/events"}, port_));
    watching += has_state(crowd.back()->Receive(has_state)) ? 1 : 0;
  }
  EXPECT_EQ(watching, kShare);
  EXPECT_TRUE(crowd.back()->IsCutOff()) << "its address has its share";
  EXPECT_EQ(StatusOf(Ask({})), 0) << "those who watch go on";
  EXPECT_EQ(StatusOf(Ask({}, 2)), 200) << "of another address";
  EXPECT_TRUE(has_state(crowd.front()->Receive(has_state)));
}

TEST_F(ConsoleVisitors, WhoAskForAPathWithAZeroByteAreRefused) {
  for (const char* path : {"/%00", "/state%00", "/%00/state", "/state%00.png"})
    EXPECT_EQ(StatusOf(Ask({.path = path})), 400) << path;
  EXPECT_EQ(StatusOf(Ask({.path = "/%73tate"})), 200) << "other bytes may be written so";
}

}  // namespace
}  // namespace kaori::console
