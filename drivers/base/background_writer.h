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

// Runs one function on a thread of its own whenever it is asked to, and merges what is
// asked for meanwhile into one call. Whoever draws the next frame never waits for a disk,
// which can take seconds to answer. The function and its caller share data by a lock, or
// by busy(), of their own. One thread calls the members.
class BackgroundWriter {
 public:
  // Writes all that was asked for until now. Returns false where something is left to write: then it is
  // called again, no sooner than after the pause.
  using Write = std::function<bool()>;

  // `pause` lies between two calls of `write`, which keeps a disk that fails or wears out from being written
  // to all the time; 0 for none.
  BackgroundWriter(std::chrono::milliseconds pause, Write write);
  // Calls `write` once more where something is left, whether it succeeds or not, and waits for it.
  ~BackgroundWriter();
  BackgroundWriter(const BackgroundWriter&) = delete;
  BackgroundWriter& operator=(const BackgroundWriter&) = delete;

  // Asks for a call of `write`: as soon as the pause allows, or `at_once`. Holds the lock only
  // for as long as the other side counts, never while it writes: the caller waits for no disk.
  // Allocates nothing, so that the frame path may call it.
  void Ask(bool at_once = false);

  // Something was asked for and is not written yet. Once it is false, what `write` left behind is
  // visible to the caller (release and acquire), until the next Ask.
  bool busy() const { return busy_.load(std::memory_order_acquire); }

  // Waits until all that was asked for has been tried once, without the pause. Returns at once where
  // nothing is left to write. Blocks for the disk: for a program's end, never for the frame path.
  void Finish();

 private:
  // The thread's function: waits for work, does it, and lets the pause pass.
  void Run();

  std::chrono::milliseconds pause_;
  Write write_;
  std::mutex mutex_;
  std::condition_variable changed_;
  // Written under the mutex and read without it: the frame path must not wait for the thread.
  std::atomic<bool> busy_ = false;
  // How often Ask was called, and how many of these calls a call of `write` has
  // covered. Both are guarded by the mutex, as all below are.
  std::uint64_t asked_ = 0;
  std::uint64_t tried_ = 0;
  // The pause is to be cut short: somebody waits for the disk.
  bool at_once_ = false;
  // The destructor runs: the thread ends after one more try.
  bool ending_ = false;
  std::thread thread_;  // Last: it uses all the others.
};

}  // namespace kaori
