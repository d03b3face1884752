#include "drivers/base/background_writer.h"

#include <utility>

namespace kaori {

BackgroundWriter::BackgroundWriter(std::chrono::milliseconds pause, Write write)
    : pause_(pause), write_(std::move(write)), thread_([this] { Run(); }) {}

BackgroundWriter::~BackgroundWriter() {
  {
    const std::scoped_lock lock(mutex_);
    ending_ = at_once_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void BackgroundWriter::Ask(bool at_once) {
  {
    const std::scoped_lock lock(mutex_);
    ++asked_;
    at_once_ = at_once_ || at_once;
    busy_.store(true, std::memory_order_release);
  }
  changed_.notify_all();
}

void BackgroundWriter::Finish() {
  std::unique_lock lock(mutex_);
  if (!busy()) return;
  if (tried_ >= asked_) ++asked_;  // What was refused is tried once more.
  at_once_ = true;
  changed_.notify_all();
  changed_.wait(lock, [this, asked = asked_] { return tried_ >= asked; });
}

void BackgroundWriter::Run() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return busy() || ending_; });
    const bool last = ending_;
    if (!busy()) return;
    at_once_ = false;
    const auto asked = asked_;
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
