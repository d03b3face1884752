#include "appliance/programs/lips/voice/voice_reader.h"

#include "drivers/base/log.h"
#include "drivers/base/source.h"

namespace kaori::voice {
namespace {

using std::chrono::milliseconds;

constexpr Duration kSilence = milliseconds(200);  // After this time the voice is stale.
// The pause before a microphone that had sent sound is opened again.
constexpr Duration kAfterLoss = milliseconds(250);
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
      reopening_("microphone", clock, kAfterLoss),
      last_block_(clock.now()) {}

// Silence is judged last, so that what was read in this step counts.
void VoiceReader::Step() {
  if (!microphone_ && reopening_.IsDue(clock_.now())) TryOpen();
  const Time now = clock_.now();  // The opening may have taken long.
  if (microphone_) ReadBlocks(now);
  CheckSilence(now);
}

// Where nobody has plugged one in that is logged once (Reopening), not four times a second.
void VoiceReader::TryOpen() {
  microphone_ = reopening_.Open(open_);
  if (!microphone_) return;
  last_block_ = clock_.now();
  ++opened_;
}

// The format is asked with each block: a driver may settle on it only when sound flows.
void VoiceReader::ReadBlocks(Time now) {
  for (int n = 0; n < kBlocksAtOnce; ++n) {
    const auto block = microphone_->Read();
    if (block && !IsSupported(microphone_->format()))
      return Close({.cause = std::errc::not_supported,
                    .attempt = "microphone: the format is not 48 kHz with one or two channels",
                    .kind = ErrorKind::kInput});
    if (block)
      Process(*block, now);
    else if (block.error().cause == std::errc::resource_unavailable_try_again)
      return;
    else
      return Close(block.error());
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
  reopening_.NoteDelivery();
  heard_at_ = voice.at;
  writer_.Write(mouth_.Follow(voice), heard_at_, source_);
}

// The last mouth stays on the board with the time at which it was heard, and is marked as stale.
void VoiceReader::Close(const Error& why) {
  reopening_.Close(microphone_, why);
  silence_log_.Lost();
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
  reopening_.Close(microphone_,
                   {.cause = std::errc::timed_out,
                    .attempt = fmt::format("microphone: no sound for {} s", kGiveUp / milliseconds(1000)),
                    .kind = ErrorKind::kInput});
}

}  // namespace kaori::voice
