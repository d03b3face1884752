// What is on stage, and where the cue list stands, read from the box's board. For the page that people look
// at: no simulated device knows of it, as no real one would.
#pragma once

#include <optional>
#include <string>

#include "appliance/core/board/board.h"
#include "drivers/base/clock.h"
#include "drivers/base/json.h"

namespace kaori::sim {

// Maps the board for reading and copies four sections out of it. One thread. Reads only:
// the board is neither made nor changed.
class StageMonitor {
 public:
  // `board` is the file that the box's programs share; it need not be there yet. Borrows the clock.
  StageMonitor(std::string board, const Clock& clock) : path_(std::move(board)), clock_(clock) {}

  // What is on stage, as the page reads it; null while no stage draws:
  //   {"scene","style","cue","standby","pending":numbers, "left_s":seconds,
  //    "paused","panicking","black","waiting":bools, "refused":count, "sheet":number,
  //    "levels":[[value,owner,role]..],
  //    "locked":bool, "locked_out":count, "check":null or {"running":bool,"summary":words,"items":[[device,words,state]..]},
  //    "lobby":word or "", "lobby_hours":word or "",
  //    "learn":null or {"phase","choice":numbers,"control":words,"inverted","instead":bools,"restless":words,"ambiguous":bool,"counts":number},
  //    "role_devices":[number..],
  //    "motions":[[number,seconds,ends]..], "midi":[[count,device,words,dial,button]..]}
  // They are board::StageStatus's and board::ShowNow's of the same names: all count from 0, and -1 is no cue.
  // Of motions those that play are there. Of MIDI messages the newest is last; each has the number under which it was
  // counted, and -1 where it is for no dial or no button.
  // Does not block; where there is no board, or a stage that has been silent for two seconds, the file is
  // looked for anew once a second.
  json::Value Read();

 private:
  struct Now {
    board::StageStatus status;
    board::ShowNow show;
    board::Stamped<board::LineCheck> check;
    board::Stamped<board::Learn> learn;
    board::MidiHeard midi;
  };
  // The sections as a stage that draws wrote them last.
  std::optional<Now> Look();

  std::string path_;
  const Clock& clock_;
  // Mapped for reading; none while there is no file.
  std::optional<board::Board> board_;
  // When the file is looked for again.
  Time look_at_{};
};

}  // namespace kaori::sim
