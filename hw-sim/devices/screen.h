// The simulated screen: what the audience sees, and when it was scanned out.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "drivers/base/clock.h"

namespace kaori::sim {

// The size and the period of a screen, as its EDID would tell them.
struct ScreenMode {
  // Of the visible picture.
  int width_px = 960;
  int height_px = 540;
  // From one vertical blank to the next: 60 Hz.
  Duration period = std::chrono::nanoseconds(16'666'667);
  friend bool operator==(const ScreenMode&, const ScreenMode&) = default;
};

// A frame that is being scanned out.
struct Shown {
  std::uint64_t frame = 0;  // The program's number.
  Time at{};                // Its scan-out time: the vertical blank at which it was shown first.
  int width_px = 0;
  int height_px = 0;
  std::span<const std::uint8_t> rgbx;  // Bottom row first, tightly packed. Borrowed until the next Pump.
};

// What a program presents becomes visible at a vertical blank; these fall on start + n * period. The
// screen holds no pixels itself: it borrows those of the link. One thread.
class Screen {
 public:
  // The first vertical blank is at `start`.
  Screen(ScreenMode mode, Time start) : mode_(mode), start_(start) {}

  // Test's side. On a new mode the program loses the screen and must open it anew;
  // the last picture stands until then.
  std::optional<Shown> latest() const { return latest_; }
  // Counts from the beginning; a frame that is shown longer counts once.
  std::uint64_t frames_shown() const { return frames_shown_; }
  ScreenMode mode() const { return mode_; }
  // Sizes and periods that are not above 0 are ignored.
  void SetMode(ScreenMode mode);

  // Appliance's side. Number of the last vertical blank at or before `now`, and its
  // time. `now` is not before the start.
  std::int64_t blank_before(Time now) const { return (now - start_) / mode_.period; }
  // The time of a vertical blank by its number, from 0 at the start.
  Time blank_at(std::int64_t number) const { return start_ + number * mode_.period; }
  // Counts SetMode: a link that finds another number makes the program open the screen anew.
  std::uint32_t mode_changes() const { return mode_changes_; }
  void Show(const Shown& shown);  // Borrows the pixels until the next Show or Darken.
  // No picture: nobody drives the screen.
  void Darken() { latest_.reset(); }

 private:
  ScreenMode mode_;
  // When blank 0 was.
  Time start_;
  // None while it is dark.
  std::optional<Shown> latest_;
  std::uint64_t frames_shown_ = 0;
  std::uint32_t mode_changes_ = 0;
};

}  // namespace kaori::sim
