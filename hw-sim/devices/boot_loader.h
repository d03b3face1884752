// A PC's loader that chooses between two slots, and the firmware under it.
#pragma once

#include <functional>
#include <optional>

#include "drivers/ports/boot_choice.h"

namespace kaori::sim {

// The default is on its disk, and the one try in its firmware: two memories, of which a PC may lose the second.
//
// One thread.
class BootLoader final : public ports::BootChoice {
 public:
  // The appliance's side.
  Result<ports::Slot> Default() override { return default_; }
  ports::Slot running() const override { return running_; }
  Result<void> TryOnce(ports::Slot slot) override;
  Result<void> Confirm(ports::Slot slot) override;

  // The test's side. The machine is switched off and on: gives the slot that starts.
  ports::Slot SwitchOn();
  // Its firmware keeps no variables from now on.
  void ForgetVariables() { forgets_ = true; }
  // Called before one try is kept: what is on the disk then can be judged.
  void CallBeforeTry(std::function<void()> call) { before_try_ = std::move(call); }

 private:
  ports::Slot default_ = ports::Slot::kA;
  ports::Slot running_ = ports::Slot::kA;
  // What the firmware keeps until the next start.
  std::optional<ports::Slot> once_;
  bool forgets_ = false;
  std::function<void()> before_try_;
};

}  // namespace kaori::sim
