// The desk's part in the box's list and settings: it hands on what a paired visitor asks for, and nothing else.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <fstream>

#include "appliance/programs/shows/protocol/protocol.h"
#include "drivers/base/packet_socket.h"
#include "drivers/base/whole_file.h"
#include "tests/appliance/programs/desk_visitors_fixture.h"

namespace kaori::tests {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
using ::testing::HasSubstr;

class DeskBox : public DeskVisitors {
 protected:
  // kaori-shows is there from now on, and has said this.
  void Listen(std::string_view state) {
    listener_ = ListenForPackets(ShowsSocket()).value();
    fixture_.Play(600ms);
    shows_ = AcceptPeer(listener_.get()).value();
    EXPECT_TRUE(SendPacket(shows_.get(), AsBytes(state)));
    fixture_.Play(50ms);
  }
  // What the desk handed on; empty where it did nothing.
  std::string Heard() {
    std::array<std::uint8_t, shows::kLongestRequest_bytes> bytes;
    const auto packet = ReceivePacket(shows_.get(), bytes);
    return packet ? std::string(reinterpret_cast<const char*>(bytes.data()), packet->bytes) : std::string();
  }
  Asked Post(std::string body, std::string path = "/box") {
    return {.method = "POST", .path = std::move(path), .body = std::move(body), .cookie = cookie_};
  }

  UniqueFd listener_, shows_;
  std::string cookie_ = Pair();
};

TEST_F(DeskBox, IsForPairedVisitorsAlone) {
  Listen("{\"list\":1}");
  for (const char* path : {"/box", "/box/events"}) EXPECT_EQ(Status({.path = path}), 401) << path;
  EXPECT_EQ(Status({.method = "POST", .path = "/box", .body = "take 0 1"}), 401);
  Asked foreign = Post("take 0 1");
  foreign.origin = "http://example.org";
  EXPECT_EQ(Status(foreign), 403);
  EXPECT_EQ(Heard(), "");
}

TEST_F(DeskBox, ShowsTheStateThatKaoriShowsSaysAndTheNewestOfIt) {
  EXPECT_EQ(Status({.path = "/box", .cookie = cookie_}), 503) << "it is away";
  Listen("{\"list\":1}");
  EXPECT_THAT(Ask({.path = "/box", .cookie = cookie_}), HasSubstr("{\"list\":1}"));
  EXPECT_TRUE(SendPacket(shows_.get(), AsBytes(std::string_view("{\"list\":2}"))));
  fixture_.Play(50ms);
  EXPECT_THAT(Ask({.path = "/box", .cookie = cookie_}), HasSubstr("{\"list\":2}"));
  shows_.reset();
  listener_.reset();
  fixture_.Play(50ms);
  EXPECT_EQ(Status({.path = "/box", .cookie = cookie_}), 503)
      << "the list of a program that is gone is nobody's";
}

TEST_F(DeskBox, SendsEachStateToThePage) {
  Listen("{\"list\":1}");
  Visitor page = Come();
  page.Send(RequestOf({.path = "/box/events", .cookie = cookie_}, port_));
  const auto has = [](const char* words) {
    return [words](const std::string& all) { return all.find(words) != std::string::npos; };
  };
  fixture_.clock.Advance(1s);
  EXPECT_THAT(page.Receive(has("data: {\"list\":1}")), HasSubstr("data: {\"list\":1}"));
  EXPECT_TRUE(SendPacket(shows_.get(), AsBytes(std::string_view("{\"list\":2}"))));
  EXPECT_THAT(page.Receive(has("data: {\"list\":2}")), HasSubstr("data: {\"list\":2}"));
}

TEST_F(DeskBox, PassesRequestsOnAndRefusesAllElse) {
  EXPECT_EQ(Status(Post("take 0 1")), 503) << "nobody is there to take it";
  Listen("{\"list\":1}");
  EXPECT_EQ(Status(Post("take 2 1")), 204);
  EXPECT_EQ(Heard(), "take 2 1");
  const std::string settings = "settings\n" + std::string(std::size_t{64} << 10U, '#');
  EXPECT_EQ(Status(Post(settings)), 204) << "the longest settings";
  EXPECT_EQ(Heard(), settings);
  for (const char* body : {"", "take", "take 1 x", "reset", "settings"})
    EXPECT_EQ(Status(Post(body)), 400) << body;
  EXPECT_EQ(Status(Post("settings\n" + std::string(shows::kLongestRequest_bytes, '#'))), 413);
  EXPECT_EQ(Heard(), "");
}

TEST_F(DeskBox, GivesTheNewestBackupToWhoeverFetchesIt) {
  Listen("{\"list\":1}");
  EXPECT_EQ(Status({.path = "/backup", .cookie = cookie_}), 404);
  const std::string bytes(300'000, 'b');
  std::ofstream(fixture_.folder() / "backup") << bytes;
  const UniqueFd file(::open((fixture_.folder() / "backup").c_str(), O_RDONLY | O_CLOEXEC));
  EXPECT_TRUE(SendPacket(shows_.get(), AsBytes(std::string_view("left.kaorishow")), file.get()));
  fixture_.Play(50ms);
  EXPECT_EQ(Status({.path = "/backup"}), 401);
  for (int time = 0; time < 2; ++time) {
    const std::string reply = Ask({.path = "/backup", .cookie = cookie_});
    EXPECT_EQ(StatusOf(reply), 200);
    EXPECT_THAT(reply, HasSubstr("filename=\"left.kaorishow\""));
    EXPECT_TRUE(reply.ends_with("\r\n\r\n" + bytes)) << reply.size();
  }
  EXPECT_THAT(Ask({.path = "/box", .cookie = cookie_}), HasSubstr("{\"list\":1}")) << "its name is no state";
}

TEST_F(DeskBox, PassesABackupOnThatCameInParts) {
  Listen("{\"list\":1}");
  EXPECT_EQ(Status(Post("restore left.kaorishow")), 409) << "nothing was brought";
  EXPECT_EQ(Status({.method = "POST", .path = "/brought/0", .body = "x"}), 401);
  EXPECT_EQ(Status(Post("forgotten", "/brought/0")), 204);
  EXPECT_EQ(Status(Post("one ", "/brought/0")), 204) << "it begins anew";
  EXPECT_EQ(Status(Post("three", "/brought/9")), 409) << "a part is missing";
  EXPECT_EQ(Status(Post("two", "/brought/x")), 400);
  EXPECT_EQ(Status(Post("two", "/brought/4")), 204);
  EXPECT_EQ(Status(Post("restore left.kaorishow")), 204);
  std::array<std::uint8_t, 64> text;
  const auto packet = ReceivePacket(shows_.get(), text);
  ASSERT_TRUE(packet && packet->descriptor.valid());
  std::array<char, 16> brought{};
  EXPECT_EQ(::pread(packet->descriptor.get(), brought.data(), brought.size(), 0), 7);
  EXPECT_STREQ(brought.data(), "one two");
  EXPECT_EQ(Status(Post("restore left.kaorishow")), 409) << "it went with the first";
}

}  // namespace
}  // namespace kaori::tests
