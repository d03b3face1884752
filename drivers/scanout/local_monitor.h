// The operators' monitor on the simulator's side: a file in the link folder (firmware/wire/link_monitor.h).
#pragma once

#include <sys/types.h>

#include <memory>
#include <string>

#include "drivers/base/unique_fd.h"
#include "drivers/ports/side_display.h"
#include "firmware/wire/link_monitor.h"

namespace kaori::scanout {

// As ports::SideDisplay. One thread.
class LocalMonitor final : public ports::SideDisplay {
 public:
  // Null while nobody shows a monitor. Makes no file.
  static std::unique_ptr<LocalMonitor> Open(const std::string& folder);

  int width_px() const override { return static_cast<int>(header_.width_px); }
  int height_px() const override { return static_cast<int>(header_.height_px); }
  bool fresh() const override { return !shown_; }
  Result<void> Show(std::span<const std::uint8_t> rgbx, std::span<const ports::DisplayArea> areas) override;

  // Whether the file is there still: one that was made anew is another monitor.
  bool IsThere() const;

 private:
  LocalMonitor(UniqueFd file, std::string path, const wire::MonitorHeader& header);
  Result<void> Write(std::span<const std::uint8_t> bytes, std::size_t at) const;
  // Writes the next number.
  Result<void> Count();

  UniqueFd file_;
  std::string path_;
  wire::MonitorHeader header_;
  dev_t device_ = 0;
  ino_t inode_ = 0;
  bool shown_ = false;
};

}  // namespace kaori::scanout
