// The picture that a box shows on its screens before the stage runs: made once, with the image.
#pragma once

#include <filesystem>

#include "appliance/programs/stage/studio.h"
#include "drivers/base/clock.h"
#include "drivers/base/event_loop.h"

namespace kaori::stage {

// A clock that stands still until it is let go, so that the first picture is the show's first moment,
// whenever it is drawn. One thread.
class StillClock final : public Clock {
 public:
  explicit StillClock(bool stands) : began_(clock_.now()), stands_(stands) {}
  Time now() const override { return stands_ ? began_ : clock_.now(); }
  void LetGo() { stands_ = false; }

 private:
  SteadyClock clock_;
  Time began_;
  bool stands_;
};

// Writes what the studio drew last as a PPM; of more than 960 pixels in width, a smaller one. Errors:
//   no_such_device  nothing was drawn: there is no screen
//   those of WriteWholeFile
Result<void> WriteStill(Studio& studio, const std::filesystem::path& file);

// Where pictures of what is shown go.
struct StillFiles {
  // Written once; empty: not.
  std::filesystem::path once{};
  // `looked` is written anew each second while the file `wanted` is there; empty: never. A new version of the box's
  // system is judged by it (kaori-update).
  std::filesystem::path wanted{};
  std::filesystem::path looked{};
};

// The picture is read back from the graphics card on the loop's thread, which takes some milliseconds: it is asked for only
// in the minutes of a trial, in which nobody plays.
//
// Writes `once`, and has the loop write the other. The studio must outlive the loop. Errors: those of WriteStill for
// `once`, and of EventLoop::Every.
Result<void> WriteStills(Studio& studio, const StillFiles& files, EventLoop& loop);

}  // namespace kaori::stage
