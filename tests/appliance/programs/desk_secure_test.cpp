// Over TLS the desk is as hard to fill as without: who begins a handshake and says no more keeps nobody waiting.
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "tests/appliance/programs/desk_secure_visitor.h"
#include "tests/appliance/programs/desk_visitors_fixture.h"

namespace kaori::tests {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.

// The beginning of a handshake: a record of it, of TLS 1.0 as all begin, and nothing of its length.
constexpr std::string_view kHalfAHello = "\x16\x03\x01";
// As out/trust.json has it of the desk without TLS.
constexpr auto kLongestWait = 1000ms;

class SecureDeskVisitors : public DeskVisitors {
 protected:
  SecureDeskVisitors() { MakeSecure(); }

  SecureVisitor ComeSecurely(std::uint32_t host = 1) { return {port_, Pump(), "NORMAL", host}; }
  int SecureStatus(const Asked& asked) { return StatusOf(ComeSecurely().Ask(RequestOf(asked, port_))); }
  std::vector<std::unique_ptr<Visitor>> Crowd(int count) {
    return CrowdOf(count, port_, Pump(), kHalfAHello);
  }
  // The cookie of a new session.
  std::string PairSecurely() {
    const std::string reply =
        ComeSecurely().Ask(RequestOf({.method = "POST",
                                      .path = "/pair",
                                      .body = fmt::format("{:06}", desk_->pairing().code()),
                                      .origin = fmt::format("https://127.0.0.1:{}", port_)},
                                     port_));
    EXPECT_EQ(StatusOf(reply), 204) << reply;
    const auto at = reply.find("kaori-desk=");
    return at == reply.npos ? "" : reply.substr(at, reply.find(';', at) - at);
  }
};

TEST_F(SecureDeskVisitors, DoNotWaitForAThousandWhoSayNothingOrHalfAHello) {
  ASSERT_NO_FATAL_FAILURE(AllowManyDescriptors());
  const auto crowd = Crowd(1000);
  const auto came = std::chrono::steady_clock::now();
  EXPECT_EQ(SecureStatus({}), 200) << "of the crowd's own address";
  EXPECT_LT(std::chrono::steady_clock::now() - came, kLongestWait);
  EXPECT_LE(desk_->connections(), 24U);
  EXPECT_TRUE(crowd.front()->IsCutOff());
}

TEST_F(SecureDeskVisitors, WhoOnlyBeginAHandshakeAreGoneAfterTenSeconds) {
  const auto crowd = Crowd(100);
  desk_->Step();
  EXPECT_GT(desk_->connections(), 0U);
  EXPECT_LE(desk_->connections(), 24U);
  fixture_.Play(11s);
  EXPECT_EQ(desk_->connections(), 0U);
}

TEST_F(SecureDeskVisitors, OfOneAddressWhoAllWatchLeaveRoomForOthers) {
  const std::string watch = RequestOf({.path = "/events", .cookie = PairSecurely()}, port_);
  std::vector<std::unique_ptr<SecureVisitor>> crowd;
  int watching = 0;
  for (int n = 0; n < 30; ++n) {
    crowd.push_back(std::make_unique<SecureVisitor>(port_, Pump()));
    watching += crowd.back()->Send(watch) && crowd.back()->Hears() ? 1 : 0;
  }
  EXPECT_EQ(watching, 24);
  EXPECT_EQ(desk_->connections(), 24U);
  EXPECT_EQ(SecureStatus({}), 0) << "those who watch go on";
  EXPECT_EQ(StatusOf(ComeSecurely(2).Ask(RequestOf({}, port_))), 200) << "of another address";
}

TEST_F(SecureDeskVisitors, WhoAskForAPathWithAZeroByteAreRefused) {
  for (const char* path : {"/%00", "/hello%00", "/%00/main.js", "/main.js%00.png"})
    EXPECT_EQ(SecureStatus({.path = path}), 400) << path;
  EXPECT_EQ(SecureStatus({.path = "/main%2Ejs"}), 200) << "other bytes may be written so";
}

}  // namespace
}  // namespace kaori::tests
