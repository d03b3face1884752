// Microphone and loudspeaker at the program's loop.
#pragma once

#include <memory>
#include <optional>

#include "appliance/programs/lips/voice/speaker.h"
#include "appliance/programs/lips/voice/voice_reader.h"
#include "drivers/base/event_loop.h"

namespace kaori::voice {

// What is empty is not there.
struct SoundSources {
  ports::MicrophoneOpener microphone;
  ports::LoudspeakerOpener loudspeaker;
};

struct VoiceSeatSettings {
  GateSettings gate;
  SpeakerSettings speaker;
};

// One thread.
class VoiceSeat {
 public:
  // Takes the sections of what is there. Borrows the board and the clock. Errors: as Board::AcquireWriter.
  static Result<std::unique_ptr<VoiceSeat>> Acquire(SoundSources sources, VoiceSeatSettings settings,
                                                 const board::Board& board, const Clock& clock);

  // Wakes with the microphone's blocks and every 10 ms. The loop outlives the seat. Errors: those of the
  // loop.
  Result<void> Join(EventLoop& loop);

  // Does everything that waits; never blocks. Call it every 10 ms or sooner.
  void Step();

  // Another gate, another delay, from now on.
  void Use(const GateSettings& gate, const DelayWish& delay);

 private:
  void Watch();

  std::unique_ptr<Speaker> speaker_;
  std::unique_ptr<VoiceReader> reader_;
  EventLoop* loop_ = nullptr;
  int watched_ = -1;
  int opened_ = 0;
};

}  // namespace kaori::voice
