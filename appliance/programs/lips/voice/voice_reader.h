// From the microphone to the board: opens the device, processes each block, and recovers from every failure
// of it.
#pragma once

#include <functional>
#include <memory>

#include "appliance/core/board/board.h"
#include "appliance/programs/lips/voice/listener.h"
#include "appliance/programs/lips/voice/voice_mouth.h"
#include "drivers/base/clock.h"
#include "drivers/base/reopening.h"
#include "drivers/base/silence_log.h"
#include "drivers/ports/microphone.h"

namespace kaori::voice {

// Used by one thread. After 200 ms without a block, or when the microphone is gone, the section becomes
// stale. A microphone that is gone, or that sent nothing for 2 s, is opened again after 250 ms, and less often where
// it opens and sends nothing (Reopening). A stream in another format than 48 kHz with one or two channels is closed
// like one that failed.
class VoiceReader {
 public:
  // Called with every block of the microphone, which is valid during the call only.
  using BlockHandler = std::function<void(const ports::SoundBlock&, const ports::SoundFormat&)>;

  // Borrows the clock. `handler` may be empty.
  VoiceReader(ports::MicrophoneOpener open, board::Writer<board::Voice> writer, const GateSettings& gate,
              const Clock& clock, BlockHandler handler);

  // Handles the blocks that wait and what is due. It never blocks, apart from the time that opening the
  // device needs. Call it when pollable() is readable, and every 50 ms or sooner.
  void Step();

  // Changes the gate's settings from the next block on.
  void Use(const GateSettings& gate) { listener_.Use(gate); }

  // The descriptor of the open microphone; -1 while none is open. Another microphone may have the same
  // number: see opened(), which counts the openings.
  int pollable() const { return microphone_ ? microphone_->pollable() : -1; }
  int opened() const { return opened_; }

 private:
  // Tries to open the microphone.
  void TryOpen();
  // Processes the blocks that wait, 64 at most.
  void ReadBlocks(Time now);
  // One block: to the listener, the handler, and the board.
  void Process(const ports::SoundBlock& block, Time now);
  // The microphone failed: the section becomes stale and the device is opened again.
  void Close(const Error& why);
  // A microphone that sends nothing: stale after 200 ms, opened again after 2 s.
  void CheckSilence(Time now);

  ports::MicrophoneOpener open_;
  board::Writer<board::Voice> writer_;
  const Clock& clock_;
  // Who gets each block besides: the speaker. May be empty.
  BlockHandler handler_;
  Listener listener_;
  VoiceMouth mouth_;
  std::unique_ptr<ports::Microphone> microphone_;
  Reopening reopening_;
  board::SourceState source_ = board::SourceState::kAbsent;
  Time last_block_;  // When the newest block arrived, or the microphone was opened.
  Time heard_at_{};  // The time of the value on the board.
  SilenceLog silence_log_{"microphone", "the voice is stale"};
  int opened_ = 0;
};

}  // namespace kaori::voice
