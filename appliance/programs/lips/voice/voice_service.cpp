#include "appliance/programs/lips/voice/voice_service.h"

#include <utility>

#include "drivers/base/log.h"

namespace kaori::voice {
namespace {

// Half of the least sound that the speaker keeps waiting in its device (20 ms, speaker.cpp).
constexpr Duration kTick = std::chrono::milliseconds(10);

}  // namespace

// The speaker is made first: the reader hands it every block, and is destroyed before it (members are
// destroyed in reverse order).
Result<std::unique_ptr<VoiceService>> VoiceService::Acquire(SoundSources sources,
                                                            VoiceServiceSettings settings,
                                                            const board::Board& board, const Clock& clock) {
  auto service = std::make_unique<VoiceService>();
  if (sources.loudspeaker) {
    auto writer = board.AcquireWriter<board::Sound>();
    if (!writer) return tl::unexpected(writer.error());
    service->speaker_ = std::make_unique<Speaker>(std::move(sources.loudspeaker), board, std::move(*writer),
                                                  std::move(settings.speaker), clock);
  }
  if (!sources.microphone) return service;
  auto writer = board.AcquireWriter<board::Voice>();
  if (!writer) return tl::unexpected(writer.error());
  VoiceReader::BlockHandler handler;
  if (service->speaker_)
    handler = [speaker = service->speaker_.get()](const auto& block, const auto& format) {
      speaker->Record(block, format);
    };
  service->reader_ = std::make_unique<VoiceReader>(std::move(sources.microphone), std::move(*writer),
                                                   settings.gate, clock, std::move(handler));
  return service;
}

// The first step comes before the loop runs, so that the devices are open when it begins. A box that has
// neither needs no timer.
Result<void> VoiceService::Join(EventLoop& loop) {
  loop_ = &loop;
  Step();
  if (!speaker_ && !reader_) return {};
  return loop.Every(kTick, [this] { Step(); });
}

// What was heard is written to the line before the loudspeaker reads from it.
void VoiceService::Step() {
  if (reader_) reader_->Step();
  if (speaker_) speaker_->Step();
  if (loop_ != nullptr && reader_) Watch();
}

void VoiceService::Use(const GateSettings& gate, const DelaySetting& delay) {
  if (reader_) reader_->Use(gate);
  if (speaker_) speaker_->Use(delay);
}

// Watches the microphone that is open now; another one has another descriptor.
void VoiceService::Watch() {
  if (watched_ == reader_->pollable() && opened_ == reader_->opened()) return;
  if (watched_ >= 0) loop_->Forget(watched_);
  watched_ = reader_->pollable();
  opened_ = reader_->opened();
  if (watched_ < 0) return;
  if (auto ok = loop_->Watch(watched_, [this] { Step(); }); !ok) LogWarning("{}", ok.error().message());
}

}  // namespace kaori::voice
