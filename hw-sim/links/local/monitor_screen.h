// The screen on which a desk shows the operators' monitor: a file that the stage draws into
// (firmware/wire/link_monitor.h).
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::sim {

// One thread. Out at first: a stage draws no monitor then.
class MonitorScreen {
 public:
  // The link folder, which need not be there yet.
  explicit MonitorScreen(std::string folder) : folder_(std::move(folder)) {}
  MonitorScreen(const MonitorScreen&) = delete;
  MonitorScreen& operator=(const MonitorScreen&) = delete;
  ~MonitorScreen() { Unplug(); }

  static constexpr std::uint32_t kWidth_px = 1280, kHeight_px = 720;

  // Makes the file, or makes anew what a simulator that was killed has left. Does nothing where it is in. Errors:
  // those of open(2) and ftruncate(2).
  Result<void> Plug();
  // Removes it.
  void Unplug();
  bool plugged() const { return file_.valid(); }

  // R, G, B, X, the bottom row first; nothing where no other picture than the last one that was read is there, or
  // one is being written. Does not wait. Valid until the next Read.
  const std::vector<std::uint8_t>* Read();

 private:
  std::string folder_;
  UniqueFd file_;
  std::vector<std::uint8_t> bytes_, picture_;  // Kept for their memory.
  std::uint32_t read_ = 0;                     // The count of the last picture.
};

}  // namespace kaori::sim
