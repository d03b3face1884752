// The real programs in service: kaori-desk before kaori-lips, and what each does when the other dies.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>

#include "appliance/core/board/board.h"
#include "hw-sim/hil/picture.h"
#include "tests/appliance/programs/desk_visitor.h"
#include "tests/system/program_runner.h"

namespace kaori::test {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
using board::SourceState;
using ::testing::HasSubstr;
using tests::Asked;

class DeskProgram : public ::testing::Test {
 protected:
  void StartLips() {
    programs_.Start("kaori-lips", {"--board", programs_.board(), "--links", programs_.links(), "--service",
                                   "--settings", programs_.File("lips.settings")});
  }
  void StartDesk() {
    std::filesystem::remove(programs_.File("address"));
    programs_.Start("kaori-desk", {"--service", "--board", programs_.board(), "--port", "0", "--plain",
                                   "--local", "--address-file", programs_.File("address")});
    ASSERT_TRUE(Await([this] { return ReadPort(); })) << programs_.LogOf("kaori-desk");
    board_ = board::Board::Create(programs_.board()).value();
    ASSERT_TRUE(Await([this] { return board_->Read<board::Desk>().source == SourceState::kLive; }));
  }
  void StartAll() {
    programs_.Start("kaori-sim", {"--links", programs_.links()});
    StartLips();
    StartDesk();
    ASSERT_TRUE(Await([this] { return Lips().source == SourceState::kLive; }));
  }

  bool ReadPort() {
    std::ifstream file(programs_.File("address"));
    std::string address;
    if (!std::getline(file, address) || file.eof()) return false;
    port_ = static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1)));
    return true;
  }

  std::string Ask(const Asked& asked) {
    tests::Visitor visitor(port_, [] {});
    visitor.Send(tests::RequestOf(asked, port_));
    return visitor.Receive(tests::IsWhole);
  }
  std::string Pair() {
    const std::string code = fmt::format("{:06}", board_->Read<board::Desk>().value.code);
    const std::string reply = Ask({.method = "POST", .path = "/pair", .body = code});
    EXPECT_EQ(tests::StatusOf(reply), 204) << reply;
    const auto at = reply.find("kaori-desk=");
    return reply.substr(at, reply.find(';', at) - at);
  }
  // How many rows of the status picture say that something is at fault: -1 where there is no picture.
  int Faults(const std::string& cookie) {
    constexpr std::array<int, 3> kRed{240, 80, 70};
    const std::string reply = Ask({.path = "/status.png", .cookie = cookie});
    const auto head = reply.find("\r\n\r\n");
    if (tests::StatusOf(reply) != 200 || head == std::string::npos) return -1;
    std::ofstream(programs_.File("status.png"), std::ios::binary) << reply.substr(head + 4);
    return hil::CountMarks(programs_.File("status.png"), kRed).value_or(-1);
  }
  bool State(const std::string& cookie, const char* words) {
    return Ask({.path = "/state", .cookie = cookie}).find(words) != std::string::npos;
  }
  board::Stamped<board::Lips> Lips() const { return board_->Read<board::Lips>(); }

  ProgramRunner programs_;
  std::optional<board::Board> board_;
  std::uint16_t port_ = 0;
};

TEST_F(DeskProgram, RefusesToServeABoxThatPlaysInOneLine) {
  EXPECT_EQ(programs_.RunToEnd("kaori-desk", {"--board", programs_.board()}), 2);
  const std::string log = programs_.LogOf("kaori-desk");
  EXPECT_THAT(log, HasSubstr("--service"));
  EXPECT_EQ(std::ranges::count(log, '\n'), 1);
}

TEST_F(DeskProgram, ChangesTheLipsOfAPairedVisitor) {
  StartAll();
  const std::string cookie = Pair();
  EXPECT_TRUE(Await([&] { return State(cookie, "\"lips\":true"); }));
  EXPECT_EQ(tests::StatusOf(
                Ask({.method = "POST", .path = "/do", .body = "set mouth.open 0.7 1", .cookie = cookie})),
            200);
  EXPECT_TRUE(Await([&] { return Lips().value.open == 0.7F; }));
  EXPECT_EQ(tests::StatusOf(Ask({.method = "POST", .path = "/do", .body = "save", .cookie = cookie})), 200);
  EXPECT_TRUE(Await([&] { return std::filesystem::exists(programs_.File("lips.settings")); }));
  programs_.Kill("kaori-lips");
  EXPECT_TRUE(Await([&] { return State(cookie, "\"lips\":false"); })) << "and the page says so";
  StartLips();
  EXPECT_TRUE(Await([&] { return State(cookie, "\"lips\":true"); }));
  EXPECT_TRUE(Await([&] { return Lips().source == SourceState::kLive && Lips().value.open == 0.7F; }))
      << "as it was saved";
}

TEST_F(DeskProgram, ShowsOnTheStatusPictureThatTheStageHasAScreen) {
  StartAll();
  const std::string cookie = Pair();
  EXPECT_EQ(Faults(cookie), 2) << "no screen, and no picture on it";
  programs_.Start("kaori-stage",
                  {"--board", programs_.board(), "--links", programs_.links(), "--pack",
                   (ProgramRunner::Programs().parent_path() / "shows" / "kaori.kaori").string()});
  EXPECT_TRUE(Await([&] { return Faults(cookie) == 0; }, 30s)) << programs_.LogOf("kaori-stage");
}

TEST_F(DeskProgram, DoesNotDisturbTheLipsWhenItDies) {
  StartAll();
  for (int round = 0; round < 3; ++round) {
    const std::uint32_t code = board_->Read<board::Desk>().value.code;
    tests::Visitor looker(port_, [] {});
    looker.Send(tests::RequestOf({.path = "/picture", .cookie = Pair()}, port_));
    programs_.Kill("kaori-desk");
    const std::uint32_t frames = Lips().value.frames;
    EXPECT_TRUE(Await([&] { return Lips().value.frames > frames + 5; }, 2s));
    EXPECT_EQ(Lips().source, SourceState::kLive);
    StartDesk();
    EXPECT_TRUE(Await([&] { return board_->Read<board::Desk>().value.code != code; }))
        << "a new code at every start";
  }
}

TEST_F(DeskProgram, FindsNoWayIntoLipsThatAreNotInService) {
  programs_.Start("kaori-sim", {"--links", programs_.links()});
  programs_.Start("kaori-lips", {"--board", programs_.board(), "--links", programs_.links()});
  StartDesk();
  ASSERT_TRUE(Await([this] { return Lips().source == SourceState::kLive; }));
  EXPECT_FALSE(std::filesystem::exists(programs_.board() + ".lips"));
  const std::string cookie = Pair();
  EXPECT_TRUE(State(cookie, "\"lips\":false"));
}

}  // namespace
}  // namespace kaori::test
