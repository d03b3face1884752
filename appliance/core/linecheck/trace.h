// What one control has done since the line check began: how far it went, whether it jitters, whether it stays
// down.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "drivers/base/clock.h"

namespace kaori::linecheck {

// A movement, as numbers. Pure but for what it remembers; time is an argument and does not go back.
class Way {
 public:
  // Both ends of its way, and how little of it is no movement. Of a dial, which has no ends: a quarter turn
  // each way.
  struct Ends {
    float low = 0, high = 0;
    float step = 0.01F;
  };

  // Forgets everything; the control stands at `at`.
  void Begin(float at, Time now);
  // Where the control stands now, in the unit of `ends`: -1..1 or 0..1 of an axis, turns of a dial.
  void Follow(float at, const Ends& ends, Time now);

  // How far it went down and up since Begin, in the same unit.
  float low() const { return low_; }
  float high() const { return high_; }
  // It came to its lower end before its upper one; false until it was at either.
  bool low_first() const { return low_first_; }
  // It was at each of the two ends, or beyond, since Begin.
  bool reached_both() const { return reached_low_ && reached_high_; }
  // More than a jitter away from where it stood.
  bool moved() const { return high_ - low_ > kSmall; }
  // Six turns about within a second and within a tenth of its way: no person moves so finely and so fast.
  // Stays true.
  bool noisy() const { return noisy_; }
  // For how long it has stood where it is.
  Duration rests(Time now) const { return now - moved_at_; }

 private:
  static constexpr float kSmall = 0.1F;
  static constexpr std::size_t kTurns = 6;
  static constexpr Duration kJitter = std::chrono::seconds(1);
  // Where it turned back last, oldest first: six within kJitter are no person's.
  struct Turn {
    Time at{};
    float value = 0;
  };
  void NoteTurn(float value, Time now);

  float low_ = 0, high_ = 0, last_ = 0;
  bool reached_low_ = false, reached_high_ = false, low_first_ = false, noisy_ = false;
  int direction_ = 0;
  Time moved_at_{};
  std::array<Turn, kTurns> turns_{};
  std::size_t turn_count_ = 0;
};

// A button, a key or a switch.
class Contact {
 public:
  // Forgets everything. `pushes` is the board's counter, which wraps; `down` says whether it is held now, which counts
  // for no push.
  void Begin(std::uint32_t pushes, bool down, Time now);
  // The counter and the contact as the board has them now.
  void Follow(std::uint32_t pushes, bool down, Time now);

  // How often it was pushed since the beginning.
  std::uint32_t pushes() const { return total_; }
  // It was pushed, or switched over.
  bool used() const { return used_; }
  // Eight pushes within a second: faster than a finger. Stays true.
  bool noisy() const { return noisy_; }
  // For how long it has been down; 0 while it is not.
  Duration held(Time now) const { return down_ ? now - changed_at_ : Duration{}; }

 private:
  static constexpr std::uint32_t kChatter = 8;
  static constexpr Duration kChatterTime = std::chrono::seconds(1);

  std::uint32_t pushes_ = 0, recent_ = 0, total_ = 0;
  bool down_ = false, used_ = false, noisy_ = false;
  Time changed_at_{}, recent_since_{};
};

// A counter that goes on for as long as its device works: pictures of a camera, blocks of a microphone.
class Pulse {
 public:
  // The counter as it stands; it counts as having gone on just now.
  void Begin(std::uint32_t count, Time now) { *this = {count, now}; }
  // Any other count is progress: counters wrap, and begin anew with their program.
  void Follow(std::uint32_t count, Time now) {
    if (count != count_) *this = {count, now};
  }
  // For how long it has not gone on.
  Duration stands(Time now) const { return now - since_; }

  Pulse() = default;

 private:
  Pulse(std::uint32_t count, Time since) : count_(count), since_(since) {}
  std::uint32_t count_ = 0;
  Time since_{};
};

}  // namespace kaori::linecheck
