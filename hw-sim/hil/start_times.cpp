#include "hw-sim/hil/start_times.h"

#include "hw-sim/hil/picture.h"

namespace kaori::hil {
namespace {

// A machine that starts in the usual way, on a busy computer.
constexpr Duration kLongestFirstFace = std::chrono::minutes(15);
constexpr Duration kLookAtScreen = std::chrono::milliseconds(100);
// Of 4096. QEMU's own text on a screen that nobody has lit has fewer.
constexpr int kColoursOfAPicture = 100;

}  // namespace

// A picture that cannot be taken shows nothing: callers ask again.
bool ShowsAnyPicture(Target& target, const std::string& shot) {
  if (!target.machine().Shoot(0, shot)) return false;
  const auto picture = LookAt(shot);
  return picture && picture->colours >= kColoursOfAPicture;
}

// Times are those of this computer's clock, from `began`, and as coarse as the looks at screen and log.
Result<StartTimes> AwaitStart(Target& target, Time began, const std::string& shot) {
  StartTimes times;
  while (target.clock().now() - began < kLongestFirstFace && target.machine().runs()) {
    if (times.light_s == 0 && ShowsAnyPicture(target, shot))
      times.light_s = Seconds(target.clock().now() - began);
    if (target.UntilFirstPicture(kLookAtScreen)) {
      times.face_s = Seconds(target.clock().now() - began);
      // Looks at the screen were too seldom to see the still: the face came first.
      if (times.light_s == 0) times.light_s = times.face_s;
      return times;
    }
  }
  if (!target.machine().runs()) return Fail(std::errc::no_such_device, "wait for the first face");
  return Fail(std::errc::timed_out, "wait for the first face");
}

}  // namespace kaori::hil
