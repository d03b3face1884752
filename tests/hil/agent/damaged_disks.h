// Mounts damaged file systems one after the other, reads all that they show, and writes to some, as the box does with a stick.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "drivers/base/result.h"
#include "tests/hil/agent/kernel_log.h"

namespace kaori::agent {

// The kinds that a stick may have: FAT of 12, 16 and 32 bits, and exFAT. Needs a memory disk of the kernel
// (brd) and, on the bench's disk, an empty file system of each kind. For a process that may mount.
class DamagedDisks {
 public:
  // Fills a file system of each kind with files and folders on the memory disk, and keeps its image. Errors:
  // those of the disk, of mounting, and of a file system that does not show what was written.
  static Result<DamagedDisks> Make();

  // Images `first` to `first` + `count` - 1, of the kinds in turn. Four of forty, one of each kind, are remounted so that they can be
  // written, get a new file as a support file is written, and are closed again. Says what came of them in one line: "tried N mounted N
  // entries N bytes N written N", where `written` are those on which that file came to be, and behind it "fault TEXT" where the kernel's
  // log tells of a fault of the kernel itself. Returns when the last is unmounted; a driver that hangs never returns. Errors: those of the
  // memory disk, and of one that is still in use.
  Result<std::string> Try(std::uint64_t first, std::uint64_t count);

 private:
  struct Kind {
    const char* image;        // On the bench's disk, without files.
    const char* file_system;  // For mount.
    std::vector<std::uint8_t> filled{};
  };

  explicit DamagedDisks(KernelLog log) : log_(std::move(log)) {}
  static Result<void> Fill(Kind& kind);

  KernelLog log_;
  std::array<Kind, 4> kinds_{Kind{"/usr/share/kaori/fat12.img", "vfat"},
                             {"/usr/share/kaori/fat16.img", "vfat"},
                             {"/usr/share/kaori/fat32.img", "vfat"},
                             {"/usr/share/kaori/exfat.img", "exfat"}};
};

}  // namespace kaori::agent
