// An evening in which everything happens to the lip camera that may, in simulated time: how long the mouth of
// the face is without it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "drivers/base/clock.h"
#include "drivers/ports/camera.h"

namespace kaori::lips {

enum class Fault : std::uint8_t {
  kStall,    // The stream stands still.
  kGone,     // The cable is out.
  kIoError,  // The stream breaks, and is good again when opened anew.
  kBusy,     // The same, and another program has the camera for a while.
  kTorn,     // Every frame is damaged on its way.
  kGarbage,  // Every frame is noise.
  kCovered,
  kDrops,      // Every second frame is lost.
  kNewFormat,  // Another size from now on.
  kTimeJump,   // Stamps of another time.
};
const char* NameOf(Fault fault);
bool TakesTheLips(Fault fault);  // While it lasts.

// A lip camera before open lips, and what spoils its picture. Its time is the clock that it was made with.
class SpoiltCamera {
 public:
  virtual ~SpoiltCamera() = default;
  virtual Result<std::unique_ptr<ports::Camera>> Open() = 0;
  virtual std::span<const Fault> faults() const = 0;  // That can befall it.
  virtual void Begin(Fault fault, std::uint32_t how) = 0;
  virtual void End() = 0;
  virtual bool Tick() = 0;  // Does what is due; whether a frame came.
};
std::unique_ptr<SpoiltCamera> MakeSpoiltLocalCamera(const std::filesystem::path& folder, const Clock& clock);
std::unique_ptr<SpoiltCamera> MakeSpoiltV4l2Camera(const Clock& clock);

struct Evening {
  int faults = 60;
  std::uint32_t seed = 1;
  bool waits_for_ever = false;  // A driver without a deadline: it comes back when there is a frame.
};

// The worst of the evening, and what it was.
struct FaultReport {
  int faults = 0;
  double to_voice_ms = 0;  // From the fault to a mouth that is on its way to the voice,
  double to_rest_ms = 0;   // and to lips that count as lost, so that without a voice the mouth goes to rest.
  double back_ms = 0;      // From the fault's end to a mouth that stays with the lips.
  double strayed = 0;      // While the lips were not lost: how far the mouth left them, of its opening.
  std::string to_voice_by, to_rest_by, back_by, strayed_by;
};
FaultReport Spend(const Evening& evening, SpoiltCamera& camera, ManualClock& clock);

}  // namespace kaori::lips
