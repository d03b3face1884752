// One HID device through the kernel's hidraw node.
#pragma once

#include <deque>
#include <memory>
#include <span>
#include <vector>

#include "drivers/base/background_writer.h"
#include "drivers/base/unique_fd.h"
#include "drivers/decode/initial_reports.h"
#include "drivers/ports/hid_channel.h"

namespace kaori::hid {

// As ports::HidChannel. The kernel sends an output report before its write(2) returns, which blocks about 1 ms,
// and up to the kernel's time-out of 5 s when a device does not answer: a thread of the channel's own does that,
// from the first output report on, one report at a time. Until it is sent, Write says
// resource_unavailable_try_again, and what was wrong with one is told by the Write after it. Reports are
// read whole: one read(2) gives one. The kernel keeps a ring of 64 and drops the newest beyond that. One thread
// calls the members; the channel's end waits for the report that is under way.
class HidrawChannel final : public ports::HidChannel {
 public:
  // `node` is an open, non-blocking hidraw node. Borrows `clock` for its life.
  HidrawChannel(UniqueFd node, ports::HidIdentity identity, const Clock& clock);

  // Requests these reports from the device by GET_REPORT. Read gives the answers first, before what the
  // device sends by itself. Called once at most, before pollable(), which it may change. Linux drops what a
  // device sends in the first 50 ms after it was opened, and a stick that is held still sends no more; so its
  // position would be unknown. A device that stalls, or whose answer is not plausible, has no initial report,
  // which is no error. Blocks about 1 ms for each report. Errors: those of epoll_create1(2) and eventfd(2),
  // and then no answer is given;
  //   timed_out  the device did not answer at all; that took 5 s
  Result<void> RequestInitialReports(std::span<const decode::InitialReport> reports);

  int pollable() const override { return ready_.valid() ? ready_.get() : node_.get(); }
  const ports::HidIdentity& identity() const override { return identity_; }
  Result<ports::HidInput> Read(std::span<std::uint8_t> into) override;
  Result<void> Write(std::span<const std::uint8_t> report) override;
  Result<std::size_t> GetFeature(std::span<std::uint8_t> into) override;
  Result<void> SetFeature(std::span<const std::uint8_t> report) override;

 private:
  // The error of a failed call by its errno; `verb` ends with a space. Notes where the device is gone.
  tl::unexpected<Error> Failed(int error, const char* verb);
  tl::unexpected<Error> Gone() const;

  // On the sender's thread.
  void Send();

  // One GET_REPORT; its answer goes to the end of `initial_`.
  Result<void> RequestReport(const decode::InitialReport& report);
  // Makes the descriptor that is readable while answers wait, and when the node is.
  Result<void> TellOfInitial();

  // Opened for reading and writing, without blocking.
  UniqueFd node_;
  // Read once, when it was opened.
  ports::HidIdentity identity_;
  // Stamps reports: hidraw has no stamps of its own.
  const Clock& clock_;
  std::deque<std::vector<std::uint8_t>> initial_;  // Answers that Read has not given yet.
  UniqueFd ready_;  // An epoll set of the node and `initial_waits_`; invalid where there was no answer.
  UniqueFd initial_waits_;  // Readable; closed with the last answer.
  // Noted once; from then on no call touches the node.
  bool gone_ = false;
  // The channel's while the sender is not busy, and the sender's while it is.
  std::vector<std::uint8_t> sending_;
  int send_errno_ = 0;  // Of the report before; 0: it was sent.
  std::unique_ptr<BackgroundWriter>
      sender_;  // Last: it uses the others. Null before the first output report.
};

// The report descriptor of an open hidraw node. Errors: those of ioctl(2): no_such_device, io_error.
Result<std::vector<std::uint8_t>> ReadHidrawDescriptor(int node);

}  // namespace kaori::hid
