// Sound and mouth meet in real time, too: the real programs, devices in this process, and the machine's own
// clock.
#include <gtest/gtest.h>
#include <poll.h>

#include <thread>

#include <fmt/format.h>

#include "appliance/core/board/board.h"
#include "tests/appliance/programs/voice_claps.h"
#include "tests/system/program_runner.h"

namespace kaori::test {
namespace {

using namespace std::chrono_literals;

constexpr Duration kScreenPeriod = 33'333'333ns;  // What a machine without a GPU keeps.
constexpr int kClaps = 11;
constexpr std::uint32_t kMostLate = 25;  // Of some 330 frames, and of chunks of sound.

class SoundInRealTime : public ::testing::Test {
 protected:
  SoundInRealTime()
      : rig_(sim::Rig::Open({.folder = programs_.links(),
                             .screen_width_px = 128,
                             .screen_height_px = 72,
                             .screen_period = kScreenPeriod,
                             .camera_period = kScreenPeriod / 2,
                             .wakes_by_timer = true},
                            clock_)
                 .value()) {
    const std::vector<std::string> both{"--board", programs_.board(), "--links", programs_.links()};
    for (const char* program : {"kaori-input", "kaori-lips"}) programs_.Start(program, both);
    std::vector<std::string> stage = both;
    stage.insert(stage.end(),
                 {"--pack", (ProgramRunner::Programs().parent_path() / "shows" / "kaori.kaori").string()});
    programs_.Start("kaori-stage", stage);
  }

  // Pumps the devices and calls `act` until `done`. Returns false after a minute.
  template <class Act, class Done>
  bool Until(Act act, Done done) {
    for (const Time late = clock_.now() + 60s; !done();) {
      if (clock_.now() > late) return false;
      act(clock_.now());
      rig_->Pump();
      pollfd waiting{rig_->pollable(), POLLIN, 0};
      ::poll(&waiting, 1, 2);
    }
    return true;
  }
  bool Wait(Duration time) {
    return Until([](Time) {}, [end = clock_.now() + time, this] { return clock_.now() >= end; });
  }

  SteadyClock clock_;
  ProgramRunner programs_;
  std::unique_ptr<sim::Rig> rig_;
};

TEST_F(SoundInRealTime, MeetsTheMouth) {
  const auto board = board::Board::Create(programs_.board()).value();
  ASSERT_TRUE(Until([](Time) {},
                    [&] {
                      return rig_->screen().frames_shown() > 30 &&
                             board.Read<board::Lips>().value.rest_width > 0 &&
                             board.Read<board::Voice>().source == board::SourceState::kLive &&
                             board.Read<board::Sound>().source == board::SourceState::kLive;
                    }))
      << programs_.LogOf("kaori-lips") << programs_.LogOf("kaori-stage");
  rig_->dial_box().Turn(6, -1);
  tests::Claps first(*rig_, clock_.now() + 500ms, 4);
  const auto move = [](tests::Claps& claps) {
    return [&claps](Time now) {
      claps.Move(now);
      claps.Watch();
    };
  };
  ASSERT_TRUE(Until(move(first), [&] { return clock_.now() > first.end(); }));
  const std::uint32_t missed = board.Read<board::StageStatus>().value.missed_flips;
  const std::uint32_t dry = board.Read<board::Sound>().value.xruns;
  tests::Claps claps(*rig_, clock_.now() + 700ms, kClaps);
  ASSERT_TRUE(Until(move(claps), [&] { return clock_.now() > claps.end(); }));
  const auto status = board.Read<board::StageStatus>().value;
  const auto sound = board.Read<board::Sound>().value;
  tests::ClapReport report{claps.Measured(), Seconds(status.lips_age) * 1e3,
                           static_cast<double>(sound.delay_ms)};
  for (const auto& clap : report.claps)
    fmt::print("picture {:5.1f} ms, sound {:5.1f} ms: {:+5.1f} ms\n", clap.picture_ms, clap.sound_ms,
               clap.apart_ms());
  const std::uint32_t late = status.missed_flips - missed + sound.xruns - dry;
  fmt::print(
      "lips {:.1f} ms old in the light, delay {:.1f} ms; median {:+.1f} ms, worst {:.1f} ms; {} came late\n",
      report.lips_age_ms, report.delay_ms, report.median_apart_ms(), report.worst_apart_ms(), late);
  // A machine that has no time for the programs tells nothing of them. Of a single clap a neighbour may take
  // the processor away, and most of them are as they should be.
  if (late > kMostLate)
    GTEST_SKIP() << "the machine was too busy: " << late << " frames or sounds came late; median "
                 << report.median_apart_ms() << " ms, worst " << report.worst_apart_ms() << " ms";
  ASSERT_GE(report.claps.size(), static_cast<std::size_t>(kClaps - 2)) << "each was seen and heard";
  EXPECT_LE(std::abs(report.median_apart_ms()), 15);
}

TEST_F(SoundInRealTime, TheDelayIsSaidInTheLog) {
  ASSERT_TRUE(Until([](Time) {},
                    [&] { return programs_.LogOf("kaori-lips").find("as measured") != std::string::npos; }))
      << programs_.LogOf("kaori-lips");
}

}  // namespace
}  // namespace kaori::test
