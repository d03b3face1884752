// A take: what an operator played, as it lies in a show's folder (takes/NAME.toml).
//
// What was played is kept whole. Trimming, stretching and looping only say how much of it is played, and how;
// so nothing is lost by them, and each can be taken back.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "appliance/core/show/motion.h"

namespace kaori::authoring {

// What a take may be.
inline constexpr float kSlowestTake = 4, kFastestTake = 0.25F;  // Times as long as it was played.
inline constexpr float kLongestEase_s = 5, kShortestEase_s = 0.05F;
inline constexpr float kLongestBlend_s = 10, kShortestBlend_s = 0.05F;
inline constexpr float kShortestTake_s = 0.2F;
inline constexpr float kShortestTakeLoop_s = 1;
// No take is called so: in a cue it means that motions end.
inline constexpr std::string_view kNoTakeName = "none";

// One channel of it.
struct TakeCurve {
  show::MotionTarget target = show::MotionTarget::kHeadYaw;
  std::string channel{};  // The name of an expression, where the target is a channel.
  // Seconds of the recording, which rise; degrees, centimetres or weights (CurveName::unit), so that a file
  // holds every bit.
  std::vector<show::MotionKey> keys{};
  int line = 0;  // Of the file from which it was read; 0: of none.
};

struct Take {
  std::string name{};   // That of its file.
  std::string notes{};  // For people.
  std::string key{};    // Of the keyboard; empty: none.
  std::string sound{};  // A WAV file in the show's folder, which begins with the recording; empty: none.
  // What of the recording is played, in its seconds; nothing: to its end.
  float from_s = 0;
  std::optional<float> to_s{};
  float stretch = 1;     // Of its time; 2 is half as fast.
  float gain = 1;        // Of all that moves.
  float ease_s = 0.25F;  // In and out, in seconds as it is played: it begins and ends at rest.
  show::MotionLayer layer = show::MotionLayer::kAdd;  // Beside those who have the same levels.
  bool loop = false;
  float blend_s = 0.5F;  // The end of a loop runs into its beginning within so many seconds as it is played.
  std::vector<TakeCurve> curves{};
};

// Of the recording, in its own seconds: when its last curve ends.
float RecordedLength(const Take& take);

// As it is played: trimmed and stretched. Of one that loops, before the loop is closed.
float PlayedLength(const Take& take);

// "head_yaw", or the channel's name.
std::string_view NameOf(const TakeCurve& curve);

// Whether both move the same.
bool SameChannel(const TakeCurve& a, const TakeCurve& b);

// Letters, digits, spaces, - and _, 64 at most, and not kNoTakeName.
bool IsTakeName(std::string_view name);

}  // namespace kaori::authoring
