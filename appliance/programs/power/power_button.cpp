#include "appliance/programs/power/power_button.h"

#include <fcntl.h>
#include <linux/input.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string>
#include <system_error>

namespace kaori::power {
namespace {

constexpr std::size_t kEventsAtOnce = 16;
constexpr std::size_t kBitsOfByte = 8;

bool IsOfTheMachine(int fd) {
  input_id id{};
  std::array<std::uint8_t, KEY_CNT / kBitsOfByte> keys{};
  if (::ioctl(fd, EVIOCGID, &id) < 0 || ::ioctl(fd, EVIOCGBIT(EV_KEY, keys.size()), keys.data()) < 0)
    return false;
  const bool powers = (keys[KEY_POWER / kBitsOfByte] >> KEY_POWER % kBitsOfByte & 1) != 0;
  return powers && id.bustype == BUS_HOST;
}

bool IsPress(const input_event& event) {
  return event.type == EV_KEY && event.code == KEY_POWER && event.value == 1;
}

}  // namespace

std::vector<PowerButton> PowerButton::FindAll(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> names;
  std::error_code failed;
  for (const auto& entry : std::filesystem::directory_iterator(folder, failed))
    if (entry.path().filename().string().starts_with("event")) names.push_back(entry.path());
  std::ranges::sort(names);
  std::vector<PowerButton> found;
  for (const auto& name : names) {
    UniqueFd device(::open(name.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    if (device.valid() && IsOfTheMachine(device.get())) found.emplace_back(std::move(device));
  }
  return found;
}

// evdev gives whole events only; what is no whole event comes from no such device.
Result<bool> PowerButton::ReadPress() {
  bool pressed = false;
  while (true) {
    std::array<input_event, kEventsAtOnce> events;
    const ssize_t got = ::read(device_.get(), events.data(), sizeof(events));
    if (got < 0 && errno == EAGAIN) return pressed;
    if (got < 0 && errno != EINTR) return FailErrno("read the power button");
    if (got == 0) return Fail(std::errc::no_such_device, "read the power button");
    const auto count = static_cast<std::size_t>(std::max<ssize_t>(got, 0)) / sizeof(input_event);
    pressed |= std::any_of(events.begin(), events.begin() + static_cast<std::ptrdiff_t>(count), IsPress);
  }
}

}  // namespace kaori::power
