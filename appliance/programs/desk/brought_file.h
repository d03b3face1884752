// A file that a visitor brings in parts, each in a request of its own: a backup, which is larger than any request may be.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::desk {

// One thread. Blocks for the disk. The file has no name: it goes with this object, and with whoever took it.
class BroughtFile {
 public:
  // `folder` is where it lies, on the disk; empty: nothing can be brought.
  explicit BroughtFile(std::filesystem::path folder) : folder_(std::move(folder)) {}

  // The part that begins at this byte: the next one, or 0, which begins the file anew. Errors: invalid_argument, another part was
  // expected, or the file is longer than kMost_bytes; those of open(2) and write(2), no_space_on_device among them.
  Result<void> Add(std::uint64_t at, std::string_view part);
  // All of it, once; not valid where nothing was brought.
  UniqueFd Release();

  // No backup of a box is longer: shows are its largest part, and a disk has room for a few.
  static constexpr std::uint64_t kMost_bytes = std::uint64_t{2} << 30U;

 private:
  std::filesystem::path folder_;
  UniqueFd file_;
  std::uint64_t bytes_ = 0;
};

}  // namespace kaori::desk
