#include "appliance/programs/data/reset_request.h"

namespace kaori::data {

// One that is held longer than kLongest counts as let go without a wish until it has been released.
ResetRequest::Verdict ResetRequest::See(bool key_is_on, bool go_is_held, Time now) {
  if (verdict_ == Verdict::kAsked || verdict_ == Verdict::kOver) return verdict_;
  if (key_is_on && go_is_held) {
    if (!held_since_) held_since_ = now;
    const Duration held = now - *held_since_;
    verdict_ = held >= kHeld && held < kLongest ? Verdict::kLetGo : Verdict::kWaiting;
  } else {
    held_since_.reset();
    verdict_ = verdict_ == Verdict::kLetGo && key_is_on ? Verdict::kAsked : Verdict::kWaiting;
  }
  if (verdict_ == Verdict::kWaiting && now - began_ >= kFrom) verdict_ = Verdict::kOver;
  return verdict_;
}

}  // namespace kaori::data
