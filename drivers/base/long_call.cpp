#include "drivers/base/long_call.h"

#include "drivers/base/log.h"
#include "drivers/base/service.h"

namespace kaori {
namespace {

// More than two transfers that wait for 5 s each, and more than what raw MIDI waits.
constexpr Duration kLongestCall = std::chrono::seconds(12);
// Five tries of 30 s for a block that cannot be read (SCSI's own limits) are half of it; a stick of 1 MiB a second writes
// in that time what a box of 2 GiB lets stand in memory.
constexpr Duration kSlowDisk = std::chrono::minutes(5);

}  // namespace

void ExpectLongCall() {
  ExpectLongCall(kLongestCall);
}

void ExpectSlowDisk() {
  ExpectLongCall(kSlowDisk);
}

void ExpectLongCall(Duration longest) {
  if (auto told = service::AllowSilence(longest); !told) LogWarning("{}", told.error().message());
}

}  // namespace kaori
