// Runs microphone and loudspeaker in the program's event loop.
//
//   microphone -> VoiceReader -> Listener (level, gate, vowel) -> VoiceMouth -> section `voice`
//                             -> DelayLine -> Speaker (with MotionSound) -> loudspeaker, section `sound`
//
// The mouth that the voice would make is on the board at once; the voice itself is played as late as the
// stage shows the operator's mouth, so that the audience sees and hears them together.
#pragma once

#include <memory>
#include <optional>

#include "appliance/programs/lips/voice/speaker.h"
#include "appliance/programs/lips/voice/voice_reader.h"
#include "drivers/base/event_loop.h"

namespace kaori::voice {

// How the devices are opened; an empty opener means that the box has no such device. Openers are called again
// and again by reader and speaker, on the loop's thread.
struct SoundSources {
  ports::MicrophoneOpener microphone;
  ports::LoudspeakerOpener loudspeaker;
};

struct VoiceServiceSettings {
  GateSettings gate;
  SpeakerSettings speaker;
};

// Used by one thread. It stays at its address after Join, since the loop calls back into it.
class VoiceService {
 public:
  // Acquires the sections of the devices that there are. Borrows the board and the clock, which outlive it.
  // Errors: those of Board::AcquireWriter.
  static Result<std::unique_ptr<VoiceService>> Acquire(SoundSources sources, VoiceServiceSettings settings,
                                                       const board::Board& board, const Clock& clock);

  // Runs Step() for the microphone's blocks and every 10 ms. The loop outlives the service. Errors: those of
  // the loop.
  Result<void> Join(EventLoop& loop);

  // Handles what waits and what is due. It never blocks, apart from the time that opening a device needs.
  // Call it every 10 ms or sooner.
  void Step();

  // Changes the settings of gate and delay from now on.
  void Use(const GateSettings& gate, const DelaySetting& delay);

 private:
  // Watches the microphone that is open now.
  void Watch();

  // Null where the box has no such device. The reader calls the speaker, and so is destroyed first.
  std::unique_ptr<Speaker> speaker_;
  std::unique_ptr<VoiceReader> reader_;
  EventLoop* loop_ = nullptr;
  int watched_ = -1;
  int opened_ = 0;
};

}  // namespace kaori::voice
