// MIDI surfaces that people own, by their simulated twins and by the files that ship.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "drivers/midi/midi_bus.h"
#include "hw-sim/devices/midi_twin.h"
#include "tests/appliance/programs/input_owned_fixture.h"
#include "tests/appliance/programs/input_turn_lesson.h"

namespace kaori::input {
namespace {

namespace fs = std::filesystem;
using board::SourceState;
using std::chrono::milliseconds;
using ::testing::HasSubstr;

// A MIDI surface at a terminal, in folders that look like the kernel's.
class MidiSurfaces : public OwnedDevices {
 protected:
  void PlugMidi(const char* vendor, const char* product) {
    const fs::path usb = file_.folder() / "devices/usb1/1-4";
    fs::create_directories(usb / "1-4:1.0/sound/card1/midiC1D0");
    fs::create_directories(file_.folder() / "class");
    fs::create_directories(file_.folder() / "snd");
    std::ofstream(usb / "idVendor") << vendor << '\n';
    std::ofstream(usb / "idProduct") << product << '\n';
    fs::create_directory_symlink(usb / "1-4:1.0/sound/card1/midiC1D0", file_.folder() / "class/midiC1D0");
    cable_ = UniqueFd(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    ASSERT_EQ(::unlockpt(cable_.get()), 0);
    std::array<char, 64> name{};
    ASSERT_EQ(::ptsname_r(cable_.get(), name.data(), name.size()), 0);
    end_ = UniqueFd(::open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC));
    termios mode{};
    ASSERT_EQ(::tcgetattr(end_.get(), &mode), 0);
    ::cfmakeraw(&mode);
    ASSERT_EQ(::tcsetattr(end_.get(), TCSANOW, &mode), 0);
    fs::create_symlink(name.data(), file_.folder() / "snd/midiC1D0");
  }
  void StartMidi() {
    for (const SurfaceMap& map : maps_)
      for (const auto& id : map.usb)
        if (map.midi)
          known_.push_back({.name = map.name, .vendor = id.vendor, .product = id.product, .map = *map.midi});
    midi_ = midi::MidiBus::Open({.nodes = file_.folder() / "snd",
                                 .classes = file_.folder() / "class",
                                 .look_every = milliseconds(1)},
                                known_, clock_, &tap_)
                .value();
    service_.emplace(board_, InputWriters::Acquire(board_).value(),
                     InputSources{.buses = {midi_.get()},
                                  .lines = {},
                                  .maps = maps_,
                                  .midi = &tap_,
                                  .turns = file_.folder() / "turns.toml"},
                     settings_, clock_);
  }
  // The kernel passes a terminal's bytes on by itself.
  void PlayMidi(sim::MidiTwin& twin, int steps) {
    for (int n = 0; n < steps; ++n) {
      clock_.Advance(milliseconds(1));
      const auto said = twin.Send();
      if (!said.empty()) {
        ASSERT_EQ(::write(cable_.get(), said.data(), said.size()), static_cast<ssize_t>(said.size()));
        pollfd arrives{.fd = end_.get(), .events = POLLIN, .revents = 0};
        ::poll(&arrives, 1, 300);
      }
      service_->Step();
      pollfd answers{.fd = cable_.get(), .events = POLLIN, .revents = 0};
      ::poll(&answers, 1, 1);
      std::array<std::uint8_t, 512> heard;
      const ssize_t got = ::read(cable_.get(), heard.data(), heard.size());
      if (got > 0) twin.Receive(std::span(heard).first(static_cast<std::size_t>(got)));
    }
  }

