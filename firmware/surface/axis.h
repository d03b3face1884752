// One axis of a stick, or a slider: from the converter's codes to what reports say.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace kaori::surface {

// Where an axis rests and ends, in sums of four codes of 12 bits: 0 to 16380. Kept in flash.
struct AxisEnds {
  std::uint16_t low = 400;
  std::uint16_t centre = 8190;
  std::uint16_t high = 15980;
  friend bool operator==(const AxisEnds&, const AxisEnds&) = default;
};
// Whether there is a way from each end to the centre. A file that says otherwise is not used.
bool IsValid(const AxisEnds& ends);

// Sums four codes, takes the median of the last three sums, and goes half of the way to it: 4000 codes a
// second make 1000 values, less than 2 ms old. One side.
class AxisFilter {
 public:
  // One code of 12 bits. True: there is a new value.
  bool Sample(std::uint16_t code);
  // In sums of four codes with four bits behind the point.
  std::uint32_t value_q4() const { return value_q4_; }

 private:
  bool began_ = false;
  std::uint8_t samples_ = 0;
  std::uint16_t sum_ = 0;
  // The last three sums, the newest last.
  std::array<std::uint16_t, 3> sums_{};
  std::uint32_t value_q4_ = 0;
};

// -32767 to 32767 of a filtered value. One percent on either side of the centre is exactly 0, the rest is even; beyond the
// ends it stays at the ends.
std::int16_t AxisValue(std::uint32_t value_q4, const AxisEnds& ends);
// 0 to 65535 from one end to the other; it has no centre.
std::uint16_t SliderValue(std::uint32_t value_q4, const AxisEnds& ends);

// Which values of a control are worth a report. While it moves each step of 4 of 65536 is, so that a slow turn is as fine
// as the filter. It rests when 20 values in a row, which are 20 ms, have stayed within 20 of 65536; then it is silent, noise
// of its converter too, until it has gone so far. One side.
class AxisGate {
 public:
  static constexpr std::uint8_t kValuesToRest = 20;

  // The next value, from `low` to `high`. True: it is told.
  bool Accept(std::int32_t now, std::int32_t low, std::int32_t high);
  // The value that was told last; 0 before the first.
  std::int32_t told() const { return told_; }

 private:
  std::int32_t told_ = 0;
  // Where it was last seen to go 20 away from, and how many values have stayed near that since.
  std::int32_t moved_to_ = 0;
  std::uint8_t still_ = kValuesToRest;
};

// Learns the ends of an axis that a person moves from stop to stop, beginning at rest. One side.
class AxisTeacher {
 public:
  explicit AxisTeacher(std::uint32_t rest_q4);
  void See(std::uint32_t value_q4);
  // The ends that were seen, a little inside of them so that both are reached. Not IsValid where nothing
  // moved.
  AxisEnds ends() const;

 private:
  std::uint16_t centre_;
  std::uint16_t low_;
  std::uint16_t high_;
};

}  // namespace kaori::surface
