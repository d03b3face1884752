#include "drivers/base/reopening.h"

#include <algorithm>
#include <utility>

#include "drivers/base/log.h"
#include "drivers/base/long_call.h"

namespace kaori {
namespace {

// A camera needs tenths of a second to open and to close; what takes longer waits for an answer that does not come.
constexpr Duration kBlocks = std::chrono::seconds(1);

}  // namespace

Time Reopening::Begin() const {
  ExpectLongCall();
  return clock_.now();
}

// After a time-out the opening is no news.
void Reopening::Note(const Error* failed, Time asked) {
  const Time now = clock_.now();
  const Duration took = now - asked;
  if (failed == nullptr) {
    not_before_ = took >= kBlocks ? now + PauseAfter(took, Duration{}) : now;
    has_delivered_ = false;
    if (!told_.contains(std::errc::timed_out) && IsNews(std::errc{})) Log("{}: opened", name_);
    return;
  }
  due_at_ = now + PauseAfter(took, kShortestPause);
  // What is plugged in where nothing was has not disappointed yet.
  if (failed->cause == std::errc::no_such_device) pause_ = kFirstPause;
  if (IsNews(failed->cause)) Log("{}; trying again until it is there", failed->message());
}

// A device that had delivered is back as soon as it can be; a closing that blocked says that it cannot.
void Reopening::NoteClosed(Time asked) {
  const Time now = clock_.now();
  const Duration pause =
      has_delivered_ ? after_loss_
                     : std::max(kShortestPause, std::exchange(pause_, std::min(2 * pause_, kLongestPause)));
  due_at_ = now + (now - asked >= kBlocks ? PauseAfter(now - asked, pause) : pause);
  if (!has_delivered_) due_at_ = std::max(due_at_, not_before_);
}

void Reopening::Tell(const Error& why) {
  if (IsNews(why.cause)) LogWarning("{}; the {} is opened again", why.message(), name_);
  if (why.cause != std::errc::timed_out) told_.insert(std::errc::no_such_device);
}

void Reopening::NoteDelivery() {
  has_delivered_ = true;
  pause_ = kFirstPause;
  told_.clear();
}

}  // namespace kaori
