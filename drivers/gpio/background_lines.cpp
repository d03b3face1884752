#include "drivers/gpio/background_lines.h"

#include <poll.h>
#include <sys/eventfd.h>

#include <array>
#include <utility>

namespace kaori::gpio {
namespace {

using ports::GpioEdge;

// What a reader that is away for long is told at last: the newest.
constexpr std::size_t kMostEdges = 512;
// A line that bounces without end must not look like a chip that does not answer.
constexpr int kReadAtOnce = 256;
constexpr std::uint32_t kLevelBits = 32;  // The bits of a level.
// As often as a polled line is read: a fault that lasts is told so often, and one of a moment is over by then.
constexpr int kAfterFault_ms = 40;

void Empty(const UniqueFd& event) {
  eventfd_t count = 0;
  ::eventfd_read(event.get(), &count);  // Non-blocking: empty is as good.
}

}  // namespace

Result<std::unique_ptr<BackgroundLines>> BackgroundLines::Begin(std::unique_ptr<ports::GpioLines> lines,
                                                                std::size_t outputs, const Clock& clock) {
  const auto levels = lines->Levels();
  if (!levels) return tl::unexpected(levels.error());
  UniqueFd told(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)), wake(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
  if (!told.valid() || !wake.valid()) return FailErrno("read GPIO lines on a thread");
  return std::unique_ptr<BackgroundLines>(
      new BackgroundLines(std::move(lines), outputs, clock, *levels, std::move(told), std::move(wake)));
}

BackgroundLines::BackgroundLines(std::unique_ptr<ports::GpioLines> lines, std::size_t outputs,
                                 const Clock& clock, std::uint32_t levels, UniqueFd told, UniqueFd wake)
    : lines_(std::move(lines)),
      clock_(clock),
      told_(std::move(told)),
      wake_(std::move(wake)),
      levels_(levels),
      given_(levels),
      wanted_(outputs),
      thread_([this] { Run(); }) {}

BackgroundLines::~BackgroundLines() {
  {
    const std::scoped_lock lock(mutex_);
    is_ending_ = true;
  }
  ::eventfd_write(wake_.get(), 1);
  thread_.join();
}

Result<std::uint32_t> BackgroundLines::Levels() {
  const std::scoped_lock lock(mutex_);
  if (IsLost()) return tl::unexpected(*gone_);
  return edges_.empty() ? levels_ : given_;
}

Result<GpioEdge> BackgroundLines::ReadEdge() {
  const std::scoped_lock lock(mutex_);
  if (!edges_.empty()) {
    const GpioEdge edge = edges_.front();
    edges_.pop_front();
    const std::uint32_t bit = 1U << edge.line;
    given_ = edge.active ? given_ | bit : given_ & ~bit;
    if (edges_.empty() && !fault_ && !gone_) Empty(told_);
    return edge;
  }
  if (IsLost()) return tl::unexpected(*gone_);
  if (!fault_) return Fail(std::errc::resource_unavailable_try_again, "read GPIO lines");
  Empty(told_);
  return tl::unexpected(*std::exchange(fault_, std::nullopt));
}

Result<void> BackgroundLines::Drive(std::uint32_t line, bool active) {
  const std::scoped_lock lock(mutex_);
  if (line >= wanted_.size())
    return FailInput("drive GPIO output " + std::to_string(line) + ", which is not wired");
  if (IsLost()) return tl::unexpected(*gone_);
  wanted_[line] = active;
  ::eventfd_write(wake_.get(), 1);
  return {};
}

bool BackgroundLines::IsLost() {
  if (!gone_ && asked_ != Time{} && clock_.now() - asked_ > kLongestAnswer)
    gone_ = Error{std::errc::no_such_device, "the GPIO lines do not answer"};
  return gone_.has_value();
}

void BackgroundLines::Run() {
  while (Wait()) {
    DriveOutputs();
    if (const auto read = ReadLines(); !read) {
      wants_levels_ = true;
      Report(read.error());
      continue;
    }
    const std::scoped_lock lock(mutex_);
    asked_ = {};
  }
}

// What the chip owes after a fault is asked for again soon, and it owes it since before the fault.
bool BackgroundLines::Wait() {
  std::array<pollfd, 2> waiting{pollfd{.fd = wake_.get(), .events = POLLIN, .revents = 0},
                                pollfd{.fd = lines_->pollable(), .events = POLLIN, .revents = 0}};
  const bool owes = [this] {
    const std::scoped_lock lock(mutex_);
    return asked_ != Time{};
  }();
  if (owes)
    ::poll(waiting.data(), 1, kAfterFault_ms);
  else
    ::poll(waiting.data(), waiting.size(), -1);
  const std::scoped_lock lock(mutex_);
  if (waiting[0].revents != 0) Empty(wake_);
  if (!owes) asked_ = clock_.now();
  return !is_ending_ && !gone_;
}

void BackgroundLines::NoteAnswer() {
  const std::scoped_lock lock(mutex_);
  asked_ = clock_.now();
}

// A lamp that fails is no reason to lose the switches: a chip that is gone is noticed by reading.
void BackgroundLines::DriveOutputs() {
  for (std::size_t line = 0; line < wanted_.size(); ++line) {
    std::unique_lock lock(mutex_);
    const auto wanted = std::exchange(wanted_[line], std::nullopt);
    lock.unlock();
    if (!wanted) continue;
    const bool is_driven = lines_->Drive(static_cast<std::uint32_t>(line), *wanted).has_value();
    if (is_driven) NoteAnswer();
    lock.lock();
    if (!is_driven && !wanted_[line]) wanted_[line] = wanted;
  }
}

// The kernel keeps a bounded number of edges: what it lost shows in the levels, which are asked for until they are known. What is made up
// of them is stamped by the time before, so that no edge that comes meanwhile is older; and an edge that has come meanwhile says when
// its line changed, which the levels do not.
Result<void> BackgroundLines::ReadLines() {
  for (int n = 0; n < kReadAtOnce; ++n) {
    if (const auto edge = lines_->ReadEdge(); edge) {
      wants_levels_ = true;
      NoteAnswer();
      Give(*edge);
      continue;
    } else if (edge.error().cause != std::errc::resource_unavailable_try_again) {
      return tl::unexpected(edge.error());
    }
    if (!wants_levels_) return {};
    const Time before = clock_.now();
    const auto levels = lines_->Levels();
    if (!levels) return tl::unexpected(levels.error());
    if (const auto meanwhile = lines_->ReadEdge()) {
      Give(*meanwhile);
      continue;
    }
    wants_levels_ = false;
    for (std::uint32_t line = 0; line < kLevelBits; ++line)
      Give({.at = before, .line = line, .active = (*levels >> line & 1U) != 0});
    return {};
  }
  ::eventfd_write(wake_.get(), 1);  // There may be more; the levels come behind them.
  return {};
}

// An edge that changes nothing was given before, from the levels.
void BackgroundLines::Give(const GpioEdge& edge) {
  const std::scoped_lock lock(mutex_);
  const std::uint32_t bit = 1U << edge.line;
  if (((levels_ & bit) != 0) == edge.active) return;
  levels_ ^= bit;
  if (edges_.size() == kMostEdges) edges_.pop_front();
  edges_.push_back(edge);
  ::eventfd_write(told_.get(), 1);
}

void BackgroundLines::Report(const Error& error) {
  const std::scoped_lock lock(mutex_);
  (error.cause == std::errc::no_such_device ? gone_ : fault_) = error;
  ::eventfd_write(told_.get(), 1);
}

}  // namespace kaori::gpio
