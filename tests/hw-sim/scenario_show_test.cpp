// A show in the whole system, on a simulated clock: the lobby with its sensor, and the figures of
// out/show.json that only the whole system has (tests/appliance/show_report.py).
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <random>

#include <fmt/format.h>

#include "appliance/core/show/cue.h"
#include "appliance/core/show/pack.h"
#include "hw-sim/monitor/stage_caller.h"
#include "hw-sim/rehearsal/rehearsal.h"

namespace kaori::sim {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using board::LobbyState;

constexpr int kGoLine = 0, kPresenceLine = 3;  // As kLineNames counts.

class AShowInTheWholeSystem : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    studio_ = stage::Studio::Open(show::LoadPack(KAORI_PACK).value()).value();
    studio_->DrawOneOf(1000);  // What is drawn is looked at elsewhere.
  }
  static void TearDownTestSuite() { studio_.reset(); }

  AShowInTheWholeSystem()
      : folder_(fs::temp_directory_path() / fmt::format("kaori-show-system-{}", ::getpid())),
        rehearsal_(Rehearsal::Open({.folder = folder_,
                                    .width_px = 64,
                                    .height_px = 36,
                                    .hz = 30,
                                    .camera_width_px = 160,
                                    .camera_height_px = 120,
                                    .tick = 2ms},
                                   *studio_)
                       .value()),
        page_(rehearsal_->board().path(), rehearsal_->rig().clock()) {}
  ~AShowInTheWholeSystem() override {
    rehearsal_.reset();
    fs::remove_all(folder_);
  }

  void Run(Duration length) {
    for (const Time end = rehearsal_->now() + length; rehearsal_->now() < end;) rehearsal_->Step([](Time) {});
  }
  // The foot goes down, and up again 50 ms later.
  void Tread() {
    rehearsal_->rig().lines().Close(kGoLine);
    Run(50ms);
    rehearsal_->rig().lines().Open(kGoLine);
  }
  void Call(std::string_view line) { ASSERT_TRUE(page_.Call(line)); }
  board::ShowNow Now() const { return rehearsal_->board().Read<board::ShowNow>().value; }
  const performance::CueRun& List() const { return rehearsal_->stage().state().cue_run; }
  void SetSomebody(bool there) {
    LinePanel& lines = rehearsal_->rig().lines();
    there ? lines.Close(kPresenceLine) : lines.Open(kPresenceLine);
  }
  // The loudest of what was heard since the last call, of 32767.
  int Loudest() {
    int loudest = 0;
    for (const Loudspeaker::Heard& heard : rehearsal_->rig().loudspeaker().DrainHeard())
      for (const std::int16_t sample : heard.samples) loudest = std::max(loudest, std::abs(int{sample}));
    return loudest;
  }

  static inline std::unique_ptr<stage::Studio> studio_;
  fs::path folder_;
  std::unique_ptr<Rehearsal> rehearsal_;
  StageCaller page_;
};

TEST_F(AShowInTheWholeSystem, GreetsItsVisitorsAloudAfterThePlayAndNobodyDuringIt) {
  SetSomebody(true);
  Run(1s);
  SetSomebody(false);
  Run(5s);
  EXPECT_EQ(Now().lobby, LobbyState::kOff) << "the play is on";
  Call("goto 40");
  Run(2s);
  EXPECT_EQ(Now().lobby, LobbyState::kWaiting);
  Loudest();
  SetSomebody(true);
  Run(500ms);
  EXPECT_EQ(Now().lobby, LobbyState::kGreeting);
  Run(1500ms);
  EXPECT_GT(Loudest(), 3000);
  Run(1s);
  EXPECT_EQ(Now().lobby, LobbyState::kWith);
  SetSomebody(false);
  Run(4300ms);
  EXPECT_EQ(Now().lobby, LobbyState::kGoodbye);
  Run(65s);
  EXPECT_EQ(Now().lobby, LobbyState::kAsleep);
  SetSomebody(true);
  Run(1s);
  EXPECT_EQ(Now().lobby, LobbyState::kGreeting);
  const show::Lobby& lobby = *studio_->show().lobby;
  const auto greeting = static_cast<std::size_t>(rehearsal_->stage().state().lobby.greeting);
  EXPECT_EQ(lobby.greetings[greeting].language, "en") << "the first visitor was greeted in Japanese";
  rehearsal_->End(Program::kStage);
  Run(200ms);
  ASSERT_TRUE(rehearsal_->Start(Program::kStage));
  rehearsal_->rig().left_stick().Move(0.5, 0);
  Run(300ms);
  EXPECT_EQ(Now().lobby, LobbyState::kTakenOver) << "an operator has her at once, after a restart too";
}

