// The recorded sounds of registered motions, in time with their curves. The stage says on the board which
// motion stands where at which time; the sound follows that, also after the loudspeaker was gone for a while.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "appliance/core/board/board.h"
#include "appliance/core/show/show.h"
#include "drivers/base/clock.h"

namespace kaori::voice {

// Plays the sound of the motion that the board names. Its first frame is heard when the motion's beginning is
// presented, or as soon after that as the loudspeaker can. Used by one thread; it allocates nothing.
class MotionSound {
 public:
  // One clip for each motion of the show; motions without a sound have an empty one.
  explicit MotionSound(std::vector<show::Sound> clips) : clips_(std::move(clips)) {}

  // Follows the board's section. To be called in each step; a motion that began and was followed by another
  // in between is not heard. A motion whose number the show does not have is silent.
  void Follow(const board::Stamped<board::MotionNow>& now);

  // Adds the sound to frames of two channels, left and right, -1 .. 1, the first of which is heard at
  // `heard_at`.
  void Mix(std::span<float> frames, Time heard_at);

  bool sounding() const { return now_.clip != nullptr || before_.clip != nullptr; }

 private:
  struct Playback {
    const show::Sound* clip = nullptr;
    std::int64_t position = 0;  // In frames of the clip.
    float gain = 0;
    float gain_step = 0;  // Added to the gain at each frame, until it is 1 or 0.
    // Adds one frame. Returns false when the clip or its fade is over.
    bool AddFrame(float& left, float& right);
  };
  // Begins the clip that is pending, or moves one that is off, for a frame that is heard at this time.
  void Start(Time heard_at);
  // Lets the clip that plays fade out, by `step` a frame, beside the next one.
  void CutOff(float step);

  std::vector<show::Sound> clips_;
  // The motion that the board named last, and its count of starts.
  std::int32_t motion_ = -1;
  std::uint32_t starts_ = 0;
  bool known_ = false;    // The section was read: a motion that began before the program did stays silent.
  bool pending_ = false;  // The sound of the motion has not begun yet.
  // When the motion's beginning was presented.
  Time began_{};
  // The clip that plays, and the one that fades out.
  Playback now_, before_;
};

}  // namespace kaori::voice
