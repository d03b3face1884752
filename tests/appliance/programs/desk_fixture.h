// A fixture: the lips in service before a rendered operator who uses keys and buttons, in simulated time.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "appliance/core/board/board.h"
#include "appliance/core/board/press_log.h"
#include "appliance/programs/lips/service/lip_service.h"
#include "tests/appliance/core/board_file.h"
#include "tests/appliance/programs/desk_operator.h"

namespace kaori::tests {

class LipFixture {
 public:
  static constexpr std::size_t kEnter = 0x28, kEscape = 0x29, kF12 = 0x45;

  LipFixture()
      : board(file_.Open()),
        keys_(board.AcquireWriter<board::Keys>().value()),
        surface_(board.AcquireWriter<board::Surface>().value()) {
    Touch();
  }

  std::filesystem::path settings_file() const { return file_.folder() / "kept" / "lips.settings"; }
  std::filesystem::path folder() const { return file_.folder(); }

  void StartLips(bool service = true) {
    lips.reset();
    reader.reset();
    const lips::LipSettings settings = lips::SettingsFrom(settings_file());
    reader.emplace(OperatorCamera::Opener(hand, clock), board, board.AcquireWriter<board::Lips>().value(),
                   settings, clock);
    lips = lips::LipService::Open({.service = service, .file = settings_file(), .now = settings}, *reader,
                                  board, clock)
               .value();
  }

  // Lets simulated time pass in steps of 5 ms; the sections of keys and buttons are live.
  void Play(Duration time) {
    for (Duration t{}; t < time; t += std::chrono::milliseconds(5)) {
      clock.Advance(std::chrono::milliseconds(5));
      if (reader) reader->Step();
      if (lips) lips->Step();
      if (each_step) each_step();
    }
  }

  void Hold(std::size_t usage, bool down) {
    const std::uint32_t bit = 1U << (usage % 32);
    std::uint32_t& word = held_.down[usage / 32];
    word = down ? word | bit : word & ~bit;
    if (down) board::NotePress(held_, usage, clock.now());
    Touch();
  }
  void Strike(std::size_t usage) {
    Hold(usage, true);
    Play(std::chrono::milliseconds(60));
    Hold(usage, false);
  }
  void Push(std::size_t button) {
    board::NotePress(buttons_, button, clock.now());
    Touch();
  }

  // Waits, in real time, until the thread that writes to the disk has ended.
  bool AwaitSaved() {
    for (const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
         lips->tuning().saving() && std::chrono::steady_clock::now() < end; std::this_thread::yield())
      lips->Step();
    return !lips->tuning().saving();
  }

  board::Lips Seen() const { return board.Read<board::Lips>().value; }
  board::Stamped<board::LipsGuide> Guide() const { return board.Read<board::LipsGuide>(); }

 private:
  void Touch() {
    keys_.Write(held_, clock.now(), board::SourceState::kLive);
    surface_.Write(buttons_, clock.now(), board::SourceState::kLive);
  }
  board::BoardFile file_;

 public:
  ManualClock clock;
  board::Board board;
  OperatorHand hand;
  std::optional<lips::LipReader> reader;
  std::unique_ptr<lips::LipService> lips;
  std::function<void()> each_step;

 private:
  board::Writer<board::Keys> keys_;
  board::Writer<board::Surface> surface_;
  board::Keys held_;
  board::Surface buttons_;
};

}  // namespace kaori::tests
