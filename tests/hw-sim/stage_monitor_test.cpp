// What the page is told of the stage, from a board that a stage has written.
#include "hw-sim/monitor/stage_monitor.h"

#include "hw-sim/monitor/midi_text.h"

#include <gtest/gtest.h>

#include "tests/hw-sim/link_fixture.h"

namespace kaori::sim {
namespace {

using namespace std::chrono_literals;

class Monitored : public ::testing::Test {
 protected:
  std::string Read() { return json::Write(monitor_.Read()); }
  void Write() {
    status_writer_.Write({.style = 2, .scene = 3}, clock_.now(), board::SourceState::kLive);
    show_writer_.Write(show_, clock_.now(), board::SourceState::kLive);
  }
  // The file is looked for once a second.
  std::string ReadInASecond() {
    clock_.Advance(1s);
    Write();
    static_cast<void>(Read());
    return Read();
  }

  ManualClock clock_{Time{} + 100s};
  TempFolder folder_;
  std::string path_ = folder_.path() + "/board";
  board::Board board_ = board::Board::Create(path_).value();
  board::Writer<board::StageStatus> status_writer_ = board_.AcquireWriter<board::StageStatus>().value();
  board::Writer<board::ShowNow> show_writer_ = board_.AcquireWriter<board::ShowNow>().value();
  board::ShowNow show_{.cue_active = 4,
                       .cue_standby = 6,
                       .cue_pending = 5,
                       .cue_left_s = 1.23F,
                       .cue_state = board::kCuesPaused | board::kCuesWaiting,
                       .gos_refused = 7,
                       .sheet = 1,
                       .levels = {{{0.25F, board::LevelOwner::kRole, 2}}},
                       .role_devices = {1, 0, 3}};
  StageMonitor monitor_{path_, clock_};
};

TEST_F(Monitored, IsToldAsThePageReadsIt) {
  const std::string told = ReadInASecond();
  EXPECT_TRUE(told.starts_with(
      R"({"scene":3,"style":2,"cue":4,"standby":6,"pending":5,"left_s":1.3,"paused":true,)"
      R"("panicking":false,"black":false,"waiting":true,"refused":7,"sheet":1,"levels":[[0.25,3,2],[0.0,0,0],)"))
      << told;
  EXPECT_TRUE(told.ends_with(R"("role_devices":[1,0,3,0,0,0,0,0],"motions":[],"midi":[]})")) << told;
  show_.cue_state = board::kCuesPanicking | board::kCuesBlack;
  EXPECT_NE(ReadInASecond().find(R"("paused":false,"panicking":true,"black":true,"waiting":false)"),
            std::string::npos);
}

TEST_F(Monitored, SaysInWordsWhatTheLobbyDoesAndNothingWhereThereIsNone) {
  EXPECT_NE(ReadInASecond().find(R"("lobby":"","lobby_hours":"")"), std::string::npos);
  show_.lobby = board::LobbyState::kTakenOver;
  show_.lobby_hours = board::LobbyHours::kClockUnknown;
  EXPECT_NE(ReadInASecond().find(
                R"("lobby":"taken over","lobby_hours":"The time of day is not known: no opening hours")"),
            std::string::npos);
}

TEST_F(Monitored, TellsOfALineCheckInWordsAndOfNoneThatEndedWithItsStage) {
  EXPECT_NE(ReadInASecond().find(R"("check":null,)"), std::string::npos);
  board::LineCheck check{.phase = board::LineCheckPhase::kRunning, .count = 1};
  check.items[0] = {.kind = board::CheckedKind::kAxis, .number = 1, .state = board::CheckedState::kStuck};
  auto writer = board_.AcquireWriter<board::LineCheck>().value();
  writer.Write(check, clock_.now() + 1s, board::SourceState::kLive);
  EXPECT_NE(ReadInASecond().find(R"("check":{"running":true,"summary":"0 of 1 work; left stick y stuck",)"
                                 R"("items":[["left stick","y stuck",2]]})"),
            std::string::npos)
      << Read();
  ASSERT_NE(ReadInASecond(), "null");
  ASSERT_NE(ReadInASecond(), "null");
  EXPECT_NE(ReadInASecond().find(R"("check":null,)"), std::string::npos);
}

TEST_F(Monitored, TellsWhatIsLearntInWordsWhileSomebodyTeaches) {
  EXPECT_NE(ReadInASecond().find(R"("learn":null,)"), std::string::npos);
  board::Learn learn{.phase = board::LearnPhase::kFound, .choice = 8, .inverted = 1};
  learn.found = {.kind = board::CheckedKind::kDial, .device = 2, .number = 2};
  auto writer = board_.AcquireWriter<board::Learn>().value();
  writer.Write(learn, clock_.now() + 1s, board::SourceState::kLive);
  EXPECT_NE(
      ReadInASecond().find(R"("learn":{"phase":2,"choice":8,"control":"dial box dial 3","inverted":true,)"
                           R"("instead":false,"restless":"","ambiguous":false,"counts":0})"),
      std::string::npos)
      << Read();
  learn.phase = board::LearnPhase::kEnded;
  writer.Write(learn, clock_.now(), board::SourceState::kLive);
  EXPECT_NE(ReadInASecond().find(R"("learn":null,)"), std::string::npos);
}

TEST_F(Monitored, TellsWhichMotionsPlayAndSinceWhen) {
  show_.motions[3] = {.motion = 2, .at_s = 1.26F};
  show_.motions[5] = {.motion = 0, .at_s = 0.5F, .ends = 1};
  EXPECT_NE(ReadInASecond().find(R"("motions":[[2,1.2,false],[0,0.5,true]])"), std::string::npos) << Read();
}

TEST_F(Monitored, TellsTheLastMidiMessagesInWordsWithWhatTheyAreFor) {
  auto writer = board_.AcquireWriter<board::MidiHeard>().value();
  board::MidiHeard heard{.count = 18};
  constexpr std::uint32_t kNone = board::MidiHeard::kNothing;
  heard.newest[0] = {.device = 0x139700B3, .bytes = 0x4015B0, .meant = 2 | kNone << 8U};
  heard.newest[1] = {.device = 0x139700B3, .bytes = 0x64249A, .meant = kNone | 4 << 8U};
  writer.Write(heard, clock_.now(), board::SourceState::kLive);
  const std::string told = ReadInASecond();
  EXPECT_NE(told.find(R"("midi":[[2,)"), std::string::npos) << "the oldest that is kept: " << told;
  EXPECT_TRUE(told.ends_with(R"([16,"1397:00b3","CC 21 = 64",2,-1],)"
                             R"([17,"1397:00b3","channel 11: note 36 on, velocity 100",-1,4]]})"))
      << told;
}

TEST_F(Monitored, SaysEachKindOfMidiMessageInItsWords) {
  const auto words = [](std::uint32_t bytes) { return MidiText(board::MidiHeard::Message{.bytes = bytes}); };
  EXPECT_EQ(words(0x002480), "note 36 off");
  EXPECT_EQ(words(0x002490), "note 36 off") << "a velocity of 0";
  EXPECT_EQ(words(0x0524A0), "note 36 pressed 5");
  EXPECT_EQ(words(0x0005C0), "program 5");
  EXPECT_EQ(words(0x0005D0), "channel pressed 5");
  EXPECT_EQ(words(0x4000E0), "pitch bend 8192");
}

TEST_F(Monitored, IsNothingWhileNoStageDraws) {
  EXPECT_EQ(Read(), "null") << "nobody has written";
  ASSERT_NE(ReadInASecond(), "null");
  clock_.Advance(3s);
  EXPECT_EQ(Read(), "null") << "a stage that is silent";
}

}  // namespace
}  // namespace kaori::sim
