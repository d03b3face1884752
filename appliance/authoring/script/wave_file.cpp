#include "appliance/authoring/script/wave_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::authoring {
namespace {

// Ten minutes, the longest motion, of 24 bit stereo at 96 kHz are 346 MB.
constexpr std::size_t kMost_bytes = std::size_t{512} << 20U;
constexpr long kRate_hz = show::kSoundRate_hz;
// RIFF: "RIFF", size, "WAVE"; then chunks of name, size and content, padded to even lengths (Microsoft and
// IBM, Multimedia Programming Interface and Data Specifications 1.0, 1991).
constexpr std::size_t kRiffHead_bytes = 12, kChunkHead_bytes = 8, kFormat_bytes = 16;
// Format tags. WAVE_FORMAT_EXTENSIBLE keeps the true one in the first two bytes of its GUID, at byte 24.
constexpr std::uint32_t kPcm = 1, kExtensible = 0xFFFE;
// Of the low pass to either side, in samples of the slower rate: the more, the steeper.
constexpr int kReach = 24;

using Bytes = std::span<const std::uint8_t>;

// `count` bytes at `at`, the least significant first. They must be there.
std::uint32_t Number(Bytes bytes, std::size_t at, int count) {
  std::uint32_t number = 0;
  for (int n = count - 1; n >= 0; --n) number = number << 8U | bytes[at + static_cast<std::size_t>(n)];
  return number;
}

bool IsNamed(Bytes bytes, std::size_t at, std::string_view name) {
  return std::equal(name.begin(), name.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at));
}

// The content of the first chunk `name`; one that is cut off ends with the file, as recorders that were
// stopped leave it. None where there is no such chunk.
std::optional<Bytes> Chunk(Bytes file, std::string_view name) {
  std::size_t at = kRiffHead_bytes;
  while (at + kChunkHead_bytes <= file.size()) {
    const std::size_t bytes = Number(file, at + 4, 4);
    const Bytes rest = file.subspan(at + kChunkHead_bytes);
    if (IsNamed(file, at, name)) return rest.first(std::min(bytes, rest.size()));
    if (bytes >= rest.size()) return std::nullopt;
    at += kChunkHead_bytes + bytes + bytes % 2;
  }
  return std::nullopt;
}

// What the chunk "fmt " says, as far as it counts here.
struct Format {
  std::uint32_t channels, rate_hz, bits;
  // Bytes of one sample of all channels.
  std::size_t frame_bytes() const { return std::size_t{channels} * bits / 8; }
};

// Errors: invalid_argument; the attempt is the end of a sentence about the file.
Result<Format> ReadFormat(Bytes file) {
  if (file.size() < kRiffHead_bytes || !IsNamed(file, 0, "RIFF") || !IsNamed(file, 8, "WAVE"))
    return FailInput("is no WAV file");
  const auto chunk = Chunk(file, "fmt ");
  if (!chunk || chunk->size() < kFormat_bytes) return FailInput("does not say its format");
  std::uint32_t kind = Number(*chunk, 0, 2);
  if (kind == kExtensible && chunk->size() >= 26) kind = Number(*chunk, 24, 2);
  const Format format{Number(*chunk, 2, 2), Number(*chunk, 4, 4), Number(*chunk, 14, 2)};
  if (kind != kPcm || (format.bits != 16 && format.bits != 24))
    return FailInput("is not PCM of 16 or 24 bit; save it so");
  if (format.channels < 1 || format.channels > 2)
    return FailInput(fmt::format("has {} channels; one or two are wanted", format.channels));
  if (format.rate_hz < 8000 || format.rate_hz > 192000)
    return FailInput(fmt::format("has {} Hz; 8000 to 192000 are wanted", format.rate_hz));
  return format;
}

// One channel of interleaved samples, -1 .. 1. Numbers are shifted to the top of 32 bits first, which brings
// the sign to its place.
std::vector<float> Channel(Bytes data, const Format& format, std::size_t channel) {
  const std::size_t bytes = format.bits / 8;
  std::vector<float> samples(data.size() / format.frame_bytes());
  for (std::size_t n = 0; n < samples.size(); ++n) {
    const std::uint32_t raw =
        Number(data, n * format.frame_bytes() + channel * bytes, static_cast<int>(bytes))
        << (32 - format.bits);
    samples[n] = static_cast<float>(static_cast<std::int32_t>(raw)) / 2147483648.0F;
  }
  return samples;
}

