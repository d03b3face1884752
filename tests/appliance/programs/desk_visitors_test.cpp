// The desk and its visitors over real sockets: who is authorised, who is refused, and what they see.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/appliance/programs/desk_visitors_fixture.h"

namespace kaori::tests {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
using ::testing::HasSubstr;

TEST_F(DeskVisitors, GetThePageAndNothingElseWithoutACode) {
  EXPECT_EQ(Status({}), 200);
  EXPECT_EQ(Status({.path = "/main.js"}), 200);
  EXPECT_THAT(Ask({.path = "/hello"}), HasSubstr("\"paired\":false"));
  for (const char* path :
       {"/state", "/events", "/picture", "/picture/both", "/status.png", "/nothing", "/../etc/passwd"})
    EXPECT_EQ(Status({.path = path}), 401) << path;
  EXPECT_EQ(Status({.method = "POST", .path = "/do", .body = "defaults"}), 401);
  EXPECT_EQ(Status({.path = "/state", .cookie = "kaori-desk=" + std::string(64, '0')}), 401);
  EXPECT_EQ(Status({.path = "/state", .cookie = "kaori-desk="}), 401);
}

TEST_F(DeskVisitors, AreAuthorisedByTheCodeOnTheBoard) {
  const board::Stamped<board::Desk> shown = fixture_.board.Read<board::Desk>();
  EXPECT_EQ(shown.source, board::SourceState::kLive);
  EXPECT_EQ(shown.value.code, desk_->pairing().code());
  EXPECT_EQ(shown.value.port, port_);
  EXPECT_GT(shown.value.valid_s, 200);
  const std::string cookie = Pair();
  EXPECT_THAT(Ask({.path = "/state", .cookie = "other=1; " + cookie}), HasSubstr("\"lips\":true"));
  fixture_.Play(100ms);
  EXPECT_EQ(fixture_.board.Read<board::Desk>().source, board::SourceState::kAbsent)
      << "no code on the screen";
  EXPECT_EQ(Status({.method = "POST", .path = "/leave", .cookie = cookie}), 204);
  EXPECT_EQ(Status({.path = "/state", .cookie = cookie}), 401);
}

TEST_F(DeskVisitors, SeeTheStatusOfTheBoxOncePaired) {
  const std::string reply = Ask({.path = "/status.png", .cookie = Pair()});
  EXPECT_EQ(StatusOf(reply), 200);
  EXPECT_THAT(reply, HasSubstr("image/png"));
  EXPECT_THAT(reply, HasSubstr("\x89PNG"));
}

TEST_F(DeskVisitors, MayTryFiveTimesAMinute) {
  for (int n = 0; n < 5; ++n) EXPECT_EQ(Try(WrongCode()), 403);
  EXPECT_EQ(Try(desk_->pairing().code()), 429) << "not even the right one";
  fixture_.Play(61s);
  EXPECT_EQ(Try(desk_->pairing().code()), 204);
}

TEST_F(DeskVisitors, FindTheCodeUsedUpAndRenewed) {
  const std::uint32_t first = desk_->pairing().code();
  Pair();
  EXPECT_EQ(Try(first), 403);
  const std::uint32_t second = desk_->pairing().code();
  fixture_.reader.reset();  // Five minutes of pictures are not needed.
  fixture_.lips.reset();
  fixture_.Play(301s);
  EXPECT_NE(desk_->pairing().code(), second);
}

TEST_F(DeskVisitors, OfOtherSitesAreRefused) {
  const std::string cookie = Pair();
  for (const char* host : {"example.org", "127.0.0.1.example.org", "evil:8443", "127.0.0.1:80@x", "[::1"})
    EXPECT_EQ(Status({.host = host}), 403) << host;
  EXPECT_EQ(Status({.host = fmt::format("localhost:{}", port_)}), 200);
  Asked post{.method = "POST", .path = "/do", .body = "defaults", .cookie = cookie};
  for (const char* origin :
       {"http://example.org", "null", "none", "http://127.0.0.1:1", "https://127.0.0.1"}) {
    post.origin = origin;
    EXPECT_EQ(Status(post), 403) << origin;
  }
  EXPECT_EQ(Status({.path = "/state", .cookie = cookie, .more = "Sec-Fetch-Site: cross-site\r\n"}), 403);
  post.origin = {};
  EXPECT_EQ(Status(post), 200);
}

TEST_F(DeskVisitors, AreRefusedWhatIsTooLongOrMeaningless) {
  const std::string cookie = Pair();
  Asked post{.method = "POST", .path = "/do", .body = std::string(70'000, 'x'), .cookie = cookie};
  EXPECT_EQ(Status(post), 413);
  for (const char* body :
       {"", "kettle", "sample 0.5", "sample nan 1", "sample 0.5 0.5 0.5", "set key.spill", "begin", "look",
        "return 0", "set key.spill 1e99 0", "sample -5 99", "sample 0.5 1.01", "begin x", "begin wide\n",
        "undo\nsave", "set key.\x1b[31mspill 1 0"}) {
    post.body = body;
    EXPECT_EQ(Status(post), 400) << body;
  }
  Visitor huge = Come();
  huge.Send("GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nX: " + std::string(200'000, 'y'));
  const std::string answer = huge.Receive(IsWhole);
  EXPECT_TRUE(answer.empty() || StatusOf(answer) >= 400) << answer;
  EXPECT_EQ(Status({.method = "DELETE",
                    .path = "/state",
                    .cookie = cookie,
                    .origin = fmt::format("http://127.0.0.1:{}", port_)}),
            405);
}

// No time passes on the desk's clock: nobody waits until a time-out ends somebody else.
TEST_F(DeskVisitors, SeePicturesOnlyWhilePairedAndTheLipsDrawNoneWithoutAVisitor) {
  fixture_.Play(3s);
  {
    Visitor unpaired = Come();
    unpaired.Send(RequestOf({.path = "/picture"}, port_));
    EXPECT_EQ(StatusOf(unpaired.Receive(IsWhole)), 401);
    fixture_.Play(1s);
  }
  const auto pictures = [this](const std::string& cookie) {
    const std::string state = Ask({.path = "/state", .cookie = cookie});
    return std::stoi(state.substr(state.find("\"picture\":") + 10));
  };
  const std::string cookie = Pair();
  EXPECT_EQ(pictures(cookie), 0) << "nobody looks";
  Visitor paired = Come();
  paired.Send(RequestOf({.path = "/picture", .cookie = cookie}, port_));
  std::string stream;
  for (int n = 0; n < 20 && stream.find("image/jpeg") == std::string::npos; ++n) {
    fixture_.Play(50ms);
    stream += paired.Receive([](const std::string& got) { return !got.empty(); });
  }
  EXPECT_THAT(stream, HasSubstr("image/jpeg"));
  EXPECT_GT(pictures(cookie), 0);
  EXPECT_EQ(Status({.method = "POST", .path = "/leave", .cookie = cookie}), 204);
  fixture_.Play(100ms);
  const auto ended = [](const std::string& got) { return ("\r\n" + got).ends_with("\r\n0\r\n\r\n"); };
  EXPECT_TRUE(ended(paired.Receive(ended))) << "who left sees no more";
}

TEST_F(DeskVisitors, ReadWhetherTheLipsAreGone) {
  const std::string cookie = Pair();
  EXPECT_EQ(Status({.method = "POST", .path = "/do", .body = "undo", .cookie = cookie}), 200);
  fixture_.lips.reset();
  fixture_.Play(500ms);
  EXPECT_THAT(Ask({.path = "/state", .cookie = cookie}), HasSubstr("\"lips\":false"));
  EXPECT_EQ(Status({.method = "POST", .path = "/do", .body = "undo", .cookie = cookie}), 503);
  fixture_.StartLips();
  fixture_.Play(600ms);
  EXPECT_THAT(Ask({.path = "/state", .cookie = cookie}), HasSubstr("\"lips\":true"));
}

TEST_F(DeskVisitors, ReadThePageInTheirLanguage) {
  EXPECT_THAT(Ask({.more = "Accept-Language: ja,en-US;q=0.9\r\n"}), HasSubstr("<html lang=\"ja\">"));
  EXPECT_THAT(Ask({.more = "Accept-Language: de,en;q=0.7,ja;q=0.3\r\n"}), HasSubstr("<html lang=\"en\">"));
}

}  // namespace
}  // namespace kaori::tests
