// What the contract suites share: a suite's tests are the sentences of
// a port's header, and every implementation of the port must pass them.
#pragma once

#include <gtest/gtest.h>
#include <poll.h>

#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <system_error>

#include "drivers/base/result.h"

namespace kaori::contracts {

// An implementation by name, and how to make a subject: the implementation, and the device behind it. The
// name is part of the tests' names: letters and digits alone.
template <class Subject>
struct Implementation {
  const char* name;
  std::function<std::unique_ptr<Subject>()> make;
};

// For GoogleTest, which else lists a test with the bytes of its parameter.
template <class Subject>
void PrintTo(const Implementation<Subject>& implementation, std::ostream* out) {
  *out << implementation.name;
}

template <class Subject>
std::string NameOf(const ::testing::TestParamInfo<Implementation<Subject>>& info) {
  return info.param.name;
}

// The cause of a failure; nothing for success.
template <class T>
std::errc Cause(const Result<T>& result) {
  return result ? std::errc{} : result.error().cause;
}

// Whether the descriptor is readable now, or within the time that a fake device's own thread may take.
inline bool IsReadable(int fd, int wait_ms = 0) {
  pollfd state{.fd = fd, .events = POLLIN, .revents = 0};
  return ::poll(&state, 1, wait_ms) > 0;
}
constexpr int kLongestWait_ms = 5000;

// Makes the subject of a test, and skips the test where the implementation cannot be made here.
template <class Subject>
class Contract : public ::testing::TestWithParam<Implementation<Subject>> {
 protected:
  void SetUp() override {
    subject_ = this->GetParam().make();
    ASSERT_NE(subject_, nullptr);
    if (const std::string reason = subject_->missing(); !reason.empty()) GTEST_SKIP() << reason;
  }

  std::unique_ptr<Subject> subject_;
};

// A base of all subjects.
class AnySubject {
 public:
  virtual ~AnySubject() = default;

  // Why this implementation cannot be tested here, in a sentence; empty: it can.
  virtual std::string missing() const { return {}; }
};

}  // namespace kaori::contracts
