#include "hw-sim/devices/boot_loader.h"

#include <utility>

namespace kaori::sim {

Result<void> BootLoader::TryOnce(ports::Slot slot) {
  if (forgets_) return Fail(std::errc::not_supported, "write the simulated firmware's variable");
  if (before_try_) before_try_();
  once_ = slot;
  return {};
}

Result<void> BootLoader::Confirm(ports::Slot slot) {
  if (slot == default_) return {};
  default_ = slot;
  return {};
}

ports::Slot BootLoader::SwitchOn() {
  running_ = std::exchange(once_, std::nullopt).value_or(default_);
  return running_;
}

}  // namespace kaori::sim
