#include "appliance/programs/power/power_button.h"

#include <fcntl.h>
#include <linux/input.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string>

#include "drivers/base/folder.h"

namespace kaori::power {
namespace {

// A press and its release are four events, each key with an EV_SYN behind it; more than 16 take another
// read(2).
constexpr std::size_t kEventsAtOnce = 16;
constexpr std::size_t kBitsOfByte = 8;

// The kernel's ACPI button names BUS_HOST as its bus; a keyboard on USB names BUS_USB. A device that does not
// answer one of the two requests is none of the machine's.
bool IsOfTheMachine(int fd) {
  input_id id{};
  std::array<std::uint8_t, KEY_CNT / kBitsOfByte> keys{};
  if (::ioctl(fd, EVIOCGID, &id) < 0 || ::ioctl(fd, EVIOCGBIT(EV_KEY, keys.size()), keys.data()) < 0)
    return false;
  const bool powers = (keys[KEY_POWER / kBitsOfByte] >> KEY_POWER % kBitsOfByte & 1) != 0;
  return powers && id.bustype == BUS_HOST;
}

// The value of a key's event is 0 for a release, 1 for a press and 2 for a repetition (the kernel's
// Documentation/input/event-codes.rst).
bool IsPress(const input_event& event) {
  return event.type == EV_KEY && event.code == KEY_POWER && event.value == 1;
}

}  // namespace

// Devices that come later are not looked for: the machine's own buttons are there when the kernel has
// started.
std::vector<PowerButton> PowerButton::FindAll(const std::filesystem::path& folder) {
  std::vector<PowerButton> found;
  for (const auto& name : ListFolder(folder).value_or(std::vector<std::filesystem::path>{})) {
    if (!name.filename().string().starts_with("event")) continue;
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
