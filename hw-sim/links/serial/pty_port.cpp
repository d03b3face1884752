#include "hw-sim/links/serial/pty_port.h"

#include <fcntl.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <array>

namespace kaori::sim {

// The name is a link that is made last: a driver that finds it finds a line that works. Plugging in twice
// does nothing.
Result<void> PtyPort::Plug() {
  if (box_end_.valid()) return {};
  UniqueFd box_end(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (!box_end.valid() || ::grantpt(box_end.get()) != 0 || ::unlockpt(box_end.get()) != 0)
    return FailErrno("make a pseudo-terminal");
  std::array<char, 64> name{};
  if (::ptsname_r(box_end.get(), name.data(), name.size()) != 0) return FailErrno("name a pseudo-terminal");
  UniqueFd line(::open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC));
  termios mode{};
  if (!line.valid() || ::tcgetattr(line.get(), &mode) != 0) return FailErrno("open a pseudo-terminal");
  // Nothing is echoed before the driver has set the line up.
  ::cfmakeraw(&mode);
  ::cfsetspeed(&mode, B9600);
  ::tcsetattr(line.get(), TCSANOW, &mode);
  ::unlink(path_.c_str());
  if (::symlink(name.data(), path_.c_str()) != 0) return FailErrno("plug a serial box in at " + path_);
  box_end_ = std::move(box_end);
  line_ = std::move(line);
  return {};
}

void PtyPort::Unplug() {
  if (!box_end_.valid()) return;
  ::unlink(path_.c_str());
  box_end_.reset();
  line_.reset();
  box_.PowerCycle();
}

// Both speeds are 9600 where nobody did anything wrong.
bool PtyPort::has_its_speed() const {
  termios mode{};
  return ::tcgetattr(line_.get(), &mode) == 0 && ::cfgetospeed(&mode) == B9600 &&
         box_.baud() == SerialDialBox::kBaud;
}

// Bits that are sampled at the wrong times: what comes has little to do with what was sent.
std::size_t PtyPort::Pump(Time now) {
  if (!box_end_.valid()) return 0;
  std::array<std::uint8_t, 256> heard;
  const ssize_t got = ::read(box_end_.get(), heard.data(), heard.size());
  if (got > 0 && has_its_speed()) box_.Receive(std::span(heard).first(static_cast<std::size_t>(got)), now);
  auto said = box_.Send(now);
  if (!has_its_speed())
    for (std::uint8_t& byte : said) byte = static_cast<std::uint8_t>(byte * 37U + 0x60U);
  SendRaw(said);
  return said.size();
}

void PtyPort::SendRaw(std::span<const std::uint8_t> bytes) {
  if (!bytes.empty()) (void)!::write(box_end_.get(), bytes.data(), bytes.size());
}

}  // namespace kaori::sim
