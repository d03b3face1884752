#include "hw-sim/devices/midi_twin.h"

#include <algorithm>

namespace kaori::sim {
namespace {

// The SysEx that puts a Twister into its native mode; 00 01 79 is its maker's id.
constexpr auto kNativeMode = std::to_array<std::uint8_t>({0xF0, 0x00, 0x01, 0x79, 0x05, 0x00, 0x01, 0xF7});
constexpr std::uint8_t kTouchFirstButton = 8;

}  // namespace

// An encoder of the Twister tells each step by itself. The clock ticks in between, as a surface that is a
// slave passes it on.
void MidiTwin::Turn(int encoder, int steps) {
  if (encoder < 0 || encoder >= static_cast<int>(places_.size())) return;
  const auto number = static_cast<std::uint8_t>(encoder);
  for (int n = 0; n < std::abs(steps); ++n) {
    if (kind_ == Kind::kXTouchMini) {
      int& place = places_[number];
      const int to = std::clamp(place + (steps < 0 ? -1 : 1), 0, 127);
      if (std::exchange(place, to) == to) continue;
      said_.insert(said_.end(),
                   {0xBA, static_cast<std::uint8_t>(1 + number), 0xF8, static_cast<std::uint8_t>(to)});
    } else if (is_native_) {
      // With running status, as serial ends of such surfaces do.
      if (n == 0) said_.push_back(0xB0);
      said_.insert(said_.end(), {number, static_cast<std::uint8_t>(steps < 0 ? 63 : 65)});
    }
  }
}

void MidiTwin::Push(int button, bool down) {
  if (button < 0 || button >= static_cast<int>(lamps_.size())) return;
  const auto value = static_cast<std::uint8_t>(down ? 127 : 0);
  if (kind_ == Kind::kXTouchMini)
    said_.insert(said_.end(), {0x9A, static_cast<std::uint8_t>(kTouchFirstButton + button), value});
  else
    said_.insert(said_.end(), {0xB1, static_cast<std::uint8_t>(button), value});
}

// Whole messages only: a test's host sends no others.
void MidiTwin::Receive(std::span<const std::uint8_t> bytes) {
  heard_.insert(heard_.end(), bytes.begin(), bytes.end());
  for (;;) {
    if (kind_ == Kind::kTwister && heard_.size() >= kNativeMode.size() &&
        std::equal(kNativeMode.begin(), kNativeMode.end(), heard_.begin())) {
      is_native_ = true;
      heard_.erase(heard_.begin(), heard_.begin() + kNativeMode.size());
      continue;
    }
    if (heard_.size() < 3 || heard_[0] == 0xF0) return;
    const bool is_lamp =
        kind_ == Kind::kXTouchMini ? heard_[0] == 0x9A && heard_[1] >= kTouchFirstButton : heard_[0] == 0xB1;
    const std::size_t button = heard_[1] - (kind_ == Kind::kXTouchMini ? kTouchFirstButton : 0U);
    if (is_lamp && button < lamps_.size()) lamps_[button] = heard_[2] != 0;
    heard_.erase(heard_.begin(), heard_.begin() + 3);
  }
}

}  // namespace kaori::sim
