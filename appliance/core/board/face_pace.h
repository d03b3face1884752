// Has the work beside the face rest where it costs the face frames.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "drivers/base/clock.h"

namespace kaori::board {

// Copies, checks and trials share the processors, the memory and the disk with the stage. The lowest priority alone does not
// keep its rate where the processors draw: what the kernel does for such work is done at the kernel's own priority, and
// caches are shared. So the work is done by turns. Frames are counted while it works and while it rests, and the share of
// the time in which it works is chosen so that the face keeps kKept of its rate on the whole; where the work costs nothing,
// it rests just often enough to know that. It always goes on, if slowly: where it has to be done in pieces of many seconds, or
// halts the face, that keeps less. Two programs that work at once each take what one may. One thread.
class FacePace {
 public:
  // Whether the work may go on at `now`. `frames` counts the stage's, as StageStatus has them; where it stands still there is
  // no stage, and nothing to rest for. To be asked before each small piece of work, and a few times a second while it rests.
  // Whoever has not asked for kForgets begins anew, with a rest; other work than before, which may cost more, has a FacePace of
  // its own.
  bool MayWork(std::uint32_t frames, Time now);

  // Of the face's rate while it rests, on the mean over the whole work.
  static constexpr double kKept = 0.965;
  // Of the time.
  static constexpr double kLeastShare = 0.1;
  static constexpr double kMostShare = 0.9;
  // A turn of either kind is so long at least, has so many frames, and ends with one, so that its rate is known; frames that
  // do not come in kWaits are not waited for.
  static constexpr Duration kShortestTurn = std::chrono::seconds(1);
  static constexpr std::uint32_t kTurnFrames = 8;
  static constexpr Duration kWaits = std::chrono::seconds(10);
  // The work may become dearer while it is done, and people look at how far it is.
  static constexpr Duration kLongestWork = std::chrono::seconds(10);
  static constexpr Duration kLongestRest = std::chrono::minutes(1);
  static constexpr Duration kForgets = std::chrono::seconds(10);

 private:
  // Frames and time of one kind of turns, of which the older ones count less.
  struct Counted {
    double frames = 0;
    double s = 0;
    void Add(std::uint32_t more_frames, Duration in);
    double Rate() const { return s > 0 ? frames / s : 0; }
  };

  void Begin(std::uint32_t frames, Time now);
  bool IsTurnOver(std::uint32_t frames, Time now) const;
  // Ends the turn that is on, and begins one of the other kind.
  void Turn(std::uint32_t frames, Time now);
  // Of the time, in which to work.
  double Share() const;

  bool works_ = false;
  // There were frames in the last rest.
  bool is_drawn_ = true;
  // The turn that is on: when and at which frame it began, and how long it is to be.
  Time began_{};
  std::uint32_t frames_at_ = 0;
  Duration length_{};
  // The last question.
  Time asked_{};
  std::uint32_t frames_then_ = 0;
  Counted working_, resting_;
};

// Asks one FacePace by the board at `path` and the machine's clock: whether the work may go on now. True where there is no
// board, or no stage has written it; a board that cannot be read is named in the log once. It is opened for each question, as
// it may be made anew meanwhile; blocks for the file system. Copies ask the same FacePace; all of them are one thread's.
std::function<bool()> PaceByBoardAt(std::string path);

}  // namespace kaori::board
