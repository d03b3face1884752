// Roles of sticks, and settings.
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "appliance/programs/input/service_key.h"
#include "appliance/programs/input/settings.h"
#include "appliance/programs/input/stick_roles.h"
#include "tests/appliance/core/board_file.h"

namespace kaori::input {
namespace {

using ::testing::HasSubstr;

TEST(Roles, GoToSticksInTheOrderOfTheirPorts) {
  EXPECT_TRUE(PortBefore("1-2", "1-10"));
  EXPECT_FALSE(PortBefore("1-10", "1-2"));
  EXPECT_TRUE(PortBefore("1-2", "1-2.1"));
  EXPECT_FALSE(PortBefore("2-1", "2-1"));
  StickRoles roles({}, {});
  EXPECT_EQ(roles.RoleOf("1-2", {false, false}), 0);
  EXPECT_EQ(roles.RoleOf("1-10", {true, false}), 1);
}

TEST(Roles, GoToSticksInTheOrderOfTheirPortsWhicheverComesFirst) {
  StickRoles roles({}, {});
  ASSERT_EQ(roles.RoleOf("1-3", {false, false}), 0);
  EXPECT_FALSE(roles.IsBeforeLeft("1-4"));
  ASSERT_TRUE(roles.IsBeforeLeft("1-2"));
  roles.MoveLeftToRight();
  EXPECT_EQ(roles.RoleOf("1-2", {false, true}), 0);
  EXPECT_FALSE(roles.IsBeforeLeft("1-1")) << "both have been given";
  EXPECT_EQ(roles.RoleOf("1-3", {false, false}), 1);
}

TEST(Roles, ThatAreKnownGiveWayToNoPort) {
  StickRoles remembered({}, {HashOfPort("1-3"), 0}), named({"1-3", ""}, {}), own({}, {});
  for (StickRoles* roles : {&remembered, &named}) {
    ASSERT_EQ(roles->RoleOf("1-3", {false, false}), 0);
    EXPECT_FALSE(roles->IsBeforeLeft("1-2"));
  }
  StickRoles right_named({"", "1-9"}, {});
  ASSERT_EQ(right_named.RoleOf("1-3", {false, false}), 0);
  EXPECT_FALSE(right_named.IsBeforeLeft("1-2")) << "the right role waits for its port";
  ASSERT_EQ(own.RoleOf("stick-left", {false, false}), 0);
  EXPECT_FALSE(own.IsBeforeLeft("1-2"));
}

TEST(Roles, StayWithTheirPortsOverReplugs) {
  StickRoles roles({}, {});
  ASSERT_EQ(roles.RoleOf("1-2", {false, false}), 0);
  ASSERT_EQ(roles.RoleOf("1-3", {true, false}), 1);
  EXPECT_EQ(roles.RoleOf("1-3", {false, false}), 1);
  EXPECT_EQ(roles.RoleOf("1-2", {false, true}), 0);
  EXPECT_EQ(roles.RoleOf("1-4", {true, true}), std::nullopt) << "a spare";
  EXPECT_EQ(roles.RoleOf("1-4", {false, true}), 0) << "a stick that moved to another port";
}

TEST(Roles, StayWithTheirPortsOverARestart) {
  StickRoles roles({}, {HashOfPort("1-9"), HashOfPort("1-2")});
  EXPECT_EQ(roles.RoleOf("1-2", {false, false}), 1);
  EXPECT_EQ(roles.RoleOf("1-9", {false, true}), 0);
}

TEST(Roles, AreOnlyForThePortsThatTheSettingsName) {
  StickRoles roles({"1-7", ""}, {});
  EXPECT_EQ(roles.RoleOf("1-2", {false, false}), 1);
  EXPECT_EQ(roles.RoleOf("1-3", {false, true}), std::nullopt);
  EXPECT_EQ(roles.RoleOf("1-7", {false, true}), 0);
}

class Settings : public ::testing::Test {
 protected:
  Result<InputSettings> Read(const std::string& text) {
    const std::string path = file_.path() + ".toml";
    std::ofstream(path) << text;
    return ReadSettings(path);
  }
  board::BoardFile file_;
};

TEST_F(Settings, SayWhichPortPlaysWhatAndHow) {
  const auto settings = Read("[dials]\ncounts_per_turn = 94\n[stick.right]\nport = '1-4.3'\ncurve = 0.5\n");
  ASSERT_TRUE(settings) << settings.error().message();
  EXPECT_EQ(settings->counts_per_turn, 94);
  EXPECT_EQ(settings->stick_ports[1], "1-4.3");
  EXPECT_EQ(settings->sticks[1].curve, 0.5F);
  EXPECT_EQ(settings->stick_ports[0], "");
}

// A box's settings hold other programs' sections, too.
TEST_F(Settings, OfABoxAreKeptAndTheLastGoodOnesCountWhereTheyAreWrong) {
  const std::string path = file_.path() + ".box.toml", good = file_.path() + ".good.toml";
  const auto read = [&](const std::string& text) {
    std::ofstream(path) << text;
    return ReadBoxSettings(path, good);
  };
  EXPECT_EQ(ReadBoxSettings(path, good).settings.counts_per_turn, 256) << "no file: the usual ones";
  const auto first = read("profile = 'stage'\n[lines]\ngo = 0\n[dials]\ncounts_per_turn = 94\n");
  EXPECT_EQ(first.settings.counts_per_turn, 94);
  EXPECT_EQ(first.fault, "");
  const auto second = read("[dials]\ncounts_per_tern = 12\n");
  EXPECT_EQ(second.settings.counts_per_turn, 94);
  EXPECT_THAT(second.fault, HasSubstr(".box.toml:2:19: dials.counts_per_tern does not exist; the last good"));
  std::filesystem::remove(good);
  const auto third = read("[dials\n");
  EXPECT_EQ(third.settings.counts_per_turn, 256);
  EXPECT_THAT(third.fault, HasSubstr("the usual settings count"));
  std::filesystem::remove(path);
}

// A file, and lines of which one is the service key.
class TheServiceKey : public ::testing::Test {
 protected:
  TheServiceKey() { std::filesystem::remove(file_); }
  ~TheServiceKey() override { std::filesystem::remove(file_); }
  // As kaori-input writes them at `after` the beginning, or before it began.
  board::Stamped<board::Lines> Lines(bool is_on, Duration after = {},
                                     board::SourceState source = board::SourceState::kLive) const {
    board::Stamped<board::Lines> lines{{}, began_ + after, source};
    if (is_on) lines.value.active = 1U << static_cast<unsigned>(board::Line::kService);
    return lines;
  }
  // What a program that was killed has left on the board.
  board::Stamped<board::Lines> LeftBehind() const { return Lines(true, -std::chrono::hours(1)); }
  bool IsThere() const { return std::filesystem::exists(file_); }

