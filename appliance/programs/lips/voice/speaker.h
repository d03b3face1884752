// From the voice to the loudspeaker, later by as much as the mouth is; outlives everything a loudspeaker
// does.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "appliance/core/board/board.h"
#include "appliance/programs/lips/voice/delay_choice.h"
#include "appliance/programs/lips/voice/sound_line.h"
#include "appliance/programs/lips/voice/motion_sound.h"
#include "drivers/base/clock.h"
#include "drivers/ports/loudspeaker.h"

namespace kaori::voice {

struct SpeakerSettings {
  DelayWish delay;
  std::vector<show::Sound> clips;  // One for each take of the show.
};

// One thread. A loudspeaker that is gone is opened anew every 250 ms; meanwhile the voice is heard on, and is
// in time again when it returns.
class Speaker {
 public:
  // Goes on from what `board` holds. Borrows the board and the clock.
  Speaker(ports::LoudspeakerOpener open, const board::Board& board, board::Writer<board::Sound> writer,
          SpeakerSettings settings, const Clock& clock);

  // A block of the microphone.
  void Hear(const ports::SoundBlock& block, const ports::SoundFormat& format) { line_.Hear(block, format); }

  void Use(const DelayWish& delay) { choice_.Use(delay); }

  // Gives the loudspeaker what it needs until the next call; never blocks. Call it every 10 ms or sooner.
  void Step();

 private:
  static constexpr std::size_t kChunk = 120;  // Frames: 2.5 ms.

  void TryOpen(Time now);
  void Fill(Time now);
  bool SpeakChunk();
  void Mix();
  bool Push();
  void NotePlayout(const ports::Playout& playout);
  void Close(Time now, std::string_view why);
  void Tell(Time now);
  void LogDelay();

  ports::LoudspeakerOpener open_;
  const board::Board& board_;
  board::Writer<board::Sound> writer_;
  const Clock& clock_;
  DelayChoice choice_;
  SoundLine line_;
  MotionSound takes_;
  std::unique_ptr<ports::Loudspeaker> loudspeaker_;
  std::optional<Time> heard_next_;  // When the next frame that is made will be heard; none: not yet known.
  Duration lead_{};                 // How much shall wait in the device,
  Time filled_at_{};                // and when that was seen to last.
  Duration depth_{};                // What the device itself holds, from a write to its sound.
  std::array<float, kChunk> voice_{};
  std::array<float, 2 * kChunk> mixed_{};
  std::vector<std::int16_t> chunk_;  // What the device has not taken yet, from `pushed_` on.
  std::size_t pushed_ = 0;
  board::Sound sound_;
  board::SourceState source_ = board::SourceState::kAbsent;
  Time retry_at_{};
  Time told_at_{};
  Time silent_since_{};  // The device took nothing since then.
  std::errc logged_{};
  Duration logged_delay_{};
  Time quiet_until_{};
};

}  // namespace kaori::voice
