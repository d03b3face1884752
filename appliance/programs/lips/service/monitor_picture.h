// Draws the camera's picture for the operators' monitor, where there is one.
#pragma once

#include <string>

#include "appliance/core/board/lip_picture.h"
#include "appliance/programs/lips/paint_key.h"
#include "drivers/base/clock.h"
#include "drivers/decode/planes.h"

namespace kaori::lips {

// One thread. To be called with every picture; most of them cost nothing.
class MonitorPicture {
 public:
  // `board` is the path of the board's file.
  explicit MonitorPicture(const std::string& board) : writer_(board::LipPicturePath(board)) {}

  // The planes are borrowed for the call. `at` is when they were exposed.
  void Offer(const decode::Planes& planes, const PaintKey& key, Time at, Time now);

 private:
  board::LipPictureWriter writer_;
  board::LipPicture picture_;  // Kept for its memory.
};

}  // namespace kaori::lips
