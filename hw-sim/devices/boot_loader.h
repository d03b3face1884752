// A PC's loader that chooses between two slots, and the firmware under it.
#pragma once

#include <functional>
#include <optional>

#include "drivers/ports/boot_choice.h"

namespace kaori::sim {

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
  // Called before the default changes: what is on the disk then can be judged.
  void CallBeforeConfirm(std::function<void()> call) { before_confirm_ = std::move(call); }

 private:
  ports::Slot default_ = ports::Slot::kA;
  ports::Slot running_ = ports::Slot::kA;
  // What the firmware keeps until the next start.
  std::optional<ports::Slot> once_;
  bool forgets_ = false;
  std::function<void()> before_confirm_;
};

}  // namespace kaori::sim