  const Time began_ = Time{} + std::chrono::hours(5);
  const std::filesystem::path file_ =
      std::filesystem::temp_directory_path() / ("kaori-key-" + std::to_string(::getpid()));
};

TEST_F(TheServiceKey, IsAFileWhileItIsOn) {
  ServiceKey key(file_, began_);
  EXPECT_FALSE(IsThere());
  key.Step(Lines(true), began_);
  EXPECT_TRUE(IsThere());
  key.Step(Lines(false), began_);
  EXPECT_FALSE(IsThere());
  key.Step(Lines(true), began_);
  key.Step(Lines(true, {}, board::SourceState::kStale), began_);
  EXPECT_FALSE(IsThere()) << "the chip is gone";
}

TEST_F(TheServiceKey, StaysAsItWasWhileTheProgramIsStartedAnew) {
  ServiceKey(file_, began_).Step(Lines(true), began_);
  ServiceKey on(file_, began_);
  on.Step(LeftBehind(), began_ + std::chrono::seconds(2));
  EXPECT_TRUE(IsThere());
  on.Step(Lines(true, std::chrono::seconds(3)), began_ + std::chrono::seconds(3));
  on.Step(Lines(true, std::chrono::seconds(3)), began_ + std::chrono::minutes(3));
  EXPECT_TRUE(IsThere());
  ServiceKey turned(file_, began_ + std::chrono::minutes(3));
  turned.Step(Lines(false, std::chrono::minutes(3)), began_ + std::chrono::minutes(3));
  EXPECT_FALSE(IsThere()) << "it was turned meanwhile";
}

TEST_F(TheServiceKey, CountsAsOffWhereNoStartHearsOfItForTenSeconds) {
  ServiceKey(file_, began_).Step(Lines(true), began_);
  for (int s = 0; s < 10; s += 3) const ServiceKey key(file_, began_ + std::chrono::seconds(s));
  ServiceKey key(file_, began_ + std::chrono::seconds(9));
  key.Step(LeftBehind(), began_ + std::chrono::seconds(9));
  EXPECT_TRUE(IsThere());
  key.Step(LeftBehind(), began_ + ServiceKey::kUnheard);
  EXPECT_FALSE(IsThere()) << "what is on the board is not heard";
  key.Step(Lines(true, std::chrono::seconds(12)), began_ + std::chrono::seconds(12));
  EXPECT_TRUE(IsThere());
}

TEST_F(TheServiceKey, SaysByAFileThatTheStartIsOver) {
  const auto started = std::filesystem::path(file_).parent_path() / "started";
  std::filesystem::remove(started);
  ServiceKey key(file_, began_);
  key.Step(Lines(false), began_ + ServiceKey::kStart - std::chrono::milliseconds(1));
  EXPECT_FALSE(std::filesystem::exists(started));
  key.Step(Lines(false), began_ + ServiceKey::kStart);
  EXPECT_TRUE(std::filesystem::exists(started));
  EXPECT_FALSE(IsThere()) << "which is not the key";
}

TEST_F(TheServiceKey, CountsAsOffWhereEachStartEndsBeforeItsFirstStep) {
  ServiceKey(file_, began_).Step(Lines(true), began_);
  for (int s = 0; s <= 12; s += 3) const ServiceKey key(file_, began_ + std::chrono::seconds(s));
  EXPECT_FALSE(IsThere());
}

TEST_F(TheServiceKey, IsNotKeptOnByATimeThatMakesNoSense) {
  for (const char* const since : {"9223372036854775807", "-9223372036854775808", "many"}) {
    std::ofstream(file_) << since;
    const ServiceKey first(file_, began_);
    const ServiceKey second(file_, began_ + ServiceKey::kUnheard + std::chrono::seconds(1));
    EXPECT_FALSE(IsThere()) << since;
  }
}

TEST_F(Settings, NameLineAndColumnOfATypingError) {
  EXPECT_THAT(Read("[dials]\ncounts_per_tern = 94\n").error().message(),
              HasSubstr(".toml:2:19: dials.counts_per_tern does not exist"));
  EXPECT_THAT(Read("[dials]\ncounts_per_turn = 0\n").error().message(), HasSubstr("is not between 1 and"));
  EXPECT_THAT(Read("[stick.left]\ndead_zone = nan\n").error().message(),
              HasSubstr(".toml:2: a number that is not finite"));
  EXPECT_THAT(Read("[stick.left]\ncurve = 'round'\n").error().message(), HasSubstr("of the wrong kind"));
  EXPECT_THAT(Read("[stick.left\n").error().message(), HasSubstr(".toml:1: "));
  EXPECT_THAT(Read("dials = 3\n").error().message(), HasSubstr("dials"));
  EXPECT_EQ(ReadSettings("/no/such/file").error().cause, std::errc::no_such_file_or_directory);
}

}  // namespace
}  // namespace kaori::input
