// A disk, or one of its partitions, as a row of bytes that are on it for good once they were flushed.
#pragma once

#include <cstdint>
#include <span>

#include "drivers/base/result.h"

namespace kaori::ports {

// One thread. Every call blocks for the disk. Positions and lengths are bytes and need no alignment. What was written
// and not flushed may be on the disk after a power cut, in any order, or not; of one call a part may be.
class BlockDevice {
 public:
  virtual ~BlockDevice() = default;

  // How many bytes it has, from 0 on.
  virtual std::uint64_t bytes() const = 0;

  // Fills `into` from `at` on. Errors: invalid_argument (it ends before), those of pread(2).
  virtual Result<void> Read(std::uint64_t at, std::span<std::uint8_t> into) = 0;

  // Writes all of `from`, and nothing else. Errors: invalid_argument (it ends before; nothing is written),
  // those of pwrite(2), after which a part may be written.
  virtual Result<void> Write(std::uint64_t at, std::span<const std::uint8_t> from) = 0;

  // Returns once all that was written is on the disk. What is read afterwards comes from the disk and not
  // from memory. Errors: those of fsync(2); what was written since the last flush may be lost then.
  virtual Result<void> Flush() = 0;
};

}  // namespace kaori::ports
