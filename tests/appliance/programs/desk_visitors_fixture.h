// A fixture: a desk with lips in service, and its visitors over real sockets. Its clock advances only in the test.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "appliance/programs/desk/certificate.h"
#include "appliance/programs/desk/desk.h"
#include "tests/appliance/programs/desk_fixture.h"
#include "tests/appliance/programs/desk_visitor.h"

namespace kaori::tests {

// Without TLS until MakeSecure.
class DeskVisitors : public ::testing::Test {
 protected:
  DeskVisitors() : loop_(EventLoop::Open().value()) {
    fixture_.hand.scene.person.paint = {0.05F, 0.62F, 0.2F};
    fixture_.StartLips();
    desk_ = desk::Desk::Open({.port = 0,
                              .reach = web::Reach::kThisMachine,
                              .shows = ShowsSocket(),
                              .brought = fixture_.folder()},
                             fixture_.board, loop_, fixture_.clock)
                .value();
    fixture_.each_step = [this] { desk_->Step(); };
    fixture_.Play(std::chrono::milliseconds(100));
    const std::string address = desk_->address();
    port_ = static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1)));
  }

  // Where a test may listen in the place of kaori-shows.
  std::string ShowsSocket() const { return (fixture_.folder() / "shows").string(); }

  std::function<void()> Pump() {
    return [this] { desk_->Step(); };
  }
  Visitor Come() { return Visitor(port_, Pump()); }

  // One more of 127.0.0.`host`, who watches the events of a session.
  std::unique_ptr<Visitor> Watcher(const std::string& cookie, std::uint32_t host = 1) {
    constexpr int kSteps = 5;
    auto visitor = std::make_unique<Visitor>(port_, Pump(), host);
    visitor->Send(RequestOf({.path = "/events", .cookie = cookie}, port_));
    for (int step = 0; step < kSteps; ++step) desk_->Step();
    return visitor;
  }

  std::string Ask(const Asked& asked) {
    Visitor visitor = Come();
    visitor.Send(RequestOf(asked, port_));
    return visitor.Receive(IsWhole);
  }
  int Status(const Asked& asked) { return StatusOf(Ask(asked)); }

  int Try(std::uint32_t code) {
    return Status({.method = "POST", .path = "/pair", .body = fmt::format("{:06}", code)});
  }
  std::uint32_t WrongCode() const { return (desk_->pairing().code() + 1) % 1'000'000; }

  // The desk anew, with TLS.
  void MakeSecure() {
    desk_.reset();
    const auto own =
        desk::LoadOrMakeCertificate(fixture_.folder(), {{"localhost"}, 0x7F000001, 1'795'000'000}).value();
    desk_ = desk::Desk::Open({.port = 0, .reach = web::Reach::kThisMachine, .certificate = own.pem},
                             fixture_.board, loop_, fixture_.clock)
                .value();
    const std::string address = desk_->address();
    ASSERT_TRUE(address.starts_with("https://"));
    port_ = static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1)));
  }

  // The cookie of a new session.
  std::string Pair() {
    const std::string reply =
        Ask({.method = "POST", .path = "/pair", .body = fmt::format("{:06}", desk_->pairing().code())});
    EXPECT_EQ(StatusOf(reply), 204);
    const auto at = reply.find("kaori-desk=");
    return reply.substr(at, reply.find(';', at) - at);
  }

  LipFixture fixture_;
  EventLoop loop_;
  std::unique_ptr<desk::Desk> desk_;
  std::uint16_t port_ = 0;
};

}  // namespace kaori::tests