// The weights of the samples around a place that lies `part` behind one of them: a sinc under a Hann window,
// which also keeps out what the slower rate cannot hold (`cut`: its share of the file's rate). The first is
// that of the sample `reach` before. They sum to 1, so that silence and constant levels stay.
std::vector<float> Kernel(double part, double cut, long reach) {
  std::vector<float> weights;
  double sum = 0;
  for (long k = -reach; k <= reach; ++k) {
    const double x = std::numbers::pi * (static_cast<double>(k) - part);
    const double sinc = std::abs(x) < 1e-9 ? 1 : std::sin(cut * x) / (cut * x);
    const double window =
        0.5 + 0.5 * std::cos(std::min(std::numbers::pi, std::abs(x) / static_cast<double>(reach)));
    weights.push_back(static_cast<float>(sinc * window));
    sum += sinc * window;
  }
  for (float& weight : weights) weight = static_cast<float>(weight / sum);
  return weights;
}

// Before its start and after its end a sound is silent.
float Weighed(const std::vector<float>& from, long first, const std::vector<float>& weights) {
  float sum = 0;
  for (std::size_t n = 0; n < weights.size(); ++n) {
    const long k = first + static_cast<long>(n);
    if (k >= 0 && k < static_cast<long>(from.size())) sum += weights[n] * from[static_cast<std::size_t>(k)];
  }
  return sum;
}

// To 48 kHz. Places repeat after so many samples, and their weights with them: 160 kernels for 44.1 kHz.
std::vector<float> Resampled(const std::vector<float>& from, long rate_hz) {
  if (rate_hz == kRate_hz) return from;
  const double cut = std::min(1.0, static_cast<double>(kRate_hz) / static_cast<double>(rate_hz));
  const long reach = std::lround(kReach / cut), phases = kRate_hz / std::gcd(rate_hz, kRate_hz);
  std::vector<std::vector<float>> kernels(static_cast<std::size_t>(phases));
  std::vector<float> to(from.size() * static_cast<std::size_t>(kRate_hz) / static_cast<std::size_t>(rate_hz));
  for (std::size_t n = 0; n < to.size(); ++n) {
    const long whole = static_cast<long>(n) * rate_hz / kRate_hz,
               rest = static_cast<long>(n) * rate_hz % kRate_hz;
    auto& kernel = kernels[n % kernels.size()];
    if (kernel.empty()) kernel = Kernel(static_cast<double>(rest) / kRate_hz, cut, reach);
    to[n] = Weighed(from, whole - reach, kernel);
  }
  return to;
}

// To 16 bit; the resampler may overshoot full scale, and is held there.
show::Sound Interleaved(const std::vector<std::vector<float>>& channels) {
  show::Sound sound{static_cast<int>(channels.size()), {}};
  for (std::size_t n = 0; n < channels[0].size(); ++n)
    for (const auto& channel : channels)
      sound.samples.push_back(
          static_cast<std::int16_t>(std::lround(32767 * std::clamp(channel[n], -1.0F, 1.0F))));
  return sound;
}

// The length is judged before anything is decoded.
Result<show::Sound> Decode(Bytes file) {
  const auto format = ReadFormat(file);
  if (!format) return tl::unexpected(format.error());
  const auto data = Chunk(file, "data");
  if (!data || data->size() < format->frame_bytes()) return FailInput("holds no sound");
  const double seconds = static_cast<double>(data->size() / format->frame_bytes()) / format->rate_hz;
  if (seconds > static_cast<double>(show::kLongestMotion_s))
    return FailInput(fmt::format("is {:.0f} s long; {} s at most", seconds, show::kLongestMotion_s));
  std::vector<std::vector<float>> channels;
  for (std::size_t channel = 0; channel < format->channels; ++channel)
    channels.push_back(Resampled(Channel(*data, *format, channel), static_cast<long>(format->rate_hz)));
  return Interleaved(channels);
}

}  // namespace

// Decode's errors are ends of sentences about the sound.
Result<show::Sound> ReadWave(const std::filesystem::path& file) {
  const auto bytes = ReadFile(file, {.most_bytes = kMost_bytes});
  if (!bytes) return tl::unexpected(bytes.error());
  auto sound = Decode(AsBytes(*bytes));
  if (!sound) return FailInput(fmt::format("the sound {} {}", file.string(), sound.error().attempt));
  return sound;
}

}  // namespace kaori::authoring
