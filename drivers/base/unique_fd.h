// A file descriptor with one owner; closed when the owner goes.
#pragma once

#include <unistd.h>

#include <utility>

namespace kaori {

// Wraps what a system call returned on the line that made it. Movable, not copyable. -1 is no
// descriptor. A failed close(2) is ignored: Linux releases the descriptor anyway, and a second try might
// close another thread's. Where late write errors matter, the writer calls fsync(2) before.
class UniqueFd {
 public:
  UniqueFd() = default;
  // Owns `fd`, which nobody else may close; -1 makes an empty one.
  explicit UniqueFd(int fd) : fd_(fd) {}
  // The other one is empty afterwards.
  UniqueFd(UniqueFd&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  UniqueFd& operator=(UniqueFd&& other) noexcept {
    if (this != &other) {
      reset();
      fd_ = std::exchange(other.fd_, -1);
    }
    return *this;
  }
  UniqueFd(const UniqueFd&) = delete;
  UniqueFd& operator=(const UniqueFd&) = delete;
  ~UniqueFd() { reset(); }

  // Borrowed: valid as long as the owner.
  int get() const { return fd_; }
  bool valid() const { return fd_ >= 0; }
  // Gives the descriptor away without closing it, and holds none afterwards.
  int release() { return std::exchange(fd_, -1); }
  // Closes what it holds, if anything.
  void reset() {
    if (fd_ >= 0) ::close(std::exchange(fd_, -1));
  }

 private:
  // -1 while there is none.
  int fd_ = -1;
};

}  // namespace kaori
