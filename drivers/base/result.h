// What can fail returns Result<T>: a value, or an Error that names the attempt and its cause.
#pragma once

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include <tl/expected.hpp>

namespace kaori {

// `attempt` names what was tried and on which object: "open /dev/hidraw0".
struct [[nodiscard]] Error {
  std::errc cause{};
  std::string attempt;

  // For people: "open /dev/hidraw0: No such device". What was wrong with an argument, a file or a message is
  // said by the attempt itself.
  std::string message() const {
    if (cause == std::errc::invalid_argument) return attempt;
    return attempt + ": " + std::make_error_code(cause).message();
  }
};

template <class T>
using Result = tl::expected<T, Error>;

inline tl::unexpected<Error> Fail(std::errc cause, std::string attempt) {
  return tl::unexpected<Error>(Error{cause, std::move(attempt)});
}

// Takes the cause from errno: call it on the line after the system call.
inline tl::unexpected<Error> FailErrno(std::string attempt) {
  return Fail(static_cast<std::errc>(errno), std::move(attempt));
}

// A file or message that people wrote is wrong: `what` says where and why, in words; no errno text helps.
inline tl::unexpected<Error> FailInput(std::string what) {
  return Fail(std::errc::invalid_argument, std::move(what));
}

}  // namespace kaori
