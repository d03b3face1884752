// Memory that two processes share by passing a descriptor (memfd), sealed so that neither can shrink it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori {

// A writable mapping with one owner. The bytes are shared with the peer, which may change them at any
// time: what is read twice may differ, so that a value is copied out before it is checked. Which side
// writes when is agreed by packets beside it (firmware/wire/link.h), whose system calls also order the
// memory. The mapping ends with the object; the peer's own stays.
class SharedMemory {
 public:
  SharedMemory() = default;
  SharedMemory(SharedMemory&& other) noexcept
      : bytes_(std::exchange(other.bytes_, {})), descriptor_(std::move(other.descriptor_)) {}
  // Ends the mapping that it had.
  SharedMemory& operator=(SharedMemory&& other) noexcept;
  ~SharedMemory() { Unmap(); }

  // Makes memory of zeroes, sealed at its size (F_SEAL_SHRINK, F_SEAL_GROW): no side can change the
  // size any more. `name` is seen in /proc only, and need not be unique. `bytes` is above 0.
  // Errors: those of memfd_create(2), ftruncate(2) and mmap(2).
  static Result<SharedMemory> Make(const std::string& name, std::size_t bytes);

  // Maps the first `bytes` of what a peer made and passed, and owns the
  // descriptor also where it fails. Errors: invalid_argument (it holds less than
  // `bytes`, or could shrink), those of fstat(2) and mmap(2).
  static Result<SharedMemory> Adopt(UniqueFd descriptor, std::size_t bytes);

  // False before Make or Adopt, and after a move.
  bool valid() const { return !bytes_.empty(); }
  // To be passed to the peer; borrowed.
  int descriptor() const { return descriptor_.get(); }
  // Valid until the object is moved from, assigned to or destroyed.
  std::span<std::uint8_t> bytes() const { return bytes_; }

 private:
  void Unmap();
  // Maps the descriptor's memory and owns both. Errors: those of mmap(2).
  static Result<SharedMemory> Map(UniqueFd descriptor, std::size_t bytes);

  std::span<std::uint8_t> bytes_;
  UniqueFd descriptor_;
};

}  // namespace kaori
