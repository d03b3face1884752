#include "hw-sim/rehearsal/film_sound.h"

#include <fcntl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "drivers/base/unique_fd.h"
#include "firmware/wire/bytes.h"
#include "hw-sim/rehearsal/ffmpeg.h"

namespace kaori::sim {
namespace {

constexpr std::int64_t kChannels = Loudspeaker::kChannels;
// A millisecond: less is rounding, more is a break that can be heard.
constexpr std::int64_t kJoinedFrames = FilmSound::kRate_hz / 1000;
// Of a RIFF head with one "fmt " and one "data" chunk.
constexpr std::size_t kHeadBytes = 44;
constexpr std::uint32_t kFrameBytes = 2 * kChannels;
constexpr mode_t kFileMode = 0666;  // As streams make files: the umask has the last word.

void PutTag(std::span<std::uint8_t> into, std::size_t at, const char (&tag)[5]) {
  std::copy_n(tag, 4, into.begin() + static_cast<std::ptrdiff_t>(at));
}

// The head of a RIFF WAVE file of PCM, as Microsoft's and IBM's "Multimedia Programming Interface" of 1991
// has it.
std::array<std::uint8_t, kHeadBytes> WavHead(std::int64_t frames) {
  const auto bytes = static_cast<std::uint32_t>(frames) * kFrameBytes;
  std::array<std::uint8_t, kHeadBytes> head{};
  PutTag(head, 0, "RIFF");
  wire::PutU32(head, 4, bytes + kHeadBytes - 8);
  PutTag(head, 8, "WAVE");
  PutTag(head, 12, "fmt ");
  wire::PutU32(head, 16, 16);
  wire::PutU16(head, 20, 1);  // PCM.
  wire::PutU16(head, 22, kChannels);
  wire::PutU32(head, 24, FilmSound::kRate_hz);
  wire::PutU32(head, 28, FilmSound::kRate_hz * kFrameBytes);
  wire::PutU16(head, 32, kFrameBytes);
  wire::PutU16(head, 34, 16);
  PutTag(head, 36, "data");
  wire::PutU32(head, 40, bytes);
  return head;
}

// Times before the film's beginning are negative.
std::int64_t FramesIn(Duration time) {
  return std::llround(Seconds(time) * FilmSound::kRate_hz);
}

}  // namespace

Result<FilmSound> FilmSound::Start(const std::string& file, Time begin) {
  // A stream does not say why a file cannot be opened; open(2) does.
  if (const UniqueFd made(::open(file.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, kFileMode)); !made.valid())
    return FailErrno("write the sound " + file);
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  if (!stream) return Fail(std::errc::io_error, "write the sound " + file);
  const auto head = WavHead(0);  // Its lengths come at the end.
  stream.write(reinterpret_cast<const char*>(head.data()), head.size());
  return FilmSound(file, std::move(stream), begin);
}

// A block's time says where in the film it belongs; frames_ says where the file ends so far.
void FilmSound::Add(const std::vector<Loudspeaker::Heard>& heard) {
  for (const Loudspeaker::Heard& block : heard) {
    std::span<const std::int16_t> samples(block.samples);
    const std::int64_t at = FramesIn(block.at - begin_);
    if (at > frames_ + kJoinedFrames) WriteSilence(at - frames_);
    // What belongs before the position that was reached is left out, as of a film
    // that began in the middle of a sound.
    if (at < frames_ - kJoinedFrames) {
      const std::int64_t early =
          std::min(frames_ - at, static_cast<std::int64_t>(samples.size()) / kChannels);
      samples = samples.subspan(static_cast<std::size_t>(early * kChannels));
    }
    Write(samples);
  }
}

// Sound that is already longer stays in the file, behind what the head counts.
Result<void> FilmSound::Finish(Duration length) {
  const std::int64_t wanted = FramesIn(length);
  if (wanted > frames_) WriteSilence(wanted - frames_);
  // A reader stops at the lengths in the head, whatever lies behind.
  const auto head = WavHead(wanted);
  stream_.seekp(0);
  stream_.write(reinterpret_cast<const char*>(head.data()), head.size());
  stream_.close();
  if (!stream_) return Fail(std::errc::io_error, "write the sound " + file_);
  return {};
}

void FilmSound::Write(std::span<const std::int16_t> samples) {
  std::vector<std::uint8_t> bytes(2 * samples.size());
  for (std::size_t n = 0; n < samples.size(); ++n) wire::PutI16(bytes, 2 * n, samples[n]);
  stream_.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  frames_ += static_cast<std::int64_t>(samples.size()) / kChannels;
}

void FilmSound::WriteSilence(std::int64_t frames) {
  // A tenth of a second at a time: an hour of silence needs no hour of memory.
  const std::vector<std::int16_t> silence(FilmSound::kRate_hz / 10 * kChannels);
  while (frames > 0) {
    const std::int64_t now = std::min<std::int64_t>(frames, FilmSound::kRate_hz / 10);
    Write(std::span(silence).first(static_cast<std::size_t>(now * kChannels)));
    frames -= now;
  }
}

// Pictures are copied as they are; sound becomes AAC of 192 kbit/s. "faststart" puts the index in front, so
// that a browser can play the film while it comes.
Result<void> JoinSound(const std::string& pictures, const std::string& sound, const std::string& film) {
  auto ffmpeg =
      Ffmpeg::Start({"-i", "file:" + pictures, "-i", "file:" + sound, "-map", "0:v", "-map", "1:a", "-c:v",
                     "copy", "-c:a", "aac", "-b:a", "192k", "-movflags", "+faststart", "file:" + film},
                    film);
  if (!ffmpeg) return tl::unexpected(ffmpeg.error());
  return ffmpeg->Finish();
}

}  // namespace kaori::sim
