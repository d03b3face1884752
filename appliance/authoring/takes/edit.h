// Takes made of others: a second pass over a first, and a stretch that is played anew.
#pragma once

#include <vector>

#include "appliance/authoring/takes/take.h"

namespace kaori::authoring {

// How far a curve may lie from what was recorded where keys are left out, in degrees; of other units the same
// number. It is 4e-5 radians.
inline constexpr float kTakeError = 2.3e-3F;

// The keys that are needed so that a curve through them lies within `error` of all others. The first and the
// last are kept.
std::vector<show::MotionKey> Thinned(const std::vector<show::MotionKey>& keys, float error);

// Times to a hundredth of a millisecond and values to four digits behind the point, which is less than
// anybody sees.
std::vector<show::MotionKey> Rounded(std::vector<show::MotionKey> keys);

// What is played of a take, as a recording of its own: trimmed, stretched and amplified for good. One that
// plays all of its recording as it is keeps every bit.
Take Settled(const Take& take);

// `first`, but for the channels that `second` moves: those are the second's. Both begin together. Every other
// channel keeps every bit, and so do notes, key, sound, easing and loop of the first.
Take Layered(const Take& first, const Take& second);

// `first` with the channels of `second` in its place from `at_s` on, in seconds as the first is played; both
// are blended within the second's easing at its two ends. Keys before and behind that stretch, and all other
// channels, keep every bit.
Take PunchedIn(const Take& first, const Take& second, float at_s);

}  // namespace kaori::authoring
