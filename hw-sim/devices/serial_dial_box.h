// A simulated dial and button box of 1993, by the bytes on its serial line.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "drivers/base/clock.h"

namespace kaori::sim {

// The boxes that drivers/decode/serial_dials.h knows, from their own side: what is written here was written
// from the same public descriptions, and shares no code. A byte takes a 960th of a second on the line. Dials
// 0..7, buttons 0..31; other numbers are ignored. One thread.
class SerialDialBox {
 public:
  enum class Kind : std::uint8_t { kSgi, kSpectragraphics, kDls80 };
  static constexpr int kCountsPerTurn = 256;
  static constexpr int kBaud = 9600;

  explicit SerialDialBox(Kind kind) : kind_(kind) {}

  // Test's side. A box that was not told to report moves in silence.
  void Turn(int dial, int counts);  // Clockwise is positive.
  void Push(int button);
  void Release(int button);
  void set_mute(bool mute) { is_mute_ = mute; }  // It has no power, or its cable is wrong.
  void set_baud(int baud) { baud_ = baud; }      // Other than 9600: somebody set the line wrongly.
  // Spoils the next byte: it is lost, comes twice, or is another one.
  enum class Fault : std::uint8_t { kNone, kLost, kTwice, kChanged };
  void SpoilNext(Fault fault) { fault_ = fault; }
  std::uint32_t lamps() const { return lamps_; }
  bool reports() const { return dials_on_; }
  int baud() const { return baud_; }

  // The line's side. Bytes that the host sent, and those whose last bit has left at `now`.
  void Receive(std::span<const std::uint8_t> bytes, Time now);
  std::vector<std::uint8_t> Send(Time now);
  std::optional<Time> next_due() const;
  // The power went and came: nothing is reported until the host asks again. Dials stand at 0.
  void PowerCycle();

 private:
  struct Waiting {
    std::uint8_t byte;
    Time leaves_at;
  };
  void Say(std::initializer_list<int> bytes);
  void Button(int button, bool down);
  // The first command of what the host sent, where it is whole.
  bool Obey(Time now);

  Kind kind_;
  bool is_mute_ = false;
  int baud_ = kBaud;
  Fault fault_ = Fault::kNone;
  bool dials_on_ = false;
  bool buttons_on_ = false;
  std::uint32_t down_ = 0;
  std::uint32_t lamps_ = 0;
  std::array<std::uint16_t, 8> positions_{};
  std::vector<std::uint8_t> heard_;  // Of a command that is not whole yet.
  std::vector<std::uint8_t> said_;   // Without a time yet: the line gives it.
  std::deque<Waiting> waiting_;
  Time line_free_at_{};
};

}  // namespace kaori::sim
