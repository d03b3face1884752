// Simulated twins of MIDI surfaces that people own, by their bytes.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace kaori::sim {

// kXTouchMini: a Behringer X-Touch Mini as it ships, whose encoders have dead ends. kTwister: a DJ TechTools
// Midi Fighter Twister, whose encoders tell turns once it was put into its native mode, and nothing before.
// One thread.
class MidiTwin {
 public:
  enum class Kind : std::uint8_t { kXTouchMini, kTwister };
  explicit MidiTwin(Kind kind) : kind_(kind) {}
  Kind kind() const { return kind_; }

  // Test's side. Encoders 0..7, buttons 0..15; clockwise is positive.
  void Turn(int encoder, int steps);
  void Push(int button, bool down);
  bool lamp(int button) const { return lamps_[static_cast<std::size_t>(button)]; }
  // It shows them no more, as an X-Touch Mini does when somebody touches its layers.
  void ForgetLamps() { lamps_ = {}; }

  // The cable's side.
  void Receive(std::span<const std::uint8_t> bytes);
  std::vector<std::uint8_t> Send() { return std::exchange(said_, {}); }
  bool has_said() const { return !said_.empty(); }
  // Power went or came: lamps are dark, encoders stand at their beginning, the mode is the usual one.
  void PowerCycle() { *this = MidiTwin(kind_); }

 private:
  Kind kind_;
  bool is_native_ = false;
  std::array<int, 8> places_{};  // Of encoders with dead ends, 0..127.
  std::array<bool, 16> lamps_{};
  std::vector<std::uint8_t> heard_;
  std::vector<std::uint8_t> said_;
};

}  // namespace kaori::sim
