// Scenarios on a rig: the same actions give the same bytes, and a recording gives them again.
#include <random>

#include "hw-sim/scenario/player.h"
#include "hw-sim/scenario/reader.h"
#include "hw-sim/scenario/recorder.h"
#include "hw-sim/scenario/writer.h"
#include "tests/hw-sim/link_fixture.h"

namespace kaori::sim {
namespace {

using namespace std::chrono_literals;

constexpr Duration kStep = 4ms;
constexpr std::array<const char*, 5> kPorts{"dial-box", "stick-left", "stick-right", "keyboard", "pointer"};

struct Performance {
  std::array<std::vector<StampedReport>, kPorts.size()> reports;  // Of each HID device,
  std::vector<Mouth> mouths;                                      // and the mouth at each step.
  std::string recording;
  friend bool operator==(const Performance&, const Performance&) = default;
};

// A rig on which one scenario is played from the first to the last moment.
class Hall : public LinkFixture {
 public:
  void TestBody() override {}

  Performance Play(const Scenario& scenario) {
    SetUp();
    std::array<std::unique_ptr<ports::HidChannel>, kPorts.size()> channels;
    for (std::size_t n = 0; n < kPorts.size(); ++n) channels[n] = Channel(kPorts[n]);
    Recorder recorder(*rig);
    Player player(scenario, *rig, clock.now());
    Performance performance;
    for (const Time end = clock.now() + scenario.length + 100ms; clock.now() <= end; clock.Advance(kStep)) {
      player.Perform(clock.now());
      rig->Pump();
      performance.mouths.push_back(rig->camera().mouth());
      for (std::size_t n = 0; n < kPorts.size(); ++n) Listen(kPorts[n], channels[n], performance.reports[n]);
    }
    EXPECT_TRUE(player.finished());
    performance.recording = WriteScenario(recorder.scenario());
    return performance;
  }

 private:
  // Reads what came; a device that was plugged in again is opened again.
  void Listen(const char* port, std::unique_ptr<ports::HidChannel>& channel,
              std::vector<StampedReport>& reports) {
    if (!rig->plugged(port)) channel.reset();
    if (!channel) channel = rig->plugged(port) ? Channel(port) : nullptr;
    if (!channel) return;
    for (auto& report : ReadAll(*channel)) reports.push_back(std::move(report));
  }
};

Scenario Load(const char* name) {
  auto loaded = LoadScenario(std::string(KAORI_PLAYS) + "/" + name + ".play");
  EXPECT_TRUE(loaded) << (loaded ? "" : loaded.error().attempt);
  return loaded ? *loaded : Scenario{};
}

TEST(Scenario, GivesTheSameBytesAtTheSameTimesTwice) {
  const Scenario warm_up = Load("warm-up");
  const Performance first = Hall().Play(warm_up);
  for (std::size_t n = 0; n < kPorts.size(); ++n) EXPECT_GT(first.reports[n].size(), 8u) << kPorts[n];
  EXPECT_EQ(first, Hall().Play(warm_up));
}

TEST(Scenario, ARecordingReplayedGivesTheSameBytes) {
  const Performance first = Hall().Play(Load("warm-up"));
  const Reading recording = ReadScenario(first.recording);
  ASSERT_EQ(Describe(recording.problems, "recording"), "");
  const Performance again = Hall().Play(recording.scenario);
  EXPECT_EQ(first.recording, again.recording);
  for (std::size_t n = 0; n < kPorts.size(); ++n) EXPECT_EQ(first.reports[n], again.reports[n]) << kPorts[n];
}

TEST(Scenario, RandomActionsRecordedAndReplayedGiveTheSameBytes) {
  std::mt19937 random(2026);
  const auto real = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() % 100003) / 100003.0;
  };
  Scenario scenario;
  for (Duration at{}; at < 4s; at += Duration(random() % 7'000'000)) {
    const auto stick = random() % 2 == 0 ? DevicePort::kStickLeft : DevicePort::kStickRight;
    const int kind = static_cast<int>(random() % 11);
    const Verb down = random() % 2 == 0 ? Verb::kPush : Verb::kRelease;
    if (kind == 0)
      scenario.actions.push_back(
          {at, {}, {DevicePort::kDialBox, Verb::kTurn, static_cast<int>(random() % 8), real(-1, 1), 0}});
    if (kind == 1)
      scenario.actions.push_back(
          {at, {}, {DevicePort::kDialBox, down, static_cast<int>(random() % 32), 0, 0}});
    if (kind == 2) scenario.actions.push_back({at, {}, {stick, Verb::kMove, 0, real(-1, 1), real(-1, 1)}});
    if (kind == 3)
      scenario.actions.push_back({at, {}, {stick, Verb::kHat, static_cast<int>(random() % 9) - 1, 0, 0}});
    if (kind == 4) scenario.actions.push_back({at, {}, {stick, down, static_cast<int>(random() % 12), 0, 0}});
    if (kind == 5)
      scenario.actions.push_back(
          {at, {}, {DevicePort::kKeyboard, down, static_cast<int>(4 + random() % 100), 0, 0}});
    if (kind == 6)
      scenario.actions.push_back({at, {}, {DevicePort::kCamera, Verb::kLips, 0, real(0, 1), real(0.5, 1.5)}});
    if (kind == 7)
      scenario.actions.push_back({at, {}, {DevicePort::kPointer, Verb::kMove, 0, real(0, 1), real(0, 1)}});
    if (kind == 8)
      scenario.actions.push_back({at, {}, {DevicePort::kPointer, Verb::kRoll, 0, real(-9, 9), 0}});
    if (kind == 9)
      scenario.actions.push_back(
          {at, {}, {DevicePort::kPointer, down, static_cast<int>(random() % 3), 0, 0}});
    if (kind == 10)
      scenario.actions.push_back({at, {}, {DevicePort::kLines, down, static_cast<int>(random() % 4), 0, 0}});
  }
  PutInOrder(scenario);
  const Performance first = Hall().Play(scenario);
  Scenario recorded = ReadScenario(first.recording).scenario;
  recorded.length = scenario.length;  // The last actions may have changed nothing, and were not recorded.
  const Performance again = Hall().Play(recorded);
  EXPECT_GT(first.reports[0].size(), 100u);
  EXPECT_EQ(first.recording, again.recording);
  EXPECT_EQ(first.reports, again.reports);
  EXPECT_EQ(first.mouths, again.mouths);
}

