// Memory that two processes share by handing a descriptor over, and that neither can shrink under the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori {

// A mapping with one owner.
class SharedMemory {
 public:
  SharedMemory() = default;
  SharedMemory(SharedMemory&& other) noexcept
      : bytes_(std::exchange(other.bytes_, {})), descriptor_(std::move(other.descriptor_)) {}
  SharedMemory& operator=(SharedMemory&& other) noexcept;
  ~SharedMemory() { Unmap(); }

  // New, zeroed and sealed at its size. `name` is for /proc only. Errors: those of memfd_create and mmap.
  static Result<SharedMemory> Make(const std::string& name, std::size_t bytes);

  // What a peer made and handed over. Errors: invalid_argument (it holds less than `bytes`, or may shrink).
  static Result<SharedMemory> Adopt(UniqueFd descriptor, std::size_t bytes);

  bool valid() const { return !bytes_.empty(); }
  int descriptor() const { return descriptor_.get(); }
  std::span<std::uint8_t> bytes() const { return bytes_; }

 private:
  void Unmap();
  static Result<SharedMemory> Map(UniqueFd descriptor, std::size_t bytes);

  std::span<std::uint8_t> bytes_;
  UniqueFd descriptor_;
};

}  // namespace kaori
