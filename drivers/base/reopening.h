// When the reader of a device's stream opens it again, and what the log says of it.
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <system_error>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"

namespace kaori {

// A device that cannot be opened is tried again every 250 ms, so that one that is plugged in is there at once. One
// that opens and delivers nothing is opened after 250 ms twice, then 500 ms and so on up to 10 s, until it delivers
// or is unplugged. An attempt that blocks costs a twentieth of the time at most: every pause counts from its end.
// Each cause is one line in the log until the device delivers. One thread.
class Reopening {
 public:
  // Borrows the clock. `name` is for the log: "lip camera". `after_loss`: the pause before a device that had
  // delivered is opened again.
  Reopening(std::string name, const Clock& clock, Duration after_loss)
      : name_(std::move(name)), clock_(clock), after_loss_(after_loss) {}

  // Whether it is time to call Open.
  bool IsDue(Time now) const { return now >= due_at_; }

  // Opens the device, or returns null. Blocks for as long as `open`; the watchdog is told before.
  template <class Device>
  std::unique_ptr<Device> Open(const std::function<Result<std::unique_ptr<Device>>()>& open) {
    const Time asked = Begin();
    auto device = open();
    Note(device ? nullptr : &device.error(), asked);
    return device ? std::move(*device) : nullptr;
  }

  // Closes a device that failed, or that was silent for too long (timed_out); the latter may still be there, so that
  // its absence is news afterwards. Blocks for as long as the device does.
  template <class Device>
  void Close(std::unique_ptr<Device>& device, const Error& why) {
    Close(device);
    Tell(why);
  }
  // The same where nothing is wrong.
  template <class Device>
  void Close(std::unique_ptr<Device>& device) {
    const Time asked = Begin();
    device.reset();
    NoteClosed(asked);
  }

  // Something valid came from the device, or was played by it: its next failure is news.
  void NoteDelivery();

 private:
  // Before a call that may block; gives the time.
  Time Begin() const;
  // An opening ended; null: with a device.
  void Note(const Error* failed, Time asked);
  void NoteClosed(Time asked);
  void Tell(const Error& why);
  // Whether nothing was told of this cause yet; zero stands for the opening itself.
  bool IsNews(std::errc cause) { return told_.insert(cause).second; }

  std::string name_;
  const Clock& clock_;
  Duration after_loss_;
  Time due_at_{};
  // A device whose opening blocked is not opened before this time.
  Time not_before_{};
  // Twice the pause before; the next one is no shorter than kShortestPause.
  Duration pause_ = kFirstPause;
  // Since it was opened.
  bool has_delivered_ = false;
  std::set<std::errc> told_;

  static constexpr Duration kShortestPause = std::chrono::milliseconds(250);
  // A stream that stood still for some seconds is back within one.
  static constexpr Duration kFirstPause = kShortestPause / 2;
  static constexpr Duration kLongestPause = std::chrono::seconds(10);
};

}  // namespace kaori
