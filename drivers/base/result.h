// What can fail returns Result<T>: a value, or an Error that names the attempt, its cause and its kind.
#pragma once

#include <cerrno>
#include <cstdint>
#include <string>
#include <system_error>
#include <utility>

#include <tl/expected.hpp>

namespace kaori {

// Who can mend it, which decides what a person is told and whether a caller tries again.
enum class ErrorKind : std::uint8_t {
  kSystem,       // The kernel, a library or a device refused: the cause belongs to the message.
  kUnavailable,  // Nothing is there yet (EAGAIN): the same call can succeed later without any change.
  kInput,        // A file, a message or an option is wrong: the attempt itself says where and why.
};

// Describes one failure. `cause` is the errno of a system call, or the one that
// fits best; callers decide by it, people read message(). Values, not classes: an
// error is compared, copied and passed on like a number.
struct [[nodiscard]] Error {
  // What callers decide by. Zero is no error and never stands here.
  std::errc cause{};
  std::string attempt;  // What was tried and on which object: "open /dev/hidraw0".
  // Follows from the cause, but for kInput, which only the place that found the fault can know.
  ErrorKind kind = ErrorKind::kSystem;

  // The line for people: "open /dev/hidraw0: No such device"; for kInput the attempt alone.
  std::string message() const {
    if (kind == ErrorKind::kInput) return attempt;
    return attempt + ": " + std::make_error_code(cause).message();
  }
};

// Holds a value, or the error that came instead of it; Result<void> holds nothing or
// the error. Reading the value of a failed one is our own bug (undefined in a
// release build): it is tested first. Nothing throws.
template <class T>
using Result = tl::expected<T, Error>;

// Fails with the errno of a system call, or with a cause of our own choice. The kind follows from the cause:
// resource_unavailable_try_again is kUnavailable, all others are kSystem.
inline tl::unexpected<Error> Fail(std::errc cause, std::string attempt) {
  const bool later = cause == std::errc::resource_unavailable_try_again;
  return tl::unexpected<Error>(
      Error{cause, std::move(attempt), later ? ErrorKind::kUnavailable : ErrorKind::kSystem});
}

// Reads the cause from errno: it must be called before anything else can change errno, and never after
// iostreams, which do not say that they set it.
inline tl::unexpected<Error> FailErrno(std::string attempt) {
  return Fail(static_cast<std::errc>(errno), std::move(attempt));
}

// A file, a message or an option that people wrote is wrong: `what` says where and why in words, as
// "show.toml:12: `rate` must be above 0". The cause is for callers; people do not see it.
inline tl::unexpected<Error> FailInput(std::string what, std::errc cause = std::errc::invalid_argument) {
  return tl::unexpected<Error>(Error{cause, std::move(what), ErrorKind::kInput});
}

// The same cause and kind under another attempt, as when a caller knows the object's name and the callee
// does not. Other facts of the first attempt are lost, so `attempt` says all.
inline tl::unexpected<Error> FailAs(const Error& error, std::string attempt) {
  return tl::unexpected<Error>(Error{error.cause, std::move(attempt), error.kind});
}

}  // namespace kaori
