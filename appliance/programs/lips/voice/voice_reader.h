// From the microphone to the board: opens it, hears each block, and outlives everything a microphone does.
#pragma once

#include <functional>
#include <memory>
#include <string_view>

#include "appliance/core/board/board.h"
#include "appliance/programs/lips/voice/listener.h"
#include "appliance/programs/lips/voice/voice_mouth.h"
#include "drivers/base/clock.h"
#include "drivers/base/silence_log.h"
#include "drivers/ports/microphone.h"

namespace kaori::voice {

// One thread. Silence of 200 ms, or a microphone that is gone, makes the section stale. One that is gone is
// opened anew every 250 ms, and one that has given nothing for 2 s as well.
class VoiceReader {
 public:
  // Hears every block, as it came from the microphone.
  using Ear = std::function<void(const ports::SoundBlock&, const ports::SoundFormat&)>;

  // Borrows the clock. `ear` may be empty.
  VoiceReader(ports::MicrophoneOpener open, board::Writer<board::Voice> writer, const GateSettings& gate,
              const Clock& clock, Ear ear);

  // Does everything that waits; never blocks. Call it when pollable() is readable, and every 50 ms or sooner.
  void Step();

  // From the next block on.
  void Use(const GateSettings& gate) { listener_.Use(gate); }

  // Of the microphone that is open; -1 while none is. Another may have the same number: see opened().
  int pollable() const { return microphone_ ? microphone_->pollable() : -1; }
  int opened() const { return opened_; }

 private:
  void TryOpen(Time now);
  void ReadBlocks(Time now);
  void Hear(const ports::SoundBlock& block, Time now);
  void Close(Time now, std::string_view why);
  void CheckSilence(Time now);

  ports::MicrophoneOpener open_;
  board::Writer<board::Voice> writer_;
  const Clock& clock_;
  Ear ear_;
  Listener listener_;
  VoiceMouth mouth_;
  std::unique_ptr<ports::Microphone> microphone_;
  board::SourceState source_ = board::SourceState::kAbsent;
  Time last_block_;  // When the newest block came, or the microphone was opened.
  Time heard_at_{};  // The stamp of what is on the board.
  Time retry_at_{};
  SilenceLog silence_log_{"microphone", "the voice is stale"};
  std::errc logged_{};  // The last trouble that was logged: the same again is not.
  int opened_ = 0;
};

}  // namespace kaori::voice
