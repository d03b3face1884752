// Runs the lip reader whenever its camera has a frame.
#pragma once

#include "appliance/programs/lips/lip_reader.h"
#include "drivers/base/event_loop.h"

namespace kaori::lips {

// Borrows the reader and the loop, which outlive it. One thread, that of the loop.
class LipWatch {
 public:
  LipWatch(LipReader& reader, EventLoop& loop) : reader_(reader), loop_(loop) {}

  // Runs a step of the reader, and watches the camera that is open afterwards; another camera has another
  // descriptor.
  void Step();

 private:
  LipReader& reader_;
  EventLoop& loop_;
  // The descriptor that the loop watches, and of which opening of the camera it is.
  int watched_ = -1;
  int opened_ = 0;
};

}  // namespace kaori::lips
