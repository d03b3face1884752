#include "appliance/programs/lips/voice/voice_reader.h"

#include "drivers/base/log.h"
#include "drivers/base/source.h"

namespace kaori::voice {
namespace {

using std::chrono::milliseconds;

constexpr Duration kSilence = milliseconds(200);  // After this time the voice is stale.
// How often a microphone that is not there is looked for.
constexpr Duration kVoiceReaderRetry = milliseconds(250);
constexpr Duration kGiveUp =
    milliseconds(2000);  // A stream that was silent for this long does not resume by itself.
constexpr Duration kOldest = milliseconds(500);  // An older time of recording is a fault of the driver.
constexpr int kBlocksAtOnce = 64;  // A microphone that sends without end must not hold the program up.

// What Listener and DelayLine are made for; the drivers ask their devices for it.
bool IsSupported(const ports::SoundFormat& format) {
  return format.rate_hz == 48000 && (format.channels == 1 || format.channels == 2);
}

}  // namespace

// Nothing goes on from an earlier run: a voice is over within a second.
VoiceReader::VoiceReader(ports::MicrophoneOpener open, board::Writer<board::Voice> writer,
                         const GateSettings& gate, const Clock& clock, BlockHandler handler)
    : open_(std::move(open)),
      writer_(std::move(writer)),
      clock_(clock),
      handler_(std::move(handler)),
      listener_(gate),
      last_block_(clock.now()) {}

// Silence is judged last, so that what was read in this step counts.
void VoiceReader::Step() {
  const Time now = clock_.now();
  if (!microphone_ && now >= retry_at_) TryOpen(now);
  if (microphone_) ReadBlocks(now);
  CheckSilence(now);
}

// Where nobody has plugged one in that is logged once (OpenOrLog), not four times a second.
void VoiceReader::TryOpen(Time now) {
  retry_at_ = now + kVoiceReaderRetry;
  microphone_ = OpenOrLog(open_, logged_);
  if (!microphone_) return;
  last_block_ = now;
  ++opened_;
  if (logged_ != std::errc::timed_out) Log("microphone: opened");
}

// The format is asked with each block: a driver may settle on it only when sound flows.
void VoiceReader::ReadBlocks(Time now) {
  for (int n = 0; n < kBlocksAtOnce; ++n) {
    const auto block = microphone_->Read();
    if (block && !IsSupported(microphone_->format()))
      return Close(now, "microphone: the format is not 48 kHz with one or two channels");
    if (block)
      Process(*block, now);
    else if (block.error().cause == std::errc::resource_unavailable_try_again)
      return;
    else
      return Close(now, block.error().message());
  }
}

// A stamp that cannot be is replaced before anything is computed from it. The loudspeaker gets the block
// before the board is written: its deadline is nearer.
void VoiceReader::Process(const ports::SoundBlock& recorded, Time now) {
  ports::SoundBlock block = recorded;
  block.at = PlausibleStamp(block.at, now, kOldest);
  const Voice& voice = listener_.Hear(block, microphone_->format());
  if (handler_) handler_(block, microphone_->format());
  if (source_ != board::SourceState::kLive) silence_log_.Speaks();
  source_ = board::SourceState::kLive;
  last_block_ = now;
  logged_ = {};
  heard_at_ = voice.at;
  writer_.Write(mouth_.Follow(voice), heard_at_, source_);
}

// The last mouth stays on the board with the time at which it was heard, and is marked as stale.
void VoiceReader::Close(Time now, std::string_view why) {
  microphone_.reset();
  retry_at_ = now + kVoiceReaderRetry;
  LogWarning("{}; the microphone is opened again", why);
  silence_log_.Lost();
  logged_ = std::errc::no_such_device;
  if (source_ != board::SourceState::kLive) return;
  source_ = board::SourceState::kStale;
  writer_.Write(mouth_.mouth(), heard_at_, source_);
}

// Silence of the stream, not of the voice: a quiet room sends blocks too.
void VoiceReader::CheckSilence(Time now) {
  if (source_ == board::SourceState::kLive && now - last_block_ >= kSilence) {
    silence_log_.Silent(kSilence, now);
    source_ = board::SourceState::kStale;
    writer_.Write(mouth_.mouth(), heard_at_, source_);
  }
  if (!microphone_ || now - last_block_ < kGiveUp) return;
  if (logged_ != std::errc::timed_out)
    LogWarning("microphone: no sound for {} s; the microphone is opened again", kGiveUp / milliseconds(1000));
  logged_ = std::errc::timed_out;
  microphone_.reset();
  retry_at_ = now;
}

}  // namespace kaori::voice
