// Lines of a chip that a test may keep from answering, as one behind a cable that goes bad; used from any thread.
#pragma once

#include <sys/eventfd.h>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

#include "drivers/base/clock.h"
#include "drivers/base/unique_fd.h"
#include "drivers/ports/gpio_lines.h"

namespace kaori::tests {

// A clock that a test advances while a thread looks at it.
class SharedClock final : public Clock {
 public:
  Time now() const override { return Time(Duration(now_ns_.load())); }
  void Advance(Duration by) { now_ns_ += by.count(); }

 private:
  std::atomic<Duration::rep> now_ns_ = Duration(std::chrono::hours(1)).count();
};

// The test's side, which outlives the lines.
class SlowChip {
 public:
  // An edge, and the level after it.
  void Switch(std::uint32_t line, bool active, Time at) {
    const std::scoped_lock lock(mutex_);
    edges_.push_back({.at = at, .line = line, .active = active});
    SetLevel(line, active);
  }
  // A change of which the kernel tells nothing but that there was one.
  void SwitchUnseen(std::uint32_t line, bool active) {
    const std::scoped_lock lock(mutex_);
    SetLevel(line, active);
  }
  // An edge that comes when the levels are asked for next, before they are given.
  void SwitchWhileAsked(const ports::GpioEdge& edge) {
    const std::scoped_lock lock(mutex_);
    comes_meanwhile_ = edge;
  }
  void Unplug() {
    const std::scoped_lock lock(mutex_);
    is_gone_ = true;
    ::eventfd_write(event_.get(), 1);
  }
  void FailOnce() {
    const std::scoped_lock lock(mutex_);
    fails_ = true;
    ::eventfd_write(event_.get(), 1);
  }
  // Every call fails from now on, until none does.
  void FailAlways(bool fails) {
    const std::scoped_lock lock(mutex_);
    fails_always_ = fails;
    ::eventfd_write(event_.get(), 1);
  }
  // No call returns any more.
  void Hold() {
    const std::scoped_lock lock(mutex_);
    is_held_ = true;
    ::eventfd_write(event_.get(), 1);
  }
  void LetGo() {
    {
      const std::scoped_lock lock(mutex_);
      is_held_ = false;
    }
    changed_.notify_all();
  }
  bool IsDrained() {
    const std::scoped_lock lock(mutex_);
    return edges_.empty();
  }
  // Waits until a call is held.
  void AwaitHeld() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return waiting_ > 0; });
  }
  // Whether the lamp is lit within the time that a thread may take.
  bool LampBecomes(bool lit) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, std::chrono::seconds(5), [&] { return lamp_ == lit; });
  }

 private:
  friend class SlowLines;
  void SetLevel(std::uint32_t line, bool active) {
    levels_ = active ? levels_ | 1U << line : levels_ & ~(1U << line);
    ::eventfd_write(event_.get(), 1);
  }
  // To be called first by each call of the lines.
  std::unique_lock<std::mutex> Enter() {
    std::unique_lock lock(mutex_);
    ++waiting_;
    changed_.notify_all();
    changed_.wait(lock, [this] { return !is_held_; });
    --waiting_;
    return lock;
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  UniqueFd event_{::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)};
  std::deque<ports::GpioEdge> edges_;
  std::uint32_t levels_ = 0;
  std::optional<ports::GpioEdge> comes_meanwhile_;
  int waiting_ = 0;
  bool lamp_ = false, is_gone_ = false, is_held_ = false, fails_ = false, fails_always_ = false;
};

// Two inputs and one output.
class SlowLines final : public ports::GpioLines {
 public:
  explicit SlowLines(SlowChip& chip) : chip_(chip) {}
  int pollable() const override { return chip_.event_.get(); }
  Result<std::uint32_t> Levels() override {
    const auto lock = chip_.Enter();
    if (chip_.is_gone_) return Gone();
    if (chip_.fails_always_) return Failed();
    if (const auto edge = std::exchange(chip_.comes_meanwhile_, std::nullopt)) {
      chip_.edges_.push_back(*edge);
      chip_.SetLevel(edge->line, edge->active);
    }
    return chip_.levels_;
  }
  Result<ports::GpioEdge> ReadEdge() override {
    const auto lock = chip_.Enter();
    if (chip_.is_gone_) return Gone();
    if (std::exchange(chip_.fails_, false) || chip_.fails_always_) return Failed();
    eventfd_t count = 0;
    if (chip_.edges_.empty()) {
      ::eventfd_read(chip_.event_.get(), &count);
      return Fail(std::errc::resource_unavailable_try_again, "read a line");
    }
    const ports::GpioEdge edge = chip_.edges_.front();
    chip_.edges_.pop_front();
    return edge;
  }
  Result<void> Drive(std::uint32_t /*line*/, bool active) override {
    const auto lock = chip_.Enter();
    if (chip_.is_gone_) return Gone();
    if (chip_.fails_always_) return Failed();
    chip_.lamp_ = active;
    chip_.changed_.notify_all();
    return {};
  }

 private:
  static tl::unexpected<Error> Failed() { return Fail(std::errc::io_error, "use a chip that fails"); }
  static tl::unexpected<Error> Gone() { return Fail(std::errc::no_such_device, "use an unplugged chip"); }

  SlowChip& chip_;
};

}  // namespace kaori::tests
