// A thread that writes to the disk, so that no frame waits for one.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>

namespace kaori {

// Runs one function on a thread of its own whenever it is asked to. The function and its caller share data by a lock,
// or by busy(), of their own. One thread calls the members.
class BackgroundWriter {
 public:
  // Writes all that was asked for until now. Returns false where something is left to write: then it is called again,
  // no sooner than after the pause.
  using Write = std::function<bool()>;

  // `pause` lies between two calls of `write`, which keeps a disk that fails or wears out from being written to all the
  // time; 0 for none.
  BackgroundWriter(std::chrono::milliseconds pause, Write write);
  // Calls `write` once more where something is left, whether it succeeds or not, and waits for it.
  ~BackgroundWriter();
  BackgroundWriter(const BackgroundWriter&) = delete;
  BackgroundWriter& operator=(const BackgroundWriter&) = delete;

  // Asks for a call of `write`: as soon as the pause allows, or `at_once`. Waits for no disk and allocates nothing.
  void Ask(bool at_once = false);

  // Something was asked for and is not written yet.
  bool busy() const { return busy_.load(std::memory_order_acquire); }

  // Waits until all that was asked for has been tried once.
  void Finish();

 private:
  void Run();

  std::chrono::milliseconds pause_;
  Write write_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::atomic<bool> busy_ = false;
  std::uint64_t asked_ = 0;  // How often Ask was called,
  std::uint64_t tried_ = 0;  // and how many of these a call of `write` has covered.
  bool at_once_ = false;
  bool ending_ = false;
  std::thread thread_;  // Last: it uses all the others.
};

}  // namespace kaori
