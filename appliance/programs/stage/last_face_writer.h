// The thread that waits for the disk while the last face is written.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <system_error>
#include <thread>

#include "appliance/programs/stage/last_face.h"

namespace kaori::stage {

// Called by one thread. What cannot be written is logged in one line for each cause, and dropped.
class LastFace::Writer {
 public:
  explicit Writer(LastFaceFile where);
  // Waits until what it was given is written, or was refused.
  ~Writer();

  // To be filled for the next Write; null while one is under way.
  SmallImage* idle() { return busy_.load(std::memory_order_acquire) ? nullptr : &image_; }
  void Write(const board::Performance& performance);

  // The last writing failed; false from the next one on.
  bool failed() const { return failed_.load(std::memory_order_acquire); }

  // Waits until nothing is under way.
  void Finish();

 private:
  void Run();
  Result<void> WriteOut();

  LastFaceFile where_;
  SmallImage image_;  // Its owner changes with busy_.
  board::Performance performance_;
  std::vector<std::uint8_t> picture_, state_;  // Of the thread.
  std::error_code logged_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::atomic<bool> busy_ = false;
  std::atomic<bool> failed_ = false;
  bool ending_ = false;
  std::thread thread_;  // Last: it uses all the others.
};

}  // namespace kaori::stage
