// The desk's connections: who is slow, says nothing, offers weak ciphers or fills the places.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/appliance/programs/desk_secure_visitor.h"
#include "tests/appliance/programs/desk_visitors_fixture.h"

namespace kaori::tests {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
using ::testing::HasSubstr;

TEST_F(DeskVisitors, WhoSendByteByByteAreDisconnectedAfterTenSeconds) {
  Visitor slow = Come();
  const std::string request = RequestOf({}, port_);
  for (int second = 0; second < 9; ++second) {
    ASSERT_TRUE(slow.Send(request.substr(static_cast<std::size_t>(second), 1)));
    fixture_.Play(1s);
  }
  EXPECT_EQ(desk_->connections(), 1U);
  slow.Send(request.substr(9, 1));
  fixture_.Play(2s);
  EXPECT_TRUE(slow.IsCutOff());
  EXPECT_EQ(desk_->connections(), 0U);
}

TEST_F(DeskVisitors, WhoSendABodyByteByByteAreDisconnectedToo) {
  Visitor slow = Come();
  slow.Send(fmt::format(
      "POST /pair HTTP/1.1\r\nHost: 127.0.0.1\r\nOrigin: http://127.0.0.1\r\nContent-Length: 6\r\n\r\n"));
  for (int second = 0; second < 5; ++second) {
    slow.Send("1");
    fixture_.Play(2200ms);
  }
  EXPECT_TRUE(slow.IsCutOff());
}

TEST_F(DeskVisitors, WhoSpeakNoTlsToASecureDeskAreDisconnected) {
  MakeSecure();
  Visitor plain = Come();
  plain.Send(RequestOf({}, port_));
  EXPECT_TRUE(plain.IsCutOff());
  Visitor garbage = Come();
  garbage.Send("\x16\x03\x01\xff\xff" + std::string(70'000, '\x01'));
  EXPECT_TRUE(garbage.IsCutOff());
  Visitor silent = Come();
  silent.Send("\x16\x03\x01");
  fixture_.Play(9s);
  EXPECT_EQ(desk_->connections(), 1U);
  fixture_.Play(2s);
  EXPECT_TRUE(silent.IsCutOff()) << "in the middle of the handshake";
  EXPECT_EQ(desk_->connections(), 0U);
}

TEST_F(DeskVisitors, AgreeOnNewTlsWithAuthenticatedEncryptionAlone) {
  MakeSecure();
  const auto agrees = [this](const char* offered) { return SecureVisitor(port_, Pump(), offered).Agrees(); };
  EXPECT_TRUE(agrees("NORMAL"));
  EXPECT_TRUE(agrees("NORMAL:-VERS-ALL:+VERS-TLS1.3"));
  EXPECT_TRUE(agrees("NORMAL:-VERS-ALL:+VERS-TLS1.2"));
  EXPECT_TRUE(agrees("NORMAL:-VERS-ALL:+VERS-TLS1.2:-CIPHER-ALL:+AES-128-GCM"));
  for (const char* weak : {"LEGACY:-VERS-ALL:+VERS-TLS1.0", "LEGACY:-VERS-ALL:+VERS-TLS1.1",
                           "LEGACY:-VERS-ALL:+VERS-TLS1.0:+VERS-TLS1.1",
                           "NORMAL:-VERS-ALL:+VERS-TLS1.2:-CIPHER-ALL:+AES-128-CBC:+AES-256-CBC",
                           "NORMAL:-VERS-ALL:+VERS-TLS1.2:-KX-ALL:+RSA",
                           "NORMAL:-VERS-ALL:+VERS-TLS1.2:-CIPHER-ALL:+AES-128-CCM-8"})
    EXPECT_FALSE(agrees(weak)) << weak;
}

TEST_F(DeskVisitors, GetNoSecureDeskWithAnInvalidCertificate) {
  desk_.reset();
  const auto opened = desk::Desk::Open(
      {.port = 0, .reach = web::Reach::kThisMachine, .certificate = web::Certificate{"a", "b"}},
      fixture_.board, loop_, fixture_.clock);
  ASSERT_FALSE(opened);
  EXPECT_THAT(opened.error().message(), HasSubstr("certificate"));
  fixture_.each_step = nullptr;
}

TEST_F(DeskVisitors, OfOneAddressDoNotFillTheDesk) {
  std::vector<std::unique_ptr<Visitor>> crowd;
  for (int n = 0; n < 100; ++n) {
    crowd.push_back(std::make_unique<Visitor>(port_, Pump()));
    desk_->Step();
  }
  EXPECT_LE(desk_->connections(), 24U);
  fixture_.Play(11s);
  EXPECT_EQ(desk_->connections(), 0U);
}

TEST_F(DeskVisitors, DoNotWaitForAThousandWhoSayNothingOrHalfAWord) {
  ASSERT_NO_FATAL_FAILURE(AllowManyDescriptors());
  const auto crowd = CrowdOf(1000, port_, Pump(), "GET / HT");
  const auto came = std::chrono::steady_clock::now();
  EXPECT_EQ(Status({}), 200) << "of the crowd's own address";
  const auto waited = std::chrono::steady_clock::now() - came;
  RecordProperty("silent_clients_wait_ms",
                 std::to_string(std::chrono::duration<double, std::milli>(waited).count()));
  EXPECT_LE(desk_->connections(), 24U);
}

TEST_F(DeskVisitors, OfOneAddressWhoAllWatchLeaveRoomForOthers) {
  const std::string cookie = Pair();
  std::vector<std::unique_ptr<Visitor>> crowd;
  for (int n = 0; n < 40; ++n) crowd.push_back(Watcher(cookie));
  EXPECT_EQ(desk_->connections(), 24U);
  Visitor next = Come();
  next.Send(RequestOf({}, port_));
  EXPECT_TRUE(next.IsCutOff()) << "those who watch go on";
  Visitor other(port_, Pump(), 2);
  other.Send(RequestOf({}, port_));
  EXPECT_EQ(StatusOf(other.Receive(IsWhole)), 200);
}

TEST_F(DeskVisitors, DoNotWaitForThoseWhoAskAndReceiveNothing) {
  std::vector<std::vector<std::unique_ptr<Visitor>>> crowds;
  for (const std::uint32_t host : {2U, 3U, 4U}) crowds.push_back(DeafCrowdOf(24, port_, Pump(), host));
  for (int turn = 0; turn < 500; ++turn) desk_->Step();
  EXPECT_EQ(desk_->connections(), 64U);
  EXPECT_EQ(Status({}), 200) << "of an address of its own";
  Visitor neighbour(port_, Pump(), 2);
  neighbour.Send(RequestOf({}, port_));
  EXPECT_EQ(StatusOf(neighbour.Receive(IsWhole)), 200) << "of the crowd's address";
}

TEST_F(DeskVisitors, OfManyAddressesLeaveRoomForAnother) {
  const std::string cookie = Pair();
  std::vector<std::unique_ptr<Visitor>> crowd;
  for (std::uint32_t n = 0; n < 70; ++n) crowd.push_back(Watcher(cookie, 2 + n % 3));
  EXPECT_EQ(desk_->connections(), 64U);
  Visitor other(port_, Pump(), 7);
  other.Send(RequestOf({}, port_));
  EXPECT_EQ(StatusOf(other.Receive(IsWhole)), 200);
  EXPECT_FALSE(crowd.front()->IsCutOff()) << "who watches for the longest goes on";
}

TEST_F(DeskVisitors, WhoseRequestCanBeReadInTwoWaysAreRefused) {
  for (const char* more : {"Host: elsewhere.example\r\n", "Origin: http://elsewhere.example\r\n",
                           "Content-Length: 44\r\n", "Transfer-Encoding: chunked\r\n"})
    EXPECT_EQ(Status({.method = "POST", .path = "/pair", .body = "stop", .more = more}), 400) << more;
}

TEST_F(DeskVisitors, WhoseCookieStandsBehindASimilarOneAreKnown) {
  EXPECT_EQ(Status({.path = "/state", .cookie = "xkaori-desk=1; " + Pair()}), 200);
}

TEST_F(DeskVisitors, WhoAskForAPathWithAZeroByteAreRefused) {
  for (const char* path : {"/%00", "/hello%00", "/%00/main.js", "/main.js%00.png"})
    EXPECT_EQ(Status({.path = path}), 400) << path;
  EXPECT_EQ(Status({.path = "/main%2Ejs"}), 200) << "other bytes may be written so";
}

}  // namespace
}  // namespace kaori::tests
