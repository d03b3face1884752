// Wakes the lip reader when its camera speaks.
#pragma once

#include "appliance/programs/lips/lip_reader.h"
#include "drivers/base/event_loop.h"

namespace kaori::lips {

// Borrows both for its life.
class LipWatch {
 public:
  LipWatch(LipReader& reader, EventLoop& loop) : reader_(reader), loop_(loop) {}

  // Reads, and watches what is open now: another camera is another descriptor.
  void Step();

 private:
  LipReader& reader_;
  EventLoop& loop_;
  int watched_ = -1;
  int opened_ = 0;
};

}  // namespace kaori::lips
