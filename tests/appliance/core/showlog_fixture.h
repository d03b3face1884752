// An evening in small, that is noted in a show log and played again.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "appliance/core/showlog/output_sum.h"
#include "appliance/core/showlog/recorder.h"
#include "appliance/core/showlog/replay.h"
#include "tests/appliance/core/performance_fixture.h"

namespace kaori::showlog {
using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.

class ShowLogTest : public performance::PerformanceTest {
 protected:
  ShowLogTest()
      : file_(std::filesystem::path(::testing::TempDir()) / fmt::format("evening-{}.kaorilog", ::getpid())) {
    Live();
    SetKnob(performance::Knob::kLife, 1);
    board_.lips.source = board_.voice.source = board::SourceState::kLive;
    show_.stick_buttons[show::kStickButtonCount + 3] = {show::CallKind::kExpression, 2};
    bytes_ = HeadBytes(head_);
  }
  ~ShowLogTest() override { std::filesystem::remove(file_); }

  // Four operators, lips and a voice, all at once; numbers as devices have them, with noise in their last bits.
  void MoveEverything(int frame) {
    const auto wave = [frame](float period) {
      return std::sin(static_cast<float>(frame) / period) * 0.6F +
             0.01F * static_cast<float>(std::rand() % 100) / 100;
    };
    board_.surface.at = board_.sticks[0].at = board_.sticks[1].at =
        now_ - 3ms - std::chrono::nanoseconds(std::rand() % 4'000'000);
    board_.sticks[0].value.x = wave(31);
    board_.sticks[0].value.y = wave(47);
    board_.sticks[1].value.x = wave(23);
    board_.sticks[1].value.y = wave(37);
    board_.surface.value.counts[static_cast<std::size_t>(frame / 60 % 8)] += frame % 7 - 3;
    if (frame % 97 == 0) Push(frame / 97 % 26);
    if (frame % 301 == 0) Strike(performance::kKey1);
    if (frame % 131 == 0) board::NotePress(board_.sticks[1].value, 3, now_);
    if (frame % 211 == 0) Make({.verb = board::CallVerb::kCue, .source = board::CallSource::kFootSwitch});
    board_.voice.at = now_ - std::chrono::nanoseconds(std::rand() % 5'000'000);
    board_.voice.value.level_db = -30 + 10 * wave(5);
    board_.voice.value.speaking = frame / 90 % 2 == 0 ? 1 : 0;
    board_.voice.value.height = 0.5F + 0.4F * wave(4);
    board_.voice.value.width = 0.5F + 0.3F * wave(7);
    board_.voice.value.quality = 0.7F + 0.2F * wave(9);
    board_.voice.value.blocks += 3;
    if (frame % 2 != 0) return;  // The camera is half as fast.
    board_.lips.at = now_ - 11ms - std::chrono::nanoseconds(std::rand() % 2'000'000);
    board_.lips.value.height = 0.5F + 0.2F * wave(6);
    board_.lips.value.width = 1 + 0.2F * wave(8);
    board_.lips.value.opening = 0.1F + 0.1F * wave(6);
    board_.lips.value.quality = 0.9F + 0.05F * wave(3);
    board_.lips.value.corners = {0.02F * wave(11), 0.02F * wave(12)};
    ++board_.lips.value.frames;
  }

  // Plays so many frames, noted; what they showed is added to shown_.
  void Play(int frames, bool changed = false) {
    for (int i = 0; i < frames; ++i) {
      if (!still_) MoveEverything(frame_);
      ++frame_;
      now_ += performance::kFrame;
      auto events = performance::ReadEvents(state_.seen, board_);
      // As the stage tells it: once for each minute.
      if (week_minute_ && week_minute_() != state_.lobby.week_minute) events.week_minute = week_minute_();
      performed_ = performance::Animate(state_, board_, events, show_, now_);
      recorder_.Note({now_, board_, state_, events, changed}, performed_);
      state_ = performed_.state;
      shown_.push_back(performed_.scene);
    }
  }

  // Puts the file on the disk and reads it.
  Result<LogFile> Read() {
    recorder_.Close();
    std::ofstream(file_, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes_.data()), static_cast<std::streamsize>(bytes_.size()));
    return LogFile::Read(file_);
  }

  LogHead head_{.show = 7, .booted_at = std::chrono::hours(24 * 20000 + 19) - 100s};
  std::vector<std::uint8_t> bytes_;
  Recorder recorder_{[this] {
    const auto chunk = recorder_.handed();
    bytes_.insert(bytes_.end(), chunk.begin(), chunk.end());
    if (write_) recorder_.Release();
  }};
  bool write_ = true;
  std::filesystem::path file_;
  int frame_ = 0;
  bool still_ = false;                           // Nobody touches anything.
  std::function<std::int32_t()> week_minute_{};  // What the wall clock says, where there is one.
  std::vector<scene::Scene> shown_;
};

}  // namespace kaori::showlog
