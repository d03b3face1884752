#include "drivers/hid/hidraw_channel.h"

#include <linux/hidraw.h>
#include <poll.h>
#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

namespace kaori::hid {
namespace {

using ports::HidInput;

// The kernel hangs a node up when its device is gone.
bool is_hung_up(int fd) {
  pollfd state{.fd = fd, .events = POLLOUT, .revents = 0};
  return ::poll(&state, 1, 0) > 0 && (state.revents & (POLLERR | POLLHUP)) != 0;
}

}  // namespace

HidrawChannel::HidrawChannel(UniqueFd node, ports::HidIdentity identity, const Clock& clock)
    : node_(std::move(node)), identity_(std::move(identity)), clock_(clock) {}

Result<void> HidrawChannel::RequestInitialReports(std::span<const decode::InitialReport> reports) {
  Result<void> asked;
  for (const decode::InitialReport& report : reports)
    if (asked = RequestReport(report); !asked) break;
  if (initial_.empty()) return asked;
  if (auto told = TellOfInitial(); !told) {
    initial_.clear();
    return told;
  }
  return asked;
}

// The kernel knows nothing of the answers: an eventfd beside the node is readable until Read has given the
// last one, and leaves the epoll set when it is closed.
Result<void> HidrawChannel::TellOfInitial() {
  ready_ = UniqueFd(::epoll_create1(EPOLL_CLOEXEC));
  initial_waits_ = UniqueFd(::eventfd(1, EFD_CLOEXEC | EFD_NONBLOCK));
  for (const int fd : {node_.get(), initial_waits_.get()}) {
    epoll_event event{};
    event.events = EPOLLIN;
    if (::epoll_ctl(ready_.get(), EPOLL_CTL_ADD, fd, &event) == 0) continue;
    auto failed = FailErrno("watch " + identity_.port);
    ready_.reset();
    initial_waits_.reset();
    return failed;
  }
  return {};
}

// The kernel's answer begins with the report's number, or with a 0 that was not on the
// cable. Errors other than the time-out (a stall gives EPIPE, an old kernel ENOTTY for
// HIDIOCGINPUT, which came with 5.11) leave the report out.
Result<void> HidrawChannel::RequestReport(const decode::InitialReport& report) {
  std::vector<std::uint8_t> answer(1 + report.bytes);
  answer[0] = report.id;
  const int got = ::ioctl(node_.get(), HIDIOCGINPUT(answer.size()), answer.data());
  if (got < 0 && errno == ETIMEDOUT)
    return Fail(std::errc::timed_out, "request the state of " + identity_.port);
  if (got < 1 || answer[0] != report.id) return {};
  answer.resize(std::min(answer.size(), static_cast<std::size_t>(got)));
  if (!decode::IsPlausible(report, std::span(answer).subspan(1))) return {};
  if (report.id == 0) answer.erase(answer.begin());
  initial_.push_back(std::move(answer));
  return {};
}

Result<HidInput> HidrawChannel::Read(std::span<std::uint8_t> into) {
  if (gone_) return Gone();
  // Initial reports come first: they tell the state before any report that was sent since.
  if (!initial_.empty()) {
    const auto report = std::exchange(initial_.front(), {});
    initial_.pop_front();
    if (initial_.empty()) initial_waits_.reset();
    const std::size_t bytes = std::min(report.size(), into.size());
    std::copy_n(report.begin(), bytes, into.begin());
    return HidInput{.at = clock_.now(), .bytes = bytes};
  }
  const ssize_t bytes = ::read(node_.get(), into.data(), into.size());
  if (bytes < 0) return Failed(errno, "read ");
  if (bytes == 0) return Failed(ENODEV, "read ");  // A node that hung up ends like a file.
  return HidInput{.at = clock_.now(), .bytes = static_cast<std::size_t>(bytes)};
}

Result<void> HidrawChannel::Write(std::span<const std::uint8_t> report) {
  gone_ = gone_ || is_hung_up(node_.get());
  if (gone_) return Gone();
  if (report.empty()) return FailInput("write an empty report to " + identity_.port);
  if (sender_ && sender_->busy())
    return Fail(std::errc::resource_unavailable_try_again, "write " + identity_.port);
  if (const int error = std::exchange(send_errno_, 0)) return Failed(error, "write ");
  sending_.assign(report.begin(), report.end());
  if (!sender_)
    sender_ =
        std::make_unique<BackgroundWriter>(std::chrono::milliseconds(0), [this] { return Send(), true; });
  sender_->Ask();
  return {};
}

// A write of a part is a fault and not tried again: the rest alone would be taken for another report.
void HidrawChannel::Send() {
  const ssize_t bytes = ::write(node_.get(), sending_.data(), sending_.size());
  if (bytes < 0)
    send_errno_ = errno;
  else if (static_cast<std::size_t>(bytes) != sending_.size())
    send_errno_ = EIO;
}

Result<std::size_t> HidrawChannel::GetFeature(std::span<std::uint8_t> into) {
  if (gone_) return Gone();
  const int got = ::ioctl(node_.get(), HIDIOCGFEATURE(into.size()), into.data());
  if (got < 0) return Failed(errno, "read a feature of ");
  return static_cast<std::size_t>(got);
}

Result<void> HidrawChannel::SetFeature(std::span<const std::uint8_t> report) {
  if (gone_) return Gone();
  if (::ioctl(node_.get(), HIDIOCSFEATURE(report.size()), report.data()) < 0)
    return Failed(errno, "send a feature to ");
  return {};
}

// The kernel says EIO both for a pulled cable and for a transfer that failed, and EPIPE for a report that the device
// refused by a STALL, which is no pulled cable; the hang-up tells them apart.
tl::unexpected<Error> HidrawChannel::Failed(int error, const char* verb) {
  if (error == EAGAIN || error == EINTR)
    return Fail(std::errc::resource_unavailable_try_again, verb + identity_.port);
  // ESHUTDOWN comes from the USB layers below.
  const bool says_gone = error == ENODEV || error == ENXIO || error == ESHUTDOWN;
  gone_ = says_gone || is_hung_up(node_.get());
  if (gone_) return Gone();
  return Fail(std::errc::io_error, verb + identity_.port);
}

tl::unexpected<Error> HidrawChannel::Gone() const {
  return Fail(std::errc::no_such_device, "use " + identity_.port);
}

Result<std::vector<std::uint8_t>> ReadHidrawDescriptor(int node) {
  int bytes = 0;
  if (::ioctl(node, HIDIOCGRDESCSIZE, &bytes) < 0) return FailErrno("read the size of a report descriptor");
  // HID_MAX_DESCRIPTOR_SIZE is the size of the kernel's own buffer.
  hidraw_report_descriptor descriptor{};
  descriptor.size = static_cast<std::uint32_t>(std::clamp(bytes, 0, HID_MAX_DESCRIPTOR_SIZE));
  if (::ioctl(node, HIDIOCGRDESC, &descriptor) < 0) return FailErrno("read a report descriptor");
  // The kernel fills in `size` bytes; the struct has room for the longest.
  return std::vector<std::uint8_t>(descriptor.value, descriptor.value + descriptor.size);
}

}  // namespace kaori::hid
