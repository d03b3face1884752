#include "appliance/programs/boot/pc_faults.h"

#include <sys/klog.h>
#include <sys/stat.h>

#include <algorithm>
#include <ctime>
#include <string>
#include <utility>

#include "appliance/programs/boot/clock_floor.h"
#include "appliance/programs/boot/graphics_fault.h"

namespace kaori::boot {
namespace {

Date DateOf(std::time_t seconds) {
  return Date{std::chrono::seconds(seconds)};
}

// The kernel's log since its start; empty where it may not be read.
std::string KernelLog() {
  constexpr int kReadAll = 3,
                kBufferSize = 10;  // syslog(2): SYSLOG_ACTION_READ_ALL, SYSLOG_ACTION_SIZE_BUFFER.
  std::string log(static_cast<std::size_t>(std::max(0, ::klogctl(kBufferSize, nullptr, 0))), '\0');
  const int read = ::klogctl(kReadAll, log.data(), static_cast<int>(log.size()));
  log.resize(static_cast<std::size_t>(std::max(0, read)));
  return log;
}

// A show log with dates of another century would help nobody. Empty where the clock may be right.
std::string MendClock(const std::filesystem::path& of_image, const std::filesystem::path& kept) {
  struct stat image {};
  if (::stat(of_image.c_str(), &image) != 0) return {};
  const Date now = DateOf(::time(nullptr));
  const auto mended = MendedClock(now, DateOf(image.st_mtim.tv_sec), kept);
  if (!mended) return {};
  const timespec set{.tv_sec = mended->time_since_epoch().count(), .tv_nsec = 0};
  const bool is_set = ::clock_settime(CLOCK_REALTIME, &set) == 0;
  return "this PC forgot the time: its clock stood at " + Shown(now) +
         (is_set ? " and goes on from " + Shown(*mended) : "") + "; set it in the firmware's setup, to UTC";
}

}  // namespace

std::vector<Fault> PcFaults(const std::filesystem::path& of_image, const std::filesystem::path& kept) {
  std::vector<Fault> faults;
  for (std::string& line : GraphicsFaults(UndrivenCards("/sys/bus/pci/devices"), WantedFirmware(KernelLog())))
    faults.push_back({std::move(line), Trouble::kGraphics});
  if (auto clock = MendClock(of_image, kept); !clock.empty())
    faults.push_back({std::move(clock), Trouble::kClock});
  return faults;
}

}  // namespace kaori::boot
