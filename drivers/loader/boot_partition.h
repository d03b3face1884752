// Where the loader's files lie on the partition from which the firmware starts, by its own tables: so that what is
// in them can be overwritten, and neither a table nor a folder ever is.
#pragma once

#include <cstdint>

#include "drivers/ports/block_device.h"
#include "drivers/ports/boot_choice.h"

namespace kaori::loader {

// A file that lies in one piece.
struct Extent {
  // On the partition.
  std::uint64_t at_bytes = 0;
  std::uint64_t bytes = 0;
};

// rootfs/image/esp.py gives a slot's kernel this size, whatever is in it.
inline constexpr std::uint64_t kKernel_bytes = std::uint64_t{24} << 20U;
inline constexpr std::uint64_t kSettings_bytes = 512;

// A slot's kernel with its command line, EFI/Linux/kaori-a.efi or kaori-b.efi. Reads the tables alone. Errors:
//   bad_message  the partition is not laid out as an image lays it out: the file is missing, has another
//                size, lies in several pieces, not on a whole MiB, or where the other slot's, loader.conf or a folder
//                lies too
//   those of BlockDevice
Result<Extent> FindKernel(ports::BlockDevice& partition, ports::Slot slot);

// loader/loader.conf, which is one sector. Errors: as FindKernel.
Result<Extent> FindSettings(ports::BlockDevice& partition);

// Whether a Raspberry Pi's firmware starts from it: it has a file autoboot.txt then, and else what systemd-boot reads. Errors: as
// FindKernel.
Result<bool> HasAutoboot(ports::BlockDevice& partition);

// autoboot.txt, which is in one sector and may be shorter. Errors: as FindKernel.
Result<Extent> FindAutoboot(ports::BlockDevice& partition);

}  // namespace kaori::loader
