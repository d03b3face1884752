#include "appliance/programs/stage/screen_session.h"

#include <utility>

#include "drivers/base/log.h"

namespace kaori::stage {
namespace {

using namespace std::chrono_literals;

constexpr Duration kUnseenPeriod = 33ms;  // Without a screen: often enough for lamps.
constexpr Duration kLookPeriod = 250ms;   // How often a screen that is gone is looked for.

}  // namespace

// The first look is made before anything is watched, so that the first picture is drawn as soon as possible.
// Both timers run always; the step of an unseen stage does nothing while there is a screen.
Result<void> ScreenSession::Begin() {
  const auto unseen = [this] {
    if (!stage_.has_screen()) stage_.StepUnseen();
  };
  const auto wake = [this] {
    alarm_.Acknowledge();
    Step();
  };
  Look();
  if (auto ok = loop_.Watch(alarm_.pollable(), wake); !ok) return ok;
  if (auto ok = loop_.Every(kUnseenPeriod, unseen); !ok) return ok;
  return loop_.Every(kLookPeriod, [this] { Look(); });
}

// A screen that is there is asked too: one that was unplugged may send nothing more.
void ScreenSession::Look() {
  if (stage_.has_screen()) return Step();
  auto screen = open_();
  if (screen) Watch(std::move(*screen));  // None is expected while nobody has plugged one in.
}

// Where the loop cannot watch the screen, the look every 250 ms still serves it, slowly.
void ScreenSession::Watch(std::unique_ptr<ports::Scanout> screen) {
  Log("a screen is plugged in");
  watched_ = screen->pollable();
  stage_.SetScreen(std::move(screen));
  if (auto ok = loop_.Watch(watched_, [this] { Step(); }); !ok) LogWarning("{}", ok.error().message());
  Step();
}

// A stage that has let its screen go is watched no longer; the descriptor is closed already, and the loop
// forgets the number.
void ScreenSession::Step() {
  stage_.Step();
  if (!stage_.has_screen()) return loop_.Forget(watched_);
  if (const auto at = stage_.wakes_at()) alarm_.Set(*at);
}

}  // namespace kaori::stage
