#include "appliance/programs/lips/lip_watch.h"

#include "drivers/base/log.h"

namespace kaori::lips {

// The count of openings is compared besides the number of the descriptor, since the kernel gives a number
// that was just freed to the next file.
void LipWatch::Step() {
  reader_.Step();
  if (watched_ == reader_.pollable() && opened_ == reader_.opened()) return;
  if (watched_ >= 0) loop_.Forget(watched_);
  watched_ = reader_.pollable();
  opened_ = reader_.opened();
  if (watched_ < 0) return;
  if (auto ok = loop_.Watch(watched_, [this] { Step(); }); !ok) LogWarning("{}", ok.error().message());
}

}  // namespace kaori::lips
