// The recorded sound of registered motions, in time with their curves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "appliance/core/board/board.h"
#include "appliance/core/show/show.h"
#include "drivers/base/clock.h"

namespace kaori::voice {

// Sounds of the motion that plays by the board: its first frame is heard when the motion's beginning comes to
// light, or as soon after it as the loudspeaker can. One thread. Allocates nothing.
class MotionSound {
 public:
  // One clip for each take of the show, empty for those without a sound.
  explicit MotionSound(std::vector<show::Sound> clips) : clips_(std::move(clips)) {}

  // What the board says now.
  void Follow(const board::Stamped<board::MotionNow>& now);

  // Adds to frames of two channels, left and right, -1 .. 1, the first of which is heard at `heard_at`.
  void Mix(std::span<float> frames, Time heard_at);

  bool sounding() const { return now_.clip != nullptr || before_.clip != nullptr; }

 private:
  struct Needle {
    const show::Sound* clip = nullptr;
    std::int64_t place = 0;  // In frames of the clip.
    float gain = 0;
    float gain_step = 0;  // For each frame: rises to 1, or falls to 0.
    bool AddFrame(float& left, float& right);
  };
  void Start(Time heard_at);
  void CutOff(float step);

  std::vector<show::Sound> clips_;
  std::int32_t take_ = -1;
  std::uint32_t starts_ = 0;
  bool known_ = false;    // What played before this program began is not joined in the middle of a word.
  bool pending_ = false;  // The take's sound has not begun yet.
  Time began_{};
  Needle now_, before_;
};

}  // namespace kaori::voice
