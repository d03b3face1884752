#include "drivers/scanout/local_monitor.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <utility>

namespace kaori::scanout {

LocalMonitor::LocalMonitor(UniqueFd file, std::string path, const wire::MonitorHeader& header)
    : file_(std::move(file)), path_(std::move(path)), header_(header) {
  struct stat found {};
  if (::fstat(file_.get(), &found) != 0) return;
  device_ = found.st_dev;
  inode_ = found.st_ino;
}

// O_NOFOLLOW: the folder is everybody's on a desk.
std::unique_ptr<LocalMonitor> LocalMonitor::Open(const std::string& folder) {
  std::string path = folder + wire::kMonitorFile;
  UniqueFd file(::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  if (!file.valid()) return nullptr;
  std::array<std::uint8_t, wire::kMonitorHeader_bytes> bytes{};
  if (::pread(file.get(), bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    return nullptr;
  const auto header = wire::DecodeMonitorHeader(bytes);
  if (!header) return nullptr;
  return std::unique_ptr<LocalMonitor>(new LocalMonitor(std::move(file), std::move(path), *header));
}

bool LocalMonitor::IsThere() const {
  struct stat found {};
  return ::lstat(path_.c_str(), &found) == 0 && found.st_dev == device_ && found.st_ino == inode_;
}

Result<void> LocalMonitor::Write(std::span<const std::uint8_t> bytes, std::size_t at) const {
  if (::pwrite(file_.get(), bytes.data(), bytes.size(), static_cast<off_t>(at)) !=
      static_cast<ssize_t>(bytes.size()))
    return FailErrno("write " + path_);
  return {};
}

Result<void> LocalMonitor::Count() {
  ++header_.count;
  std::array<std::uint8_t, 4> count{};
  wire::PutU32(count, 0, header_.count);
  return Write(count, wire::kMonitorCountAt);
}

// Whole rows, which lie together in both; beside an area they hold what is shown already.
Result<void> LocalMonitor::Show(std::span<const std::uint8_t> rgbx,
                                std::span<const ports::DisplayArea> areas) {
  if (rgbx.size() != header_.picture_bytes())
    return FailInput("show a picture of another size on the monitor");
  for (const ports::DisplayArea& area : areas)
    if (!ports::IsWithin(area, width_px(), height_px())) return FailInput("show an area beyond the monitor");
  header_.count &= ~1U;  // A Show that failed in the middle left it odd.
  if (auto begun = Count(); !begun) return begun;
  const std::size_t row = std::size_t{header_.width_px} * 4;
  for (const ports::DisplayArea& area : areas) {
    const std::size_t from = row * static_cast<std::size_t>(area.bottom_px);
    const std::size_t bytes = row * static_cast<std::size_t>(area.top_px - area.bottom_px);
    if (auto written = Write(rgbx.subspan(from, bytes), wire::kMonitorHeader_bytes + from); !written)
      return written;
  }
  if (auto ended = Count(); !ended) return ended;
  shown_ = true;
  return {};
}

}  // namespace kaori::scanout
