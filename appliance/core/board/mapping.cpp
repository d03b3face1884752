#include "appliance/core/board/mapping.h"

#include <signal.h>
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdint>

#include "appliance/core/board/layout.h"

namespace kaori::board {
namespace {

// Where boards are mapped, for the handler, which may take no lock: a table of fixed size that is scanned.
// Null is a free entry. A program has one mapping for the board and one for each section that it writes,
// seven at most; tests have many boards.
constexpr std::size_t kMostMappings = 256;
std::array<std::atomic<void*>, kMostMappings> mapped;
struct sigaction earlier {};

// The beginning of the board that holds `address`, or null. Async-signal-safe.
void* MappingAround(const void* address) {
  for (const auto& entry : mapped) {
    void* const begin = entry.load(std::memory_order_relaxed);
    const auto offset = reinterpret_cast<std::uintptr_t>(address) - reinterpret_cast<std::uintptr_t>(begin);
    if (begin != nullptr && offset < kBoardBytes) return begin;
  }
  return nullptr;
}

// The handler of SIGBUS. A touch of a page behind the end of the file raises it; MAP_FIXED puts private zero
// pages in the place of the whole board, and the touch that brought us here is done again and succeeds. mmap
// is a bare system call on Linux, so that it may be called here, and errno is put back for whoever was
// interrupted. A SIGBUS of anything else gets the handler that was there before ours.
void ReplaceVanishedPages(int /*signal*/, siginfo_t* info, void* /*context*/) {
  const int cause = errno;
  void* const begin = MappingAround(info->si_addr);
  const bool replaced =
      begin != nullptr && ::mmap(begin, kBoardBytes, PROT_READ | PROT_WRITE,
                                 MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0) != MAP_FAILED;
  if (!replaced) ::sigaction(SIGBUS, &earlier, nullptr);  // It is raised again, for whom it concerns.
  errno = cause;
}

// Installs the handler, once in a process; `earlier` is what was there before.
bool CatchVanishedPages() {
  struct sigaction action {};
  action.sa_sigaction = ReplaceVanishedPages;
  action.sa_flags = SA_SIGINFO;
  return ::sigaction(SIGBUS, &action, &earlier) == 0;
}

// Claims a free entry of the table; false: all are in use.
bool Enter(void* begin) {
  return std::ranges::any_of(mapped, [begin](auto& entry) {
    void* none = nullptr;
    return entry.compare_exchange_strong(none, begin);
  });
}

void Leave(void* begin) {
  for (auto& entry : mapped) {
    void* same = begin;
    if (entry.compare_exchange_strong(same, nullptr)) return;
  }
}

}  // namespace

// The handler is there before the first page is touched, and the table has the mapping before anybody gets
// it.
Result<Mapping> Mapping::Map(int fd, bool writable, const std::string& path) {
  static const bool catches = CatchVanishedPages();
  if (!catches) return FailErrno("catch SIGBUS for board " + path);
  const int protection = writable ? PROT_READ | PROT_WRITE : PROT_READ;
  void* at = ::mmap(nullptr, kBoardBytes, protection, MAP_SHARED, fd, 0);
  if (at == MAP_FAILED) return FailErrno("map board " + path);
  Mapping mapping(static_cast<Word*>(at));
  if (!Enter(at)) return Fail(std::errc::too_many_files_open, "map board " + path);
  return mapping;
}

// Entries go first: another mapping may get these addresses at once. Entries that went after munmap would let
// the handler put zeros over the pages of whoever got the addresses.
Mapping::~Mapping() {
  if (words_ == nullptr) return;
  Leave(words_);
  ::munmap(words_, kBoardBytes);
}

}  // namespace kaori::board
