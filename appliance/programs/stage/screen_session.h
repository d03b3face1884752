// The stage before its screen: looks for one, watches it while it is there, and wakes the stage for each
// frame.
#pragma once

#include <functional>
#include <memory>

#include "appliance/programs/stage/stage.h"
#include "drivers/base/alarm.h"
#include "drivers/base/event_loop.h"
#include "drivers/ports/scanout.h"

namespace kaori::stage {

// One thread, that of the loop; the stage and the loop must outlive it. With a screen the stage steps when a
// flip is reported and when the alarm rings for its next frame; without one it moves 30 times a second, and a
// screen is looked for four times a second.
class ScreenSession {
 public:
  // Opens the screen that is there now; fails while there is none, which is expected and not logged. May
  // block for the kernel's mode setting, some tens of milliseconds. The session owns what it gives, by way of
  // the stage.
  using Open = std::function<Result<std::unique_ptr<ports::Scanout>>()>;

  ScreenSession(Stage& stage, EventLoop& loop, Alarm alarm, Open open)
      : stage_(stage), loop_(loop), alarm_(std::move(alarm)), open_(std::move(open)) {}

  // From now on the loop plays the stage, with a screen and without. Draws the first picture where a screen
  // is there. Errors: those of EventLoop::Watch and EventLoop::Every.
  Result<void> Begin();

 private:
  // Looks for a screen where there is none, else steps the stage.
  void Look();
  // Gives the screen to the stage and watches its descriptor.
  void Watch(std::unique_ptr<ports::Scanout> screen);
  // Steps the stage and sets the alarm for its next frame.
  void Step();

  Stage& stage_;
  EventLoop& loop_;
  Alarm alarm_;
  Open open_;
  int watched_ = -1;
};

}  // namespace kaori::stage
