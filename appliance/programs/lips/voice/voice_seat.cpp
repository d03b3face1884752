#include "appliance/programs/lips/voice/voice_seat.h"

#include <utility>

#include "drivers/base/log.h"

namespace kaori::voice {
namespace {

constexpr Duration kTick = std::chrono::milliseconds(10);

}  // namespace

Result<std::unique_ptr<VoiceSeat>> VoiceSeat::Acquire(SoundSources sources, VoiceSeatSettings settings,
                                                   const board::Board& board, const Clock& clock) {
  auto seat = std::make_unique<VoiceSeat>();
  if (sources.loudspeaker) {
    auto writer = board.AcquireWriter<board::Sound>();
    if (!writer) return tl::unexpected(writer.error());
    seat->speaker_ = std::make_unique<Speaker>(std::move(sources.loudspeaker), board, std::move(*writer),
                                               std::move(settings.speaker), clock);
  }
  if (!sources.microphone) return seat;
  auto writer = board.AcquireWriter<board::Voice>();
  if (!writer) return tl::unexpected(writer.error());
  VoiceReader::Ear ear;
  if (seat->speaker_)
    ear = [speaker = seat->speaker_.get()](const auto& block, const auto& format) {
      speaker->Hear(block, format);
    };
  seat->reader_ = std::make_unique<VoiceReader>(std::move(sources.microphone), std::move(*writer),
                                                settings.gate, clock, std::move(ear));
  return seat;
}

Result<void> VoiceSeat::Join(EventLoop& loop) {
  loop_ = &loop;
  Step();
  if (!speaker_ && !reader_) return {};
  return loop.Every(kTick, [this] { Step(); });
}

void VoiceSeat::Step() {
  if (reader_) reader_->Step();
  if (speaker_) speaker_->Step();
  if (loop_ != nullptr && reader_) Watch();
}

void VoiceSeat::Use(const GateSettings& gate, const DelayWish& delay) {
  if (reader_) reader_->Use(gate);
  if (speaker_) speaker_->Use(delay);
}

// Another microphone is another descriptor.
void VoiceSeat::Watch() {
  if (watched_ == reader_->pollable() && opened_ == reader_->opened()) return;
  if (watched_ >= 0) loop_->Forget(watched_);
  watched_ = reader_->pollable();
  opened_ = reader_->opened();
  if (watched_ < 0) return;
  if (auto ok = loop_->Watch(watched_, [this] { Step(); }); !ok) LogWarning("{}", ok.error().message());
}

}  // namespace kaori::voice
