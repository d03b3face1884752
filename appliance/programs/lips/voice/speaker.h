// From the voice to the loudspeaker, as late as the picture of the mouth; recovers from every failure of the
// device.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "appliance/core/board/board.h"
#include "appliance/programs/lips/voice/delay_choice.h"
#include "appliance/programs/lips/voice/delay_line.h"
#include "appliance/programs/lips/voice/motion_sound.h"
#include "drivers/base/clock.h"
#include "drivers/base/reopening.h"
#include "drivers/ports/loudspeaker.h"

namespace kaori::voice {

// How late the voice is, and what motions sound like.
struct SpeakerSettings {
  DelaySetting delay;
  std::vector<show::Sound> clips;  // One for each motion of the show; empty for a motion without a sound.
};

// Used by one thread. A loudspeaker that is gone is opened again every 250 ms, and less often where it opens and
// plays nothing (Reopening). Meanwhile the voice is recorded, and it is in time when the loudspeaker is back.
class Speaker {
 public:
  // Goes on from what `board` holds. Borrows the board and the clock, which outlive it.
  Speaker(ports::LoudspeakerOpener open, const board::Board& board, board::Writer<board::Sound> writer,
          SpeakerSettings settings, const Clock& clock);

  // Records a block of the microphone. Without waiting; the samples are borrowed for the call.
  void Record(const ports::SoundBlock& block, const ports::SoundFormat& format) {
    line_.Write(block, format);
  }

  // Changes the delay's setting.
  void Use(const DelaySetting& delay) { choice_.Use(delay); }

  // Writes what the loudspeaker needs until the next call. It never blocks, apart from the time that opening
  // the device needs. Call it every 10 ms or sooner.
  void Step();

 private:
  static constexpr std::size_t kChunk = 120;  // Frames: 2.5 ms.

  // Tries to open the loudspeaker.
  void TryOpen();
  // Writes chunks until enough sound waits in the device.
  void Fill(Time now);
  // Writes one chunk; false where the device has no room for all of it now.
  bool WriteChunk();
  // Makes the next chunk of voice and motions, for the time at which it will be heard.
  void Mix();
  // Hands the device what is left of the chunk.
  bool Push();
  // Learns from a write when the next frame will be heard.
  void NotePlayout(const ports::Playout& playout);
  // The device failed: the section becomes stale and the device is opened again.
  void Close(const Error& why);
  // Writes the section `sound`, ten times a second.
  void Publish(Time now);
  void LogDelay();

  // Opens the loudspeaker anew each time; what it gives is owned by loudspeaker_.
  ports::LoudspeakerOpener open_;
  const board::Board& board_;
  board::Writer<board::Sound> writer_;
  const Clock& clock_;
  DelayChoice choice_;
  // The voice on its way, filled by Record whether a loudspeaker is there or not.
  DelayLine line_;
  MotionSound motion_sound_;
  Reopening reopening_;
  std::unique_ptr<ports::Loudspeaker> loudspeaker_;
  std::optional<Time> heard_next_;  // When the next frame will be heard; empty while that is unknown.
  Duration lead_{};                 // How much sound waits in the device,
  Time filled_at_{};                // and when it was last filled up to that.
  Duration depth_{};                // The device's own latency, from a write until it is heard.
  // The voice of one chunk, and the chunk with all that sounds in it, left and right.
  std::array<float, kChunk> voice_{};
  std::array<float, 2 * kChunk> mixed_{};
  std::vector<std::int16_t> chunk_;  // From `pushed_` on the device has not accepted it yet.
  std::size_t pushed_ = 0;
  board::Sound sound_;
  // Of the section: live from the first frames that the device accepts, stale when it is gone.
  board::SourceState source_ = board::SourceState::kAbsent;
  Time opened_at_{};
  Duration accepted_{};  // Of sound, since then.
  bool told_that_it_plays_ = false;
  Time published_at_{};
  Time stuck_since_{};  // The device accepted nothing since then.
  Duration logged_delay_{};
  Time log_delay_after_{};
};

}  // namespace kaori::voice
