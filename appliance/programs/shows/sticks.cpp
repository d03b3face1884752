#include "appliance/programs/shows/sticks.h"

#include <algorithm>
#include <utility>

#include "appliance/programs/shows/stick.h"

namespace kaori::shows {

Result<std::optional<std::filesystem::path>> Sticks::Look() {
  // The kernel's list is read at each look: no event of a device can be missed in that way.
  const auto there = FindSticks("/sys/class/block");
  const auto is_out = [&](const std::string& device) {
    return std::ranges::find(there, device) == there.end();
  };
  const std::string before = device_;
  if (is_out(device_)) Leave();
  std::erase_if(refused_, is_out);
  for (const std::string& device : there) {
    if (holds_something_) break;
    if (device != device_ && std::ranges::find(refused_, device) == refused_.end()) Try(device);
  }
  // A change is told as an absence first, so that a list of the stick before is given up.
  if (!before.empty() && device_ != before) return std::optional<std::filesystem::path>();
  if (mount_) return std::optional(at_);
  if (there.empty()) return std::optional<std::filesystem::path>();
  return tl::unexpected(fault_);
}

// Without a stick there is nothing to do, and that is no error.
Result<void> Sticks::SetWritable(bool writable) {
  return mount_ ? mount_->SetWritable(writable) : Result<void>{};
}

void Sticks::Leave() {
  mount_.reset();
  device_.clear();
  holds_something_ = false;
}

// A stick with none of these files is still mounted, but another one that has some takes its place.
bool Sticks::HoldsSomething() const {
  const auto holds = [](const Result<std::vector<Offer>>& listed) { return listed && !listed->empty(); };
  return holds(ListShows(at_)) || holds(ListKeys(at_)) || holds(ListUpdates(at_)) ||
         holds(ListBackups(at_)) || holds(ListSettings(at_));
}

void Sticks::Try(const std::string& device) {
  if (mount_) refused_.push_back(device_);
  Leave();
  auto mount = StickMount::Make("/dev/" + device, at_);
  if (!mount) {
    fault_ = mount.error();
    refused_.push_back(device);
    return;
  }
  mount_.emplace(std::move(*mount));
  device_ = device;
  holds_something_ = HoldsSomething();
}

}  // namespace kaori::shows