  // Bytes as they are, without a twin.
  void Say(std::vector<std::uint8_t> bytes) {
    ASSERT_EQ(::write(cable_.get(), bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
    pollfd arrives{.fd = end_.get(), .events = POLLIN, .revents = 0};
    ::poll(&arrives, 1, 300);
    clock_.Advance(milliseconds(5));
    service_->Step();
  }

  ports::MidiTap tap_;
  UniqueFd cable_;
  UniqueFd end_;
  std::vector<midi::KnownSurface> known_;
  std::unique_ptr<midi::MidiBus> midi_;
};

TEST_F(MidiSurfaces, WhatTheFileSaysOfATurnIsMendedByALesson) {
  sim::MidiTwin twister(sim::MidiTwin::Kind::kTwister);
  PlugMidi("2580", "0007");
  StartMidi();
  PlayMidi(twister, 10);
  twister.Turn(0, 48);
  PlayMidi(twister, 5);
  ASSERT_EQ(Board().surface.value.counts[0], 128) << "the file says 96 of a turn";
  TurnLesson lesson(board_);
  EXPECT_EQ(lesson.Keep(0, 128, clock_.now(), [&] { PlayMidi(twister, 5); }), board::LearnCall::kTurnKept);
  twister.Turn(0, 48);
  PlayMidi(twister, 5);
  EXPECT_EQ(Board().surface.value.counts[0], 128 + 256) << "encoders of another make were built in";
}

TEST_F(MidiSurfaces, ATwisterIsPutIntoItsModeAndItsEncodersTurnDials) {
  sim::MidiTwin twister(sim::MidiTwin::Kind::kTwister);
  RecordProperty("twin", "Midi Fighter Twister");
  PlugMidi("2580", "0007");
  StartMidi();
  PlayMidi(twister, 10);
  ASSERT_EQ(service_->attached_devices(), 1);
  twister.Turn(0, 96);
  twister.Turn(7, -48);
  twister.Push(5, true);
  PlayMidi(twister, 5);
  EXPECT_EQ(Board().surface.value.counts[0], 256);
  EXPECT_EQ(Board().surface.value.counts[7], -128);
  EXPECT_EQ(Board().surface.value.buttons_down, 1U << 5U);
  twister.Push(5, false);
  auto stage = board_.AcquireWriter<board::Lamps>().value();
  stage.Write({.lit = 0x12}, clock_.now(), SourceState::kLive);
  PlayMidi(twister, 5);
  EXPECT_EQ(Board().surface.value.buttons_down, 0U);
  EXPECT_TRUE(twister.lamp(1) && twister.lamp(4));
  EXPECT_FALSE(twister.lamp(0));
}

TEST_F(MidiSurfaces, EachMessageIsOnTheBoardWithWhatItIsFor) {
  PlugMidi("1397", "00b3");
  StartMidi();
  Say({});
  ASSERT_EQ(service_->attached_devices(), 1);
  Say({0xBA, 1, 64, 0x9A, 8, 127, 0xC0, 7, 0xB3, 99, 1});
  const auto heard = board_.Read<board::MidiHeard>();
  ASSERT_EQ(heard.source, SourceState::kLive);
  ASSERT_EQ(heard.value.count, 4U);
  const auto& newest = heard.value.newest;
  constexpr std::uint32_t kNone = board::MidiHeard::kNothing;
  EXPECT_EQ(newest[0].device, 0x139700B3U);
  EXPECT_EQ(newest[0].bytes, 0x4001BAU);
  EXPECT_EQ(newest[0].meant, 0U | kNone << 8U) << "the first dial, though its first value turns nothing";
  EXPECT_EQ(newest[1].bytes, 0x7F089AU);
  EXPECT_EQ(newest[1].meant, kNone | 0U << 8U);
  EXPECT_EQ(newest[2].bytes, 0x0007C0U) << "a message of one byte has no value";
  EXPECT_EQ(newest[2].meant, kNone | kNone << 8U);
  EXPECT_EQ(newest[3].meant, kNone | kNone << 8U) << "no dial of this surface";
}

TEST_F(MidiSurfaces, OfAFloodTheNewestMessagesAreOnTheBoard) {
  PlugMidi("1397", "00b3");
  StartMidi();
  Say({});
  for (std::uint8_t n = 0; n < 40; ++n) Say({0xBA, 1, n, 0xBA, 2, n});
  const board::MidiHeard heard = board_.Read<board::MidiHeard>().value;
  EXPECT_EQ(heard.count, 80U);
  EXPECT_EQ(heard.newest[79 % board::MidiHeard::kKept].bytes, 0x2702BAU);
}

TEST_F(MidiSurfaces, AnXTouchMinisDeadEndsTurnNothingAndItsLampsAreShownAgain) {
  RecordProperty("twin", "X-Touch Mini");
  sim::MidiTwin touch(sim::MidiTwin::Kind::kXTouchMini);
  PlugMidi("1397", "00b3");
  StartMidi();
  PlayMidi(touch, 10);
  touch.Turn(3, 1);  // Where it stands is not known before.
  touch.Turn(3, 126);
  touch.Turn(3, 50);
  touch.Push(15, true);
  PlayMidi(touch, 5);
  EXPECT_EQ(Board().surface.value.counts[3], 126 * 256 / 127);
  EXPECT_EQ(Board().surface.value.buttons_down, 1U << 15U);
  auto stage = board_.AcquireWriter<board::Lamps>().value();
  stage.Write({.lit = 0x8000}, clock_.now(), SourceState::kLive);
  PlayMidi(touch, 5);
  EXPECT_TRUE(touch.lamp(15));
  touch.ForgetLamps();
  clock_.Advance(std::chrono::seconds(1));
  PlayMidi(touch, 3);
  EXPECT_TRUE(touch.lamp(15));
}

TEST_F(MidiSurfaces, OneWithoutAFilePlaysFromItsFirstMessageOnAndIsNamedOnceByItsIds) {
  sim::MidiTwin other(sim::MidiTwin::Kind::kXTouchMini);
  PlugMidi("0582", "0000");
  StartMidi();
  ::testing::internal::CaptureStderr();
  PlayMidi(other, 300);
  EXPECT_EQ(service_->attached_devices(), 0) << "it has said nothing: it may be a sound card's socket";
  other.Turn(3, 1);
  PlayMidi(other, 300);
  EXPECT_EQ(service_->attached_devices(), 1);
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_THAT(said,
              HasSubstr("the MIDI device 0582:0000 at 1-4 has no file of its own: its controls are dials"));
  EXPECT_EQ(said.find("no file"), said.rfind("no file")) << said;
  const auto before = Board().surface.value;
  other.Turn(3, 1);
  other.Turn(3, 20);
  other.Push(15, true);
  PlayMidi(other, 10);
  const auto turned = Board().surface.value.counts;
  EXPECT_EQ(std::ranges::count_if(turned, [](std::int32_t counts) { return counts != 0; }), 1) << "one dial";
  EXPECT_NE(Board().surface.value.buttons_down, before.buttons_down);
  other.Push(15, false);
  PlayMidi(other, 10);
  EXPECT_EQ(Board().surface.value.buttons_down, before.buttons_down);
}

TEST(SurfaceMaps, EverythingThatIsWrongIsSaidAtOnceWithItsLine) {
  board::BoardFile file;
  std::ofstream(file.folder() / "a.toml")
      << "name = \"A\"\nusb = [\"12345:1\"]\ndials = [9]\n[midi]\nstart = \"F0 xx\"\n"
         "[[midi.dial]]\ncontrol = 200\nmode = \"odd\"\n[[midi.button]]\nlamp = true\n";
  std::ofstream(file.folder() / "b.toml") << "name = \"B\"\nusb = [\"1234:0001\"]\n";
  std::ofstream(file.folder() / "c.toml") << "name = \"C\"\nusb = [\"1234:0001\"]\n";
  std::vector<SurfaceMap> maps;
  const auto wrong = ReadSurfaceMaps(file.folder(), maps);
  ASSERT_EQ(wrong.size(), 7U) << ::testing::PrintToString(wrong);
  EXPECT_THAT(wrong[0], HasSubstr("a.toml:2: usb: \"12345:1\" is no id such as 077d:0410"));
  EXPECT_THAT(wrong[1], HasSubstr("a.toml:3: dials: 9 is not one of 0 (none) to 8"));
  EXPECT_THAT(wrong[6], HasSubstr("c.toml:2: usb: 1234:0001 is the B already"));
  EXPECT_EQ(maps.size(), 1U);
}

}  // namespace
}  // namespace kaori::input