class PlayerTest : public LinkFixture {
 protected:
  void Play(std::string_view text) {
    Reading reading = ReadScenario(text);
    ASSERT_EQ(Describe(reading.problems, "t"), "");
    player.emplace(std::move(reading.scenario), *rig, clock.now());
    start = clock.now();
  }
  void PerformAt(Duration position) {
    clock.Advance(start + position - clock.now());
    player->Perform(clock.now());
  }

  std::optional<Player> player;
  Time start;
};

TEST_F(PlayerTest, EasesInAndOut) {
  Play("at 1s over 1s left move 0.8 -0.4");
  PerformAt(1s);
  EXPECT_EQ(rig->left_stick().x(), 0);
  PerformAt(1100ms);
  EXPECT_LT(rig->left_stick().x(), 0.08F);
  PerformAt(1500ms);
  EXPECT_NEAR(rig->left_stick().x(), 0.4F, 1e-6);
  EXPECT_NEAR(rig->left_stick().y(), -0.2F, 1e-6);
  PerformAt(2s);
  EXPECT_EQ(rig->left_stick().x(), 0.8F);
  EXPECT_TRUE(player->finished());
}

TEST_F(PlayerTest, DragsThePointerFromWhereItStands) {
  Play("at 0s pointer 0.2 0.9\nat 0.5s press pointer\nat 1s over 1s pointer 0.6 0.5\nat 2s release pointer");
  PerformAt(1500ms);
  EXPECT_NEAR(rig->pointer().x(), 0.4, 1e-9);
  EXPECT_NEAR(rig->pointer().y(), 0.7, 1e-9);
  EXPECT_EQ(rig->pointer().buttons_down(), 1);
  PerformAt(2s);
  EXPECT_EQ(rig->pointer().x(), 0.6);
  EXPECT_EQ(rig->pointer().buttons_down(), 0);
}

TEST_F(PlayerTest, ADialTurnedSlowlyTurnsAllTheWay) {
  Play("at 0s over 1s dial 1 turn 0.4\nat 0.5s over 1s dial 1 turn 0.6");
  for (Duration at{}; at <= 1500ms; at += 7ms) PerformAt(at);
  PerformAt(1500ms);
  EXPECT_NEAR(rig->dial_box().turned(0), 1.0, 1e-9);
}

TEST_F(PlayerTest, ANewHandTakesAControlOver) {
  Play("at 0s over 2s lips 1 1\nat 1s over 0.5s lips 0.25 1");
  PerformAt(1s);
  EXPECT_NEAR(rig->camera().mouth().height, 0.625, 1e-9);
  PerformAt(1500ms);
  EXPECT_EQ(rig->camera().mouth().height, 0.25);
  PerformAt(2s);
  EXPECT_EQ(rig->camera().mouth().height, 0.25);
}

TEST_F(PlayerTest, CoarseStepsEndWhereFineOnesDo) {
  Play("at 0s over 1s left twist 1\nat 0.5s over 0.1s left twist 0.25\nat 0.8s push 3");
  PerformAt(5s);
  EXPECT_EQ(rig->left_stick().twist(), 0.25F);
  EXPECT_EQ(rig->dial_box().buttons_down(), 0u);
}

TEST_F(PlayerTest, NamesTheSceneThatPlays) {
  Play("scene one\nat 1s push 1\nscene two\nat 2s push 2");
  PerformAt(0s);
  EXPECT_EQ(player->beat(), "");
  PerformAt(1s);
  EXPECT_EQ(player->beat(), "one");
  PerformAt(3s);
  EXPECT_EQ(player->beat(), "two");
}

TEST_F(PlayerTest, PlaysAgainFromTheBeginning) {
  Play("at 0.5s dial 1 turn 1");
  PerformAt(1s);
  EXPECT_TRUE(player->finished());
  player->Restart(clock.now());
  EXPECT_FALSE(player->finished());
  start = clock.now();
  PerformAt(1s);
  EXPECT_EQ(rig->dial_box().turned(0), 2);
}

TEST_F(PlayerTest, DoesNothingBeforeItsTime) {
  Play("at 0s push 1");
  player->Perform(start - 1ms);
  EXPECT_EQ(rig->dial_box().buttons_down(), 0u);
}

}  // namespace
}  // namespace kaori::sim
