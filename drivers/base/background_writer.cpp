#include "drivers/base/background_writer.h"

#include <utility>

namespace kaori {

BackgroundWriter::BackgroundWriter(std::chrono::milliseconds pause, Write write)
    : pause_(pause), write_(std::move(write)), thread_([this] { Run(); }) {}

BackgroundWriter::~BackgroundWriter() {
  {
    const std::scoped_lock lock(mutex_);
    // The last call does not sit out the pause: a program that is stopped has some seconds only.
    ending_ = at_once_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void BackgroundWriter::Ask(bool at_once) {
  {
    const std::scoped_lock lock(mutex_);
    // Asks are counted rather than flagged: one that comes while `write` runs must lead
    // to another call, since that call may have missed it.
    ++asked_;
    at_once_ = at_once_ || at_once;
    busy_.store(true, std::memory_order_release);
  }
  changed_.notify_all();
}

void BackgroundWriter::Finish() {
  std::unique_lock lock(mutex_);
  if (!busy()) return;
  // An earlier call of `write` covered every ask and yet left something over (busy()
  // is still true). It gets one more try, as an ask of its own, so that the wait
  // below has an end even on a disk that always fails.
  if (tried_ >= asked_) ++asked_;
  at_once_ = true;
  changed_.notify_all();
  changed_.wait(lock, [this, asked = asked_] { return tried_ >= asked; });
}

// The writer's own thread, until the destructor. A write that failed in part keeps busy() true and is tried
// again after the pause, for as long as the program lives.
void BackgroundWriter::Run() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return busy() || ending_; });
    // Read before the work: an ask that comes with the end is still served, and exactly once.
    const bool last = ending_;
    if (!busy()) return;
    at_once_ = false;
    const auto asked = asked_;
    // The lock is open while the disk is written to, so that Ask() never waits for it.
    lock.unlock();
    const bool whole = write_();
    lock.lock();
    tried_ = asked;
    busy_.store(!whole || asked_ != asked, std::memory_order_release);
    changed_.notify_all();
    if (last) return;
    changed_.wait_for(lock, pause_, [this] { return at_once_; });
  }
}

}  // namespace kaori
