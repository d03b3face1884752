// Microphones that open and send nothing, loudspeakers that play nothing, and drivers that block.
#include <algorithm>

#include <gtest/gtest.h>

#include "appliance/programs/lips/voice/speaker.h"
#include "appliance/programs/lips/voice/voice_reader.h"
#include "tests/appliance/core/board_file.h"

namespace kaori::voice {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr ports::SoundFormat kStereo{.rate_hz = 48000, .channels = 2};

class SilentMicrophone final : public ports::Microphone {
 public:
  int pollable() const override { return -1; }
  ports::SoundFormat format() const override { return kStereo; }
  Result<ports::SoundBlock> Read() override {
    return Fail(std::errc::resource_unavailable_try_again, "read the microphone");
  }
};

// Its buffer has 50 ms, and nothing of it is ever played.
class SilentLoudspeaker final : public ports::Loudspeaker {
 public:
  explicit SilentLoudspeaker(const Clock& clock) : clock_(clock) {}
  int pollable() const override { return -1; }
  ports::SoundFormat format() const override { return kStereo; }
  Result<ports::Playout> Write(std::span<const std::int16_t> samples) override {
    const std::size_t frames = std::min(samples.size() / 2, room_);
    if (frames == 0) return Fail(std::errc::resource_unavailable_try_again, "write to the loudspeaker");
    const Time at = clock_.now() + FromSeconds(static_cast<double>(kBuffer - room_) / 48000);
    room_ -= frames;
    return ports::Playout{.frames = frames, .at = at};
  }

 private:
  static constexpr std::size_t kBuffer = 2400;
  const Clock& clock_;
  std::size_t room_ = kBuffer;
};

// What opens a device, and counts it.
class SilentSound : public ::testing::Test {
 protected:
  template <class Device, class... Arguments>
  Result<std::unique_ptr<Device>> Open(const Arguments&... arguments) {
    ++opened_;
    clock_.Advance(opens_after_);
    if (failure_ != std::errc{}) return Fail(failure_, "open the device");
    return std::make_unique<Device>(arguments...);
  }
  // Gives the log.
  template <class Part>
  std::string Live(Part& part, Duration time) {
    testing::internal::CaptureStderr();
    for (const Time end = clock_.now() + time; clock_.now() < end; clock_.Advance(milliseconds(10)))
      part.Step();
    return testing::internal::GetCapturedStderr();
  }
  void ExpectFewOpeningsAndLines(const std::string& log) const {
    EXPECT_LE(opened_, 12);
    EXPECT_GE(opened_, 8);
    EXPECT_LE(std::ranges::count(log, '\n'), 4) << log;
  }

  const board::BoardFile file_;
  const board::Board board_ = file_.Open();
  ManualClock clock_;
  int opened_ = 0;
  Duration opens_after_{};
  std::errc failure_{};
  VoiceReader reader_{[this] { return Open<SilentMicrophone>(); },
                      board_.AcquireWriter<board::Voice>().value(),
                      GateSettings{},
                      clock_,
                      {}};
  Speaker speaker_{[this] { return Open<SilentLoudspeaker>(clock_); }, board_,
                   board_.AcquireWriter<board::Sound>().value(), SpeakerSettings{}, clock_};
};

TEST_F(SilentSound, OfAMicrophoneOpensItLessAndLessOften) {
  const std::string log = Live(reader_, seconds(60));
  ExpectFewOpeningsAndLines(log);
  EXPECT_NE(log.find("microphone: no sound for 2 s; the microphone is opened again"), log.npos) << log;
}

TEST_F(SilentSound, OfALoudspeakerOpensItLessAndLessOften) {
  const std::string log = Live(speaker_, seconds(60));
  ExpectFewOpeningsAndLines(log);
  EXPECT_NE(log.find("loudspeaker: the device accepts no sound; the loudspeaker is opened again"), log.npos)
      << log;
}

TEST_F(SilentSound, OfDevicesWhoseDriversBlockOpensThemSeldom) {
  failure_ = std::errc::io_error;
  opens_after_ = seconds(5);
  Live(reader_, seconds(100));
  EXPECT_LE(std::exchange(opened_, 0), 2);
  Live(speaker_, seconds(100));
  EXPECT_LE(opened_, 2);
}

}  // namespace
}  // namespace kaori::voice
