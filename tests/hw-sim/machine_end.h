// The machine's end of a socket that the bench calls: the guest's serial line, QEMU's monitor. The bench waits by it, in
// one thread: no test sleeps.
#pragma once

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <string>
#include <utility>

#include "drivers/base/unique_fd.h"
#include "drivers/base/unix_address.h"
#include "hw-sim/hil/waiter.h"

namespace kaori::hil {

// Hears whole lines and says what the test has for each. A wait is over as soon as nothing more comes.
class MachineEnd final : public Waiter {
 public:
  // What is said to a line; empty: nothing.
  using Answer = std::function<std::string(const std::string& line)>;
  // `greeting` is said to whoever calls. `answer` is called while the bench waits.
  explicit MachineEnd(Answer answer, std::string greeting = {})
      : answer_(std::move(answer)),
        greeting_(std::move(greeting)),
        listener_(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
    std::string pattern = (std::filesystem::temp_directory_path() / "kaori-machine-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
    const auto address = UnixAddress(path()).value();
    EXPECT_EQ(::bind(listener_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(::listen(listener_.get(), 1), 0);
  }
  ~MachineEnd() override { std::filesystem::remove_all(folder_); }
  std::string path() const { return folder_ + "/line"; }

  bool Until(const std::function<bool()>& done, Duration /*longest*/, int /*fd*/) override {
    if (done()) return true;
    Serve();
    return done();
  }

  void Say(const std::string& bytes) {
    EXPECT_EQ(::send(peer_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(bytes.size()));
  }

 private:
  void Serve() {
    if (!peer_.valid()) {
      peer_ = UniqueFd(::accept4(listener_.get(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
      Say(greeting_);
    }
    for (char letter = 0; ::recv(peer_.get(), &letter, 1, 0) == 1;) {
      if (letter != '\n')
        line_ += letter;
      else
        Say(answer_(std::exchange(line_, {})));
    }
  }

  Answer answer_;
  std::string greeting_, folder_, line_;
  UniqueFd listener_, peer_;
};

}  // namespace kaori::hil
