// The picture that a box shows on its screens before the stage runs: made once, with the image.
#pragma once

#include <filesystem>

#include "appliance/programs/stage/studio.h"
#include "drivers/base/clock.h"

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

}  // namespace kaori::stage
