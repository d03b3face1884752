// A fake sound device: it answers the calls, and does what a test tells it to.
#pragma once

#include <algorithm>
#include <cerrno>
#include <deque>
#include <utility>
#include <vector>

#include "drivers/audio/alsa_pcm.h"

namespace kaori::tests {

// The test's side. It must outlive the PCMs that are opened on it.
struct FakeSound {
  ports::SoundFormat format;
  std::deque<std::int16_t> heard;    // Waits to be read.
  std::vector<std::int16_t> played;  // What was taken.
  std::size_t room_frames = 480;
  std::optional<Time> stamp;
  long delay_frames = 0;
  long failing = 0;        // What Read and Write answer, when not 0.
  int prepare_answer = 0;  // Else the trouble is over.
  int resume_answer = -ENOSYS;
  int opened = 0, started = 0, prepared = 0, closed = 0;
};

class FakePcm final : public audio::AlsaPcm {
 public:
  explicit FakePcm(FakeSound& sound) : sound_(sound) { ++sound_.opened; }
  ~FakePcm() override { ++sound_.closed; }
  ports::SoundFormat format() const override { return sound_.format; }
  int pollable() const override { return -1; }
  int Start() override { return ++sound_.started, 0; }
  int Prepare() override { return ++sound_.prepared, Mend(sound_.prepare_answer); }
  int Resume() override { return Mend(sound_.resume_answer); }
  int Status(audio::PcmStatus& into) override {
    into = {sound_.stamp, sound_.delay_frames};
    return 0;
  }
  long Read(std::span<std::int16_t> into) override {
    if (sound_.failing != 0) return sound_.failing;
    const std::size_t count = std::min(into.size(), sound_.heard.size());
    std::copy_n(sound_.heard.begin(), count, into.begin());
    sound_.heard.erase(sound_.heard.begin(), sound_.heard.begin() + static_cast<std::ptrdiff_t>(count));
    return count == 0 ? -EAGAIN : static_cast<long>(count) / format().channels;
  }
  long Write(std::span<const std::int16_t> from) override {
    if (sound_.failing != 0) return sound_.failing;
    const auto channels = static_cast<std::size_t>(format().channels);
    const std::size_t frames = std::min(from.size() / channels, sound_.room_frames);
    sound_.room_frames -= frames;
    sound_.played.insert(sound_.played.end(), from.begin(),
                         from.begin() + static_cast<std::ptrdiff_t>(frames * channels));
    return frames == 0 ? -EAGAIN : static_cast<long>(frames);
  }

 private:
  int Mend(int answer) {
    if (answer == 0) sound_.failing = 0;
    return answer;
  }
  FakeSound& sound_;
};

inline audio::PcmOpener Opener(FakeSound& sound) {
  return [&sound](const std::string&, audio::Direction,
                  const audio::AlsaPreferences&) -> Result<std::unique_ptr<audio::AlsaPcm>> {
    return std::make_unique<FakePcm>(sound);
  };
}

}  // namespace kaori::tests
