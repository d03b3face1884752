#include "drivers/base/shared_memory.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>

namespace kaori {

SharedMemory& SharedMemory::operator=(SharedMemory&& other) noexcept {
  if (this == &other) return *this;
  Unmap();
  bytes_ = std::exchange(other.bytes_, {});
  descriptor_ = std::move(other.descriptor_);
  return *this;
}

Result<SharedMemory> SharedMemory::Make(const std::string& name, std::size_t bytes) {
  UniqueFd fd(::memfd_create(name.c_str(), MFD_CLOEXEC | MFD_ALLOW_SEALING));
  if (!fd.valid()) return FailErrno("make shared memory " + name);
  if (::ftruncate(fd.get(), static_cast<off_t>(bytes)) < 0) return FailErrno("size shared memory " + name);
  // F_SEAL_SEAL comes last: nobody can add a seal against writing,
  // which would take the peer's mapping away.
  if (::fcntl(fd.get(), F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL) < 0)
    return FailErrno("seal shared memory " + name);
  return Map(std::move(fd), bytes);
}

// Without the seal a peer could shrink the memory, and the next look at it would end this process with
// SIGBUS. A peer of ours always sets it; whoever else got at the socket need not.
Result<SharedMemory> SharedMemory::Adopt(UniqueFd descriptor, std::size_t bytes) {
  struct stat status {};
  if (::fstat(descriptor.get(), &status) < 0) return FailErrno("look at the peer's shared memory");
  if (bytes == 0 || static_cast<std::size_t>(status.st_size) < bytes)
    return FailInput("adopt the peer's shared memory: too small");
  const int seals = ::fcntl(descriptor.get(), F_GET_SEALS);
  if (seals < 0 || (seals & F_SEAL_SHRINK) == 0)
    return FailInput("adopt the peer's shared memory: it may shrink");
  return Map(std::move(descriptor), bytes);
}

// Takes the descriptor: while it is open another process can be given it.
Result<SharedMemory> SharedMemory::Map(UniqueFd descriptor, std::size_t bytes) {
  void* start = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor.get(), 0);
  if (start == MAP_FAILED) return FailErrno("map shared memory");
  SharedMemory memory;
  memory.bytes_ = {static_cast<std::uint8_t*>(start), bytes};
  memory.descriptor_ = std::move(descriptor);
  return memory;
}

void SharedMemory::Unmap() {
  if (!bytes_.empty()) ::munmap(bytes_.data(), bytes_.size());
  bytes_ = {};
}

}  // namespace kaori
