#include "firmware/surface/axis.h"

#include <algorithm>

namespace kaori::surface {
namespace {

// What a report says at the end of the way.
constexpr std::int32_t kAxisFull = 32767;
constexpr std::int32_t kSliderFull = 65535;
// In units of a report, of which a code of the converter's 12 bits has 16. While a control moves, steps of four are told.
constexpr std::int32_t kLeastMove = 4;
// Noise of half a code (rms) moves a filtered value by less than this.
constexpr std::int32_t kLeastFromRest = 20;
// An axis with less way than this to one side (of 16380) is broken, or was never moved.
constexpr std::uint16_t kLeastWay = 1000;
// One hundredth of the way is where the stick rests, and another is taken from each end that was taught.
constexpr std::int32_t kHundredth = 100;

// Of three: a single spike, however high, does not pass.
std::uint16_t Median(std::uint16_t a, std::uint16_t b, std::uint16_t c) {
  return std::max(std::min(a, b), std::min(std::max(a, b), c));
}

// Sixteenths of a code to whole ones, rounded.
std::uint16_t Whole(std::uint32_t value_q4) {
  return static_cast<std::uint16_t>((value_q4 + 8) >> 4);
}

}  // namespace

bool IsValid(const AxisEnds& ends) {
  return ends.low + kLeastWay <= ends.centre && ends.centre + kLeastWay <= ends.high;
}

// The first sum stands for the two before it, so that an axis has a value at once and does not climb to it.
bool AxisFilter::Sample(std::uint16_t code) {
  sum_ = static_cast<std::uint16_t>(sum_ + (code & 0xFFFU));
  if (++samples_ < 4) return false;
  if (!began_) sums_.fill(sum_);
  sums_ = {sums_[1], sums_[2], sum_};
  samples_ = 0;
  sum_ = 0;
  const std::uint32_t median_q4 = std::uint32_t{Median(sums_[0], sums_[1], sums_[2])} << 4;
  // The half is rounded towards the median, or the last sixteenth would never be gone.
  if (!began_) value_q4_ = median_q4;
  value_q4_ = median_q4 > value_q4_ ? (value_q4_ + median_q4 + 1) / 2 : (value_q4_ + median_q4) / 2;
  began_ = true;
  return true;
}

// Each side by its own way, since the middle of a potentiometer is seldom half-way.
std::int16_t AxisValue(std::uint32_t value_q4, const AxisEnds& ends) {
  const std::int32_t away = static_cast<std::int32_t>(value_q4) - (ends.centre << 4);
  const std::int32_t way = (away < 0 ? ends.centre - ends.low : ends.high - ends.centre) << 4;
  const std::int32_t rest = way / kHundredth;
  const std::int32_t beyond = std::min((away < 0 ? -away : away) - rest, way - rest);
  if (beyond <= 0) return 0;
  // Less than 2^18 times less than 2^15 does not fit into 32 bits.
  const auto scaled = static_cast<std::int32_t>(std::int64_t{beyond} * kAxisFull / (way - rest));
  return static_cast<std::int16_t>(away < 0 ? -scaled : scaled);
}

// From end to end, without a place of rest.
std::uint16_t SliderValue(std::uint32_t value_q4, const AxisEnds& ends) {
  const std::int32_t way = (ends.high - ends.low) << 4;
  const auto at = std::clamp<std::int32_t>(static_cast<std::int32_t>(value_q4) - (ends.low << 4), 0, way);
  return static_cast<std::uint16_t>(std::int64_t{at} * kSliderFull / way);
}

// Noise is within kLeastFromRest of where the control was last seen to move, so that it comes to rest there. The middle
// and both ends are always told: a stick that is let go must read 0.
bool AxisGate::Accept(std::int32_t now, std::int32_t low, std::int32_t high) {
  const auto distance = [now](std::int32_t from) { return now < from ? from - now : now - from; };
  if (distance(moved_to_) >= kLeastFromRest) {
    moved_to_ = now;
    still_ = 0;
  } else if (still_ < kValuesToRest) {
    ++still_;
  }
  const bool is_mark = now != told_ && (now == 0 || now == low || now == high);
  const bool moves = still_ < kValuesToRest && distance(told_) >= kLeastMove;
  if (!is_mark && !moves) return false;
  told_ = now;
  return true;
}

AxisTeacher::AxisTeacher(std::uint32_t rest_q4) : centre_(Whole(rest_q4)), low_(centre_), high_(centre_) {}

void AxisTeacher::See(std::uint32_t value_q4) {
  low_ = std::min(low_, Whole(value_q4));
  high_ = std::max(high_, Whole(value_q4));
}

// A hundredth less than was seen on each side, so that both ends are reached every time.
AxisEnds AxisTeacher::ends() const {
  return {.low = static_cast<std::uint16_t>(low_ + (centre_ - low_) / kHundredth),
          .centre = centre_,
          .high = static_cast<std::uint16_t>(high_ - (high_ - centre_) / kHundredth)};
}

}  // namespace kaori::surface
