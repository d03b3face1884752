// Sounds of motions: what a WAV file may be, and what is said of one that may not.
#include "appliance/authoring/script/wave_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <numbers>
#include <ostream>

#include "appliance/authoring/script/show_file.h"

namespace kaori::authoring {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Wave {
  std::uint32_t kind = 1, channels = 1, rate_hz = 48000, bits = 16;
  std::vector<double> samples;  // -1 .. 1; one after the other.
};

void Put(std::string& to, std::uint32_t number, int bytes) {
  for (int n = 0; n < bytes; ++n) to += static_cast<char>(number >> (8 * n));
}

std::string Bytes(const Wave& wave) {
  std::string data;
  for (const double sample : wave.samples)
    Put(data, static_cast<std::uint32_t>(std::lround(sample * ((1 << (wave.bits - 1)) - 1))),
        static_cast<int>(wave.bits / 8));
  std::string bytes = "RIFF";
  Put(bytes, static_cast<std::uint32_t>(46 + data.size()), 4);
  bytes += "WAVEfmt ";
  Put(bytes, 16, 4);
  Put(bytes, wave.kind, 2);
  Put(bytes, wave.channels, 2);
  Put(bytes, wave.rate_hz, 4);
  Put(bytes, wave.rate_hz * wave.channels * wave.bits / 8, 4);
  Put(bytes, wave.channels * wave.bits / 8, 2);
  Put(bytes, wave.bits, 2);
  bytes += "LIST";  // What editors leave in files; of an odd length.
  Put(bytes, 3, 4);
  bytes += std::string("abc\0", 4);
  bytes += "data";
  Put(bytes, static_cast<std::uint32_t>(data.size()), 4);
  return bytes + data;
}

std::vector<double> Tone(double hz, double rate_hz, double seconds, std::size_t channels = 1) {
  std::vector<double> samples;
  for (std::size_t n = 0; n < static_cast<std::size_t>(seconds * rate_hz); ++n)
    samples.insert(samples.end(), channels,
                   0.5 * std::sin(2 * std::numbers::pi * hz * static_cast<double>(n) / rate_hz));
  return samples;
}

class WaveTest : public ::testing::Test {
 protected:
  ~WaveTest() override { std::remove(file_.c_str()); }
  Result<show::Sound> Read(const std::string& bytes) {
    std::ofstream(file_, std::ios::binary) << bytes;
    return ReadWave(file_);
  }
  std::string file_ = ::testing::TempDir() + "kaori-" + std::to_string(::getpid()) + ".wav";
};

TEST_F(WaveTest, IsTakenAsItIsAt48KHz) {
  const auto sound = Read(Bytes({.channels = 2, .samples = {0.5, -0.5, 1, -1}}));
  ASSERT_TRUE(sound) << sound.error().message();
  EXPECT_EQ(sound->channels, 2);
  EXPECT_EQ(sound->samples, (std::vector<std::int16_t>{16384, -16384, 32766, -32766}));
}

TEST_F(WaveTest, OfAnotherRateKeepsItsLengthPitchAndLoudness) {
  for (const std::uint32_t rate_hz : {8000U, 22050U, 44100U, 96000U}) {
    const auto sound = Read(Bytes({.rate_hz = rate_hz, .bits = 24, .samples = Tone(440, rate_hz, 0.5)}));
    ASSERT_TRUE(sound) << sound.error().message();
    EXPECT_NEAR(static_cast<double>(sound->samples.size()), 24000, 2);
    double worst = 0;
    for (std::size_t n = 2400; n < 21600; ++n) {
      const double truth = 0.5 * std::sin(2 * std::numbers::pi * 440 * static_cast<double>(n) / 48000);
      worst = std::max(worst, std::abs(truth - sound->samples[n] / 32767.0));
    }
    EXPECT_LT(worst, 0.003) << rate_hz;
  }
}

TEST_F(WaveTest, LosesWhatTheSlowerRateCannotHold) {
  const auto sound = Read(Bytes({.rate_hz = 96000, .samples = Tone(40000, 96000, 0.2)}));
  ASSERT_TRUE(sound);
  double power = 0;
  for (const std::int16_t sample : sound->samples) power += double{1} * sample * sample;
  EXPECT_LT(std::sqrt(power / static_cast<double>(sound->samples.size())), 50) << "of 11585";
}

struct WaveWrong {
  const char* name;
  std::string bytes;
  const char* what;
  friend void PrintTo(const WaveWrong& wrong, std::ostream* out) { *out << wrong.name; }
};

class AWrongWave : public WaveTest, public ::testing::WithParamInterface<WaveWrong> {};

TEST_P(AWrongWave, IsNamedInOneLine) {
  const auto sound = Read(GetParam().bytes);
  ASSERT_FALSE(sound);
  const std::string said = sound.error().message();
  EXPECT_THAT(said, HasSubstr(file_));
  EXPECT_THAT(said, HasSubstr(GetParam().what));
  EXPECT_EQ(said.find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    Each, AWrongWave,
    ::testing::Values(
        WaveWrong{"Empty", "", "is no WAV file"},
        WaveWrong{"Picture", "\x89PNG and so on and on", "is no WAV file"},
        WaveWrong{"OfThreeChannels", Bytes({.channels = 3, .samples = {0, 0, 0}}), "has 3 channels"},
        WaveWrong{"OfFloats", Bytes({.kind = 3, .bits = 24, .samples = {0}}), "is not PCM"},
        WaveWrong{"Of8Bit", Bytes({.bits = 8, .samples = {0}}), "is not PCM"},
        WaveWrong{"OfNoRate", Bytes({.rate_hz = 0, .samples = {0}}), "has 0 Hz"},
        WaveWrong{"Silent", Bytes({}), "holds no sound"},
        WaveWrong{"CutOffInItsHead", Bytes({.samples = {0, 0}}).substr(0, 30), "does not say its format"}),
    [](const auto& tested) { return tested.param.name; });

TEST_F(WaveTest, EveryFileThatIsCutOffOrFlippedIsReadOrRefused) {
  const std::string whole = Bytes({.channels = 2, .samples = Tone(300, 48000, 0.01, 2)});
  for (std::size_t n = 0; n < whole.size(); n += 3) {
    const auto cut = Read(whole.substr(0, n));
    EXPECT_TRUE(!cut || cut->samples.size() % 2 == 0);
    std::string flipped = whole;
    flipped[n] = static_cast<char>(flipped[n] ^ 0x5A);
    const auto read = Read(flipped);
    EXPECT_TRUE(!read || read->samples.size() <= 10 * whole.size());
  }
}

TEST_F(WaveTest, AMissingFileIsNamed) {
  const auto sound = ReadWave("/nowhere/hello.wav");
  ASSERT_FALSE(sound);
  EXPECT_EQ(sound.error().message(), "read /nowhere/hello.wav: No such file or directory");
}

TEST_F(WaveTest, BelongsToItsMotion) {
  std::ofstream(file_, std::ios::binary) << Bytes({.samples = {0.5, 0.25}});
  const std::string script = file_ + ".toml";
  const std::string scene =
      "[[scene]]\nname = \"a\"\nface = \"kaori\"\nbackdrop = { top = \"#000000\", bottom = \"#000000\" }\n";
  const auto read = [&](const std::string& motion) {
    std::ofstream(script) << scene << motion;
    show::Show show;
    show.cast.faces.resize(1);
    show.cast.faces[0].name = "kaori";
    show.cast.expressions.resize(1);
    show.cast.expressions[0].name = "neutral";
    const auto faults = ReadShowFile(script, show);
    return std::pair(show.motions.empty() ? show::Sound{} : show.motions[0].sound,
                     faults.empty() ? std::string() : faults[0]);
  };
  const std::string name = file_.substr(file_.rfind('/') + 1);
  const auto [sound, fault] = read("[[motion]]\nname = \"hello\"\nkey = \"1\"\nsound = \"" + name + "\"\n");
  EXPECT_EQ(fault, "");
  EXPECT_EQ(sound.samples.size(), 2U) << "a motion may be of sound alone";
  EXPECT_THAT(read("[[motion]]\nname = \"hello\"\nkey = \"1\"\nsound = \"none.wav\"\n").second,
              HasSubstr(":8: motion \"hello\".sound: read "));
  EXPECT_THAT(read("[[motion]]\nname = \"hello\"\nkey = \"1\"\nsound = 3\n").second,
              HasSubstr(":8: motion \"hello\".sound: must be a text in quotes"));
  std::remove(script.c_str());
}

}  // namespace
}  // namespace kaori::authoring
