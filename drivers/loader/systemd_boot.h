// The choice of systemd-boot: the default stands in loader.conf, one try in a variable of the firmware.
#pragma once

#include <filesystem>
#include <memory>

#include "drivers/loader/one_shot.h"
#include "drivers/ports/block_device.h"
#include "drivers/ports/boot_choice.h"

namespace kaori::loader {

// The partition "boot" is written in one sector alone, that of loader.conf, which only ever has one of two
// contents; where that lies the partition's tables say, each time anew.
class SystemdBoot final : public ports::BootChoice {
 public:
  // `variables` is efivarfs' folder.
  SystemdBoot(std::unique_ptr<ports::BlockDevice> partition, ports::Slot running,
              std::filesystem::path variables = kVariables)
      : partition_(std::move(partition)), running_(running), variables_(std::move(variables)) {}

  Result<ports::Slot> Default() override;
  ports::Slot running() const override { return running_; }
  Result<void> TryOnce(ports::Slot slot) override;
  Result<void> Confirm(ports::Slot slot) override;

 private:
  std::unique_ptr<ports::BlockDevice> partition_;
  ports::Slot running_;
  std::filesystem::path variables_;
};

}  // namespace kaori::loader
