#include "hw-sim/devices/voice_file.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"
#include "hw-sim/devices/voice_synth.h"

namespace kaori::sim {
namespace {

constexpr Duration kVowel = std::chrono::milliseconds(333);
constexpr double kLoudness = 1.5;

// The head of a WAV file, as all programs write it: its places in bytes (RIFF, a
// "fmt " chunk of 16 bytes, "data").
constexpr std::size_t kHeadBytes = 44, kChannelsAt = 22, kRateAt = 24, kBitsAt = 34;
constexpr std::uint32_t kSampleBytes = 2;
constexpr std::size_t kMostWav_bytes = std::size_t{256} << 20U;  // More than half an hour.

// Compared are means of so many samples: 8 kHz tell a voice as well, at a thirty-sixth of the work.
constexpr std::size_t kTogether = 6;

std::size_t SamplesIn(Duration length) {
  return static_cast<std::size_t>(std::llround(Seconds(length) * kSynthRate_hz));
}

// A little-endian number of `length` bytes.
void Put(std::string& bytes, std::uint32_t value, int length) {
  for (int n = 0; n < length; ++n) bytes += static_cast<char>(value >> (8 * n) & 0xFF);
}

std::uint32_t LittleEndian(const std::string& bytes, std::size_t at, std::size_t length) {
  std::uint32_t value = 0;
  for (std::size_t n = length; n-- > 0;) value = value << 8 | static_cast<std::uint8_t>(bytes[at + n]);
  return value;
}

std::vector<float> Thinned(std::span<const std::int16_t> samples) {
  std::vector<float> means;
  for (std::size_t at = 0; at + kTogether <= samples.size(); at += kTogether) {
    float sum = 0;
    for (const std::int16_t sample : samples.subspan(at, kTogether)) sum += sample;
    means.push_back(sum / kTogether);
  }
  return means;
}

// The scalar product.
double Product(std::span<const float> one, std::span<const float> other) {
  double sum = 0;
  for (std::size_t n = 0; n < one.size(); ++n) sum += double{one[n]} * double{other[n]};
  return sum;
}

}  // namespace

std::vector<std::int16_t> SayVowels(Duration length) {
  VoiceSynth voice;
  std::vector<std::int16_t> samples(SamplesIn(length));
  const std::size_t vowel = SamplesIn(kVowel);
  for (std::size_t n = 0; n < samples.size(); ++n) {
    if (n % vowel == 0) voice.Say(static_cast<int>(n / vowel) % kSynthVowels, kLoudness);
    samples[n] = voice.Next();
  }
  return samples;
}

Result<void> WriteWav(const std::string& path, std::span<const std::int16_t> samples) {
  const auto bytes = static_cast<std::uint32_t>(samples.size()) * kSampleBytes;
  std::string file = "RIFF";
  // Sizes of RIFF chunks count what is behind them.
  Put(file, bytes + kHeadBytes - 8, 4);
  file += "WAVEfmt ";
  Put(file, 16, 4);
  Put(file, 1, 2);  // Plain samples,
  Put(file, 1, 2);  // of one channel.
  Put(file, kSynthRate_hz, 4);
  Put(file, kSynthRate_hz * kSampleBytes, 4);
  Put(file, kSampleBytes, 2);
  Put(file, 8 * kSampleBytes, 2);
  file += "data";
  Put(file, bytes, 4);
  for (const std::int16_t sample : samples) Put(file, static_cast<std::uint16_t>(sample), 2);
  return WriteWholeFile(path, {AsBytes(file)});
}

Result<std::vector<std::int16_t>> ReadWav(const std::string& path) {
  const auto read = ReadFile(path, {.most_bytes = kMostWav_bytes});
  if (!read) return tl::unexpected(read.error());
  const std::string& file = *read;
  const bool sound =
      file.size() >= kHeadBytes && file.starts_with("RIFF") && LittleEndian(file, kChannelsAt, 2) > 0 &&
      LittleEndian(file, kRateAt, 4) == kSynthRate_hz && LittleEndian(file, kBitsAt, 2) == 8 * kSampleBytes;
  if (!sound) return FailInput(path + " is no WAV file of 16 bits at 48 kHz");
  const std::size_t step = std::size_t{kSampleBytes} * LittleEndian(file, kChannelsAt, 2);
  std::vector<std::int16_t> samples;
  for (std::size_t at = kHeadBytes; at + step <= file.size(); at += step)
    // The data begin where the head ends: chunks between both are not looked for.
    samples.push_back(static_cast<std::int16_t>(LittleEndian(file, at, kSampleBytes)));
  return samples;
}

double Likeness(std::span<const std::int16_t> said, std::span<const std::int16_t> heard) {
  const std::size_t length = SamplesIn(std::chrono::milliseconds(100));
  if (said.size() < length || heard.size() < length) return 0;
  // From the middle: the first vowel begins in silence, and players fade in.
  const auto wanted = Thinned(said.subspan((said.size() - length) / 2, length));
  const auto there = Thinned(heard);
  const double wanted_power = Product(wanted, wanted);
  double best = 0;
  for (std::size_t at = 0; at + wanted.size() <= there.size(); ++at) {
    const auto part = std::span(there).subspan(at, wanted.size());
    const double power = std::sqrt(Product(part, part) * wanted_power);
    if (power > 0) best = std::max(best, std::abs(Product(wanted, part)) / power);
  }
  return best;
}

}  // namespace kaori::sim
