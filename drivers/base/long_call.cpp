#include "drivers/base/long_call.h"

#include "drivers/base/log.h"
#include "drivers/base/service.h"

namespace kaori {
namespace {

// More than two transfers that wait for 5 s each, and more than what raw MIDI waits.
constexpr Duration kLongestCall = std::chrono::seconds(12);

}  // namespace

void ExpectLongCall() {
  if (auto told = service::AllowSilence(kLongestCall); !told) LogWarning("{}", told.error().message());
}

}  // namespace kaori
