// The choice of a Raspberry Pi's firmware: the default stands in autoboot.txt, one try in the argument of a restart.
#pragma once

#include <filesystem>
#include <memory>

#include "drivers/ports/block_device.h"
#include "drivers/ports/boot_choice.h"

namespace kaori::loader {

// What systemd passes to reboot(2) when it restarts the machine, one line; the box's first program makes the file, empty.
inline constexpr const char* kRestartArgument = "/run/systemd/reboot-param";

// The partitions, by their numbers, that hold each slot's kernel and firmware; rootfs/image/pi_boot.py lays them out.
inline constexpr char kPartitionOfA = '2', kPartitionOfB = '3';

// Raspberry Pi's documentation, "autoboot.txt": the firmware reads that file, of at most 512 bytes, on the first FAT partition, and
// starts the partition of its section [all]; after a restart with the argument "0 tryboot", once, that of its section [tryboot].
//
// Of the partition one sector is written, that of autoboot.txt, which only ever has one of two contents. A try is lost with the
// power, so that a cut before it starts the default; it wants a kernel that passes the argument on to the firmware.
class Tryboot final : public ports::BootChoice {
 public:
  // `partition` is the first one, "boot"; `argument` the file that systemd reads.
  Tryboot(std::unique_ptr<ports::BlockDevice> partition, ports::Slot running,
          std::filesystem::path argument = kRestartArgument)
      : partition_(std::move(partition)), running_(running), argument_(std::move(argument)) {}

  Result<ports::Slot> Default() override;
  ports::Slot running() const override { return running_; }
  Result<void> TryOnce(ports::Slot slot) override;
  Result<void> Confirm(ports::Slot slot) override;

 private:
  std::unique_ptr<ports::BlockDevice> partition_;
  ports::Slot running_;
  std::filesystem::path argument_;
};

}  // namespace kaori::loader
