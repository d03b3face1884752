#include "hw-sim/links/local/monitor_screen.h"

#include <fcntl.h>
#include <unistd.h>

#include <optional>
#include <span>
#include <utility>

#include "firmware/wire/link_monitor.h"

namespace kaori::sim {
namespace {

constexpr std::size_t kPicture_bytes = std::size_t{MonitorScreen::kWidth_px} * MonitorScreen::kHeight_px * 4;

// Whether all of it was there.
bool ReadAt(int file, std::size_t at, std::span<std::uint8_t> into) {
  return ::pread(file, into.data(), into.size(), static_cast<off_t>(at)) == static_cast<ssize_t>(into.size());
}

}  // namespace

// The header is written last: a stage that comes meanwhile finds no monitor.
Result<void> MonitorScreen::Plug() {
  if (plugged()) return {};
  const std::string path = folder_ + wire::kMonitorFile;
  ::unlink(path.c_str());
  UniqueFd file(::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0600));
  if (!file.valid()) return FailErrno("make " + path);
  const auto header = wire::Encode(wire::MonitorHeader{kWidth_px, kHeight_px, 0});
  if (::ftruncate(file.get(), static_cast<off_t>(wire::kMonitorHeader_bytes + kPicture_bytes)) != 0 ||
      ::pwrite(file.get(), header.data(), header.size(), 0) != static_cast<ssize_t>(header.size())) {
    auto failed = FailErrno("write " + path);
    ::unlink(path.c_str());
    return failed;
  }
  file_ = std::move(file);
  read_ = 0;
  return {};
}

void MonitorScreen::Unplug() {
  if (!plugged()) return;
  ::unlink((folder_ + wire::kMonitorFile).c_str());
  file_ = {};
}

// The count is looked at before and behind: what differs was read while it was written.
const std::vector<std::uint8_t>* MonitorScreen::Read() {
  bytes_.resize(wire::kMonitorHeader_bytes);
  const auto count_now = [this]() -> std::optional<std::uint32_t> {
    if (!ReadAt(file_.get(), 0, bytes_)) return std::nullopt;
    const auto header = wire::DecodeMonitorHeader(bytes_);
    return header ? std::optional(header->count) : std::nullopt;
  };
  if (!plugged()) return nullptr;
  const auto count = count_now();
  if (!count || *count == read_ || *count % 2 != 0) return nullptr;
  picture_.resize(kPicture_bytes);
  if (!ReadAt(file_.get(), wire::kMonitorHeader_bytes, picture_) || count_now() != count) return nullptr;
  read_ = *count;
  return &picture_;
}

}  // namespace kaori::sim
