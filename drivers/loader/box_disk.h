// The disk from which the box started: the slot that does not run, and the loader that chooses between both.
#pragma once

#include <memory>
#include <string>

#include "drivers/loader/boot_partition.h"
#include "drivers/loader/one_shot.h"
#include "drivers/loader/tryboot.h"
#include "drivers/ports/block_device.h"
#include "drivers/ports/boot_choice.h"

namespace kaori::loader {

// Where it is looked for. A box has both ways to keep a try in its image, and uses the one of the loader that its disk has.
struct BoxDisk {
  // A folder with files named boot, root-a ... in place of the partitions; empty: those beside the root.
  std::string folder;
  // Of a PC, whose firmware keeps a try in its variables.
  std::string variables = kVariables;
  // Of a Raspberry Pi, whose firmware is asked for a try by the argument of a restart.
  std::string argument = kRestartArgument;
};

// The partitions of a slot, open to be written.
struct SlotPartitions {
  std::unique_ptr<ports::BlockDevice> root, verity, boot;
  // Where its kernel lies on `boot`: a file of it, or all of it where each slot has a partition of its own.
  Extent kernel;
};

// Those of the slot that does not run: what the running root is made of the kernel gives to nobody. Blocks for the disk. Errors:
//   no_such_device  a partition is missing
//   bad_message     its partition boot-a or boot-b has another size than an image gives it
//   those of OpenBlockFile and of FindKernel
Result<SlotPartitions> OpenOtherSlot(const BoxDisk& disk, ports::Slot running);

// The loader's choice. Which loader it is the partition "boot" itself says: a Raspberry Pi's firmware where it holds autoboot.txt,
// else systemd-boot. Errors: no_such_device, those of OpenBlockFile and of HasAutoboot.
Result<std::unique_ptr<ports::BootChoice>> OpenBootChoice(const BoxDisk& disk, ports::Slot running);

}  // namespace kaori::loader
