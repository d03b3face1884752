// A stream socket to a machine: what came so far, and a way to say something.
#pragma once

#include <string>
#include <string_view>

#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"
#include "hw-sim/hil/waiter.h"

namespace kaori::hil {

// A byte stream in both directions, with what came and was not used yet. Movable; the connection ends
// with it. One thread: that of the waiter.
class Stream {
 public:
  // Calls until somebody listens, `longest` at most; simulated devices play
  // on meanwhile. Errors: timed_out.
  static Result<Stream> Call(const std::string& path, Waiter& waiter, Duration longest);

  // Readable when something came or the other end has gone; for Waiter::Until.
  int pollable() const { return socket_.get(); }

  // Reads what has arrived behind what waits, without waiting. False: the other end is
  // gone; what came before is still there.
  bool Read();
  // All bytes that came and were not dropped, oldest first; they grow until somebody drops them.
  const std::string& waiting() const { return waiting_; }
  // The next line without its end, for which `longest` is waited at most. Errors: timed_out; no_such_device, once the
  // other end has gone and all its lines were read; both say that nothing was heard from `whom`.
  Result<std::string> NextLine(Waiter& waiter, Duration longest, const std::string& whom);
  // Removes what was used, from the beginning.
  void Drop(std::size_t bytes) { waiting_.erase(0, bytes); }

  // Short texts only: the socket's buffer must hold them. Errors: no_such_device.
  Result<void> Say(std::string_view text);

 private:
  explicit Stream(UniqueFd socket) : socket_(std::move(socket)) {}
  UniqueFd socket_;
  std::string waiting_;
};

}  // namespace kaori::hil