TEST_F(AShowInTheWholeSystem, ShowsAGoInTheFirstPictureOrTheNext) {
  constexpr int kGos = 100;
  std::vector<Time> shown;            // When each picture began to be shown,
  std::vector<std::uint32_t> played;  // and how many GOs were played in it.
  rehearsal_->CallAfterFrames([&](const performance::State& state, const scene::Scene&, Time) {
    shown.push_back(state.last);
    played.push_back(state.cue_run.played);
  });
  std::minstd_rand chance(1);
  std::vector<std::ptrdiff_t>
      late;  // Of each GO: pictures that began to be shown after it, and before its own.
  for (std::uint32_t go = 1; go <= kGos; ++go) {
    if (go % 20 == 0) Call("standby 1");
    Run(Duration(1ms) * (350 + static_cast<int>(chance() % 33)));
    const Time called = rehearsal_->now();
    Tread();
    Run(120ms);
    const auto own = std::ranges::find(played, go) - played.begin();
    ASSERT_LT(own, std::ssize(played)) << "GO " << go << " was not played";
    late.push_back(own - (std::ranges::upper_bound(shown, called) - shown.begin()));
  }
  std::ranges::sort(late);
  const auto p99 = late[static_cast<std::size_t>(kGos * 99 / 100)];
  RecordProperty("go_to_light_frames", static_cast<int>(p99));
  EXPECT_LE(p99, 1);
  rehearsal_->CallAfterFrames({});
}

TEST_F(AShowInTheWholeSystem, LosesNoGoWhereTheStageEndsAround) {
  constexpr int kKills = 40;
  std::minstd_rand chance(2);
  const auto some_ms = [&](int most) {
    return Duration(1ms) * static_cast<int>(chance() % static_cast<unsigned>(most));
  };
  std::uint32_t sent = 0;
  for (int kill = 0; kill < kKills; ++kill) {
    if (kill % 15 == 0) Call("standby 1");
    Run(400ms + some_ms(33));
    Tread();  // Before, and perhaps not seen yet.
    ++sent;
    if (kill % 2 == 0) Run(some_ms(40));
    rehearsal_->End(Program::kStage);
    Run(400ms + some_ms(300));
    Tread();  // While nobody hears it, 0.4 s after the one before.
    ++sent;
    Run(some_ms(500));
    ASSERT_TRUE(rehearsal_->Start(Program::kStage));
    Run(100ms);
  }
  Run(500ms);
  const std::uint32_t lost = sent - List().played - List().refused;
  RecordProperty("go_lost_over_kills", static_cast<int>(lost));
  EXPECT_EQ(lost, 0U);
  EXPECT_EQ(List().refused, 0U) << "each was called 0.4 s after the one before";
}

// The bound of its time is the report's: nothing here waits for a clock.
TEST_F(AShowInTheWholeSystem, WithTwoHundredCuesIsLoadedWhole) {
  show::Show show = show::LoadPack(KAORI_PACK).value();
  auto& cues = show.cue_list.cues;
  for (int number = 1000; cues.size() < 200; ++number) {
    cues.push_back(cues[cues.size() % 40]);
    cues.back().number = std::to_string(number);
    cues.back().next = show::CueNext::kGo;
  }
  show::Track(show);
  const fs::path pack = folder_ / "long.kaori";
  ASSERT_TRUE(show::SavePack(show, pack));
  const SteadyClock clock;
  Duration fastest = 1h;
  for (int again = 0; again < 5; ++again) {
    const Time began = clock.now();
    const auto loaded = show::LoadPack(pack);
    fastest = std::min(fastest, clock.now() - began);
    ASSERT_TRUE(loaded) << loaded.error().message();
    EXPECT_EQ(loaded->cue_list.tracked.size(), 201U);
  }
  RecordProperty("load_ms_200_cues", fmt::format("{:.1f}", Seconds(fastest) * 1000));
}

}  // namespace
}  // namespace kaori::sim
