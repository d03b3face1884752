// The line check: what every control, camera, microphone, loudspeaker, lamp and screen of the show has done
// since it began.
//
// It only looks: the stage takes what people do out of the show meanwhile, so that nothing which is moved
// moves the face.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "appliance/core/board/line_check.h"
#include "appliance/core/board/snapshot.h"
#include "appliance/core/linecheck/trace.h"
#include "appliance/core/show/show.h"

namespace kaori::linecheck {

// What one look sees.
struct View {
  const board::Snapshot& board;
  // Of the loudspeaker: blocks that were played, and underruns, both counted since kaori-lips began.
  const board::Stamped<board::Sound>& sound;
  std::uint32_t screens = 0;  // Bit n: something is plugged in at screen n.
};

// One thread. Allocates nothing; time is an argument and does not go back.
class LineCheck {
 public:
  // Begins anew with these items (ItemsFor), none of which was seen.
  void Begin(const board::LineCheck& items, const View& view, Time now);
  // To be called once a frame while it runs.
  void Look(const View& view, Time now);
  // A person has seen all lamps lit. Does nothing where there are none.
  void ConfirmLamps(Time now);
  // The result stays as it is, for whoever reads the board.
  void End() { result_.phase = board::LineCheckPhase::kEnded; }

  bool running() const { return result_.phase == board::LineCheckPhase::kRunning; }
  // As it is told on the board.
  const board::LineCheck& result() const { return result_; }
  // When something was seen, or failed, last: a check that nobody works at any more is to end.
  Time changed_at() const { return changed_at_; }

  // All lamps light in turn, a fifth of a second each, from the beginning on; then those of the buttons that
  // are not seen yet stay lit, and go out as they are pushed; then they light in turn again. Bit n is button
  // n.
  std::uint32_t lamps(Time now) const;

 private:
  // What is remembered of one item; which of it is used says its kind.
  struct Memory {
    Way way;
    Contact contact;
    Pulse pulse;
    bool heard = false;       // A voice, or a voice that was played.
    Time quiet_at{};          // When a microphone was last quiet.
    std::uint32_t xruns = 0;  // When the check began.
  };
  // Each item is looked at by its kind: StateOf says how it stands, and writes what a person reads of it into the item
  // (how far it went, what it was last). An item that was seen once stays seen; one that fails later is shown as failed.
  void BeginItem(const board::CheckedItem& item, Memory& memory, const View& view, Time now) const;
  board::CheckedState StateOf(board::CheckedItem& item, Memory& memory, const View& view, Time now) const;
  board::CheckedState StateOfWay(board::CheckedItem& item, Memory& memory, const View& view, Time now) const;
  board::CheckedState StateOfContact(const board::CheckedItem& item, Memory& memory, const View& view,
                                     Time now) const;
  board::CheckedState StateOfCamera(board::CheckedItem& item, Memory& memory, const View& view,
                                    Time now) const;
  board::CheckedState StateOfVoice(board::CheckedItem& item, Memory& memory, const View& view,
                                   Time now) const;
  board::CheckedState StateOfSound(Memory& memory, const View& view) const;

  board::LineCheck result_;
  // By the number of the item in `result_`.
  std::array<Memory, board::LineCheck::kMostItems> memories_{};
  std::array<std::int32_t, 8> counts_{};  // Of the dials when it began.
  Time began_at_{}, changed_at_{};
};

}  // namespace kaori::linecheck
