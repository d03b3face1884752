// A disk in memory that remembers every write and every flush, so that all that a power cut can leave of it can be
// looked at afterwards.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "drivers/ports/block_device.h"

namespace kaori::sim {

// What happened on a disk, in order.
struct DiskEvent {
  // On the disk.
  std::uint64_t at_bytes = 0;
  // What was written; empty: a flush.
  std::vector<std::uint8_t> content;
};

// Writes reach the content at once, as a disk's memory has them; what of it a cut leaves is for the test to say, by the
// events: what was flushed is there, and of what was not any part, in any order.
//
// One thread. Its partitions must not outlive it.
class SimulatedDisk {
 public:
  // Full of zeros.
  explicit SimulatedDisk(std::uint64_t bytes) : content_(bytes) {}

  // The appliance's side.
  std::unique_ptr<ports::BlockDevice> Partition(std::uint64_t at_bytes, std::uint64_t length_bytes);

  // The test's side. What a read gives, to be prepared and to be spoilt; nothing of it is remembered.
  std::vector<std::uint8_t>& content() { return content_; }
  // Since the disk was made, or forgot them.
  const std::vector<DiskEvent>& events() const { return events_; }
  void ForgetEvents() { events_.clear(); }
  // A worn disk, which says so.
  // So many more writes succeed; each one after them, and each flush, fails with io_error.
  void FailAfter(std::uint64_t writes) { writes_left_ = writes; }
  // A worn disk, which does not.
  // What is written from now on is another byte on the disk than it was told: it rots.
  void Rot() { rots_ = true; }

 private:
  class Part;
  // Takes one off writes_left_. Errors: io_error, there was none left.
  Result<void> Spend();

  std::vector<std::uint8_t> content_;
  std::vector<DiskEvent> events_;
  std::uint64_t writes_left_ = UINT64_MAX;
  bool rots_ = false;
};

}  // namespace kaori::sim
