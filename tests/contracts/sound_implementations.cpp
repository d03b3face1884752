// Microphones and loudspeakers: ALSA on a fake device and
// on ALSA's own file plug-ins, and the simulator's links.
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "drivers/audio/alsa_loudspeaker.h"
#include "drivers/audio/alsa_microphone.h"
#include "drivers/audio/local_loudspeaker.h"
#include "drivers/audio/local_microphone.h"
#include "firmware/wire/link_sound.h"
#include "tests/contracts/loudspeaker_contract.h"
#include "tests/contracts/microphone_contract.h"
#include "tests/drivers/audio_fake_pcm.h"
#include "tests/drivers/link_peer.h"
#include "tests/hw-sim/link_fixture.h"

namespace kaori::contracts {
namespace {

using SoundSamples = std::vector<std::int16_t>;

// A folder with files for ALSA's file plug-in: "heard" reads in.raw, "written" writes out.raw.
class AlsaFolder {
 public:
  AlsaFolder() {
    std::ofstream(File("asound.conf"))
        << "pcm.heard { type file slave.pcm { type null } file /dev/null infile \"" << File("in.raw")
        << "\" format raw }\n"
        << "pcm.written { type file slave.pcm { type null } file \"" << File("out.raw")
        << "\" format raw }\n";
    ::setenv("ALSA_CONFIG_PATH", File("asound.conf").c_str(), 1);
  }
  std::string File(const std::string& name) const { return folder_.path() + "/" + name; }

 private:
  sim::TempFolder folder_;
};

class AlsaMicrophoneSubject final : public MicrophoneSubject {
 public:
  AlsaMicrophoneSubject()
      : microphone_(audio::AlsaMicrophone::Open("hw:1", {}, clock, tests::Opener(device_)).value()) {}
  ports::Microphone& microphone() override { return *microphone_; }
  void Hear(const SoundSamples& samples) override { device_.heard = {samples.begin(), samples.end()}; }
  bool Overrun() override { return device_.failing = -EPIPE, true; }
  bool Unplug() override { return device_.failing = -ENODEV, true; }
  bool Break() override { return device_.failing = -EIO, true; }

 private:
  tests::FakeSound device_;
  std::unique_ptr<audio::AlsaMicrophone> microphone_;
};

class AlsaFileMicrophoneSubject final : public MicrophoneSubject {
 public:
  ports::Microphone& microphone() override {
    if (!microphone_) microphone_ = audio::AlsaMicrophone::Open("heard", {}, steady_).value();
    return *microphone_;
  }
  void Hear(const SoundSamples& samples) override {
    if (microphone_) return;  // The plug-in has read its file.
    std::ofstream(folder_.File("in.raw"), std::ios::binary)
        .write(reinterpret_cast<const char*>(samples.data()), std::streamsize(samples.size() * 2));
  }
  bool falls_silent() const override { return false; }
  Time now() const override { return steady_.now(); }

 private:
  AlsaFolder folder_;
  SteadyClock steady_;
  std::unique_ptr<audio::AlsaMicrophone> microphone_;
};

class LocalMicrophoneSubject final : public MicrophoneSubject {
 public:
  LocalMicrophoneSubject() : microphone_(audio::LocalMicrophone::Open(folder_.path(), "m").value()) {
    EXPECT_TRUE(device_.Accept());
    device_.Send(wire::Encode(wire::MicrophoneHello{48000, 1}));
  }
  ports::Microphone& microphone() override { return *microphone_; }
  void Hear(const SoundSamples& samples) override {
    const auto note = wire::Encode(wire::SoundBlockNote{clock.now().time_since_epoch().count(), lost_});
    lost_ = 0;
    std::vector<std::uint8_t> packet(note.begin(), note.end());
    packet.resize(note.size() + 2 * samples.size());
    for (std::size_t n = 0; n < samples.size(); ++n)
      wire::PutU16(packet, note.size() + 2 * n, static_cast<std::uint16_t>(samples[n]));
    device_.Send(packet);
  }
  bool Overrun() override { return lost_ = 1, true; }
  bool Unplug() override { return device_.HangUp(), true; }
  bool Break() override { return device_.Send(std::array<std::uint8_t, 1>{7}), true; }

