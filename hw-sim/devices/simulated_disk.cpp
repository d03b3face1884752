#include "hw-sim/devices/simulated_disk.h"

#include <algorithm>

namespace kaori::sim {

// A window on the disk.
class SimulatedDisk::Part final : public ports::BlockDevice {
 public:
  Part(SimulatedDisk& disk, std::uint64_t at_bytes, std::uint64_t length_bytes)
      : disk_(disk), at_bytes_(at_bytes), length_bytes_(length_bytes) {}

  std::uint64_t bytes() const override { return length_bytes_; }

  Result<void> Read(std::uint64_t at, std::span<std::uint8_t> into) override {
    if (auto ok = CheckRange(at, into.size()); !ok) return ok;
    std::copy_n(disk_.content_.begin() + static_cast<std::ptrdiff_t>(at_bytes_ + at), into.size(),
                into.begin());
    return {};
  }

  Result<void> Write(std::uint64_t at, std::span<const std::uint8_t> from) override {
    if (auto ok = CheckRange(at, from.size()); !ok) return ok;
    if (auto ok = disk_.Spend(); !ok) return ok;
    DiskEvent event{at_bytes_ + at, {from.begin(), from.end()}};
    if (disk_.rots_ && !event.content.empty()) event.content.back() ^= 1U;
    std::ranges::copy(event.content, disk_.content_.begin() + static_cast<std::ptrdiff_t>(event.at_bytes));
    disk_.events_.push_back(std::move(event));
    return {};
  }

  Result<void> Flush() override {
    if (disk_.writes_left_ == 0) return Fail(std::errc::io_error, "flush the simulated disk");
    disk_.events_.push_back({});
    return {};
  }

 private:
  Result<void> CheckRange(std::uint64_t at, std::uint64_t length) const {
    if (at <= length_bytes_ && length <= length_bytes_ - at) return {};
    return Fail(std::errc::invalid_argument, "reach behind the end of the simulated disk");
  }

  SimulatedDisk& disk_;
  std::uint64_t at_bytes_, length_bytes_;
};

std::unique_ptr<ports::BlockDevice> SimulatedDisk::Partition(std::uint64_t at_bytes,
                                                             std::uint64_t length_bytes) {
  return std::make_unique<Part>(*this, at_bytes, length_bytes);
}

Result<void> SimulatedDisk::Spend() {
  if (writes_left_ == 0) return Fail(std::errc::io_error, "write the simulated disk");
  --writes_left_;
  return {};
}

}  // namespace kaori::sim