 private:
  sim::TempFolder folder_;
  tests::LinkPeer device_{folder_.path() + "/microphone.m"};
  std::unique_ptr<ports::Microphone> microphone_;
  std::uint32_t lost_ = 0;
};

class AlsaLoudspeakerSubject final : public LoudspeakerSubject {
 public:
  AlsaLoudspeakerSubject() {
    device_.format.channels = 2;
    loudspeaker_ =
        audio::AlsaLoudspeaker::Open("hw:1", {.channels = 2}, clock, tests::Opener(device_)).value();
  }
  ports::Loudspeaker& loudspeaker() override { return *loudspeaker_; }
  SoundSamples Played() override { return device_.played; }
  bool LeaveRoom(std::size_t frames) override { return device_.room_frames = frames, true; }
  bool RunEmpty() override { return device_.failing = -EPIPE, true; }
  bool Unplug() override { return device_.failing = -ENODEV, true; }
  bool Break() override { return device_.failing = -EIO, true; }

 private:
  tests::FakeSound device_;
  std::unique_ptr<audio::AlsaLoudspeaker> loudspeaker_;
};

class AlsaFileLoudspeakerSubject final : public LoudspeakerSubject {
 public:
  AlsaFileLoudspeakerSubject()
      : loudspeaker_(audio::AlsaLoudspeaker::Open("written", {.channels = 2}, steady_).value()) {}
  ports::Loudspeaker& loudspeaker() override { return *loudspeaker_; }
  SoundSamples Played() override {
    loudspeaker_.reset();  // Only then is the file whole.
    std::ifstream file(folder_.File("out.raw"), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    SoundSamples samples(bytes.size() / 2);
    std::memcpy(samples.data(), bytes.data(), samples.size() * 2);
    return samples;
  }
  Time now() const override { return steady_.now(); }

 private:
  AlsaFolder folder_;
  SteadyClock steady_;
  std::unique_ptr<audio::AlsaLoudspeaker> loudspeaker_;
};

class LocalLoudspeakerSubject final : public LoudspeakerSubject {
 public:
  ports::Loudspeaker& loudspeaker() override {
    if (!loudspeaker_) Open();
    return *loudspeaker_;
  }
  SoundSamples Played() override {
    std::array<std::uint8_t, wire::kMaxLinkPacket> packet{};
    while (const auto heard = device_.Receive(packet))
      for (std::size_t at = 0; at < heard->bytes; at += 2)
        played_.push_back(static_cast<std::int16_t>(wire::GetU16(packet, at)));
    return played_;
  }
  bool LeaveRoom(std::size_t frames) override { return room_frames_ = std::uint32_t(frames), true; }
  bool RunEmpty() override {
    device_.Send(wire::Encode(wire::PlayedNote{clock.now().time_since_epoch().count(), 3, 1}));
    return true;
  }
  bool Unplug() override { return device_.HangUp(), true; }
  bool Break() override { return device_.Send(std::array<std::uint8_t, 1>{7}), true; }

 private:
  void Open() {
    loudspeaker_ = audio::LocalLoudspeaker::Open(folder_.path(), clock, "l").value();
    EXPECT_TRUE(device_.Accept());
    device_.Send(wire::Encode(wire::LoudspeakerHello{48000, 2, room_frames_}));
  }

  sim::TempFolder folder_;
  tests::LinkPeer device_{folder_.path() + "/loudspeaker.l"};
  std::uint32_t room_frames_ = 480;
  SoundSamples played_;
  std::unique_ptr<ports::Loudspeaker> loudspeaker_;
};

INSTANTIATE_TEST_SUITE_P(Microphones, MicrophoneContract,
                         ::testing::Values(
                             Implementation<MicrophoneSubject>{
                                 "Alsa", [] { return std::make_unique<AlsaMicrophoneSubject>(); }},
                             Implementation<MicrophoneSubject>{
                                 "AlsaFile", [] { return std::make_unique<AlsaFileMicrophoneSubject>(); }},
                             Implementation<MicrophoneSubject>{
                                 "Local", [] { return std::make_unique<LocalMicrophoneSubject>(); }}),
                         NameOf<MicrophoneSubject>);

INSTANTIATE_TEST_SUITE_P(Loudspeakers, LoudspeakerContract,
                         ::testing::Values(
                             Implementation<LoudspeakerSubject>{
                                 "Alsa", [] { return std::make_unique<AlsaLoudspeakerSubject>(); }},
                             Implementation<LoudspeakerSubject>{
                                 "AlsaFile", [] { return std::make_unique<AlsaFileLoudspeakerSubject>(); }},
                             Implementation<LoudspeakerSubject>{
                                 "Local", [] { return std::make_unique<LocalLoudspeakerSubject>(); }}),
                         NameOf<LoudspeakerSubject>);

}  // namespace
}  // namespace kaori::contracts
