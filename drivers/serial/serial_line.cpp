#include "drivers/serial/serial_line.h"

#include <fcntl.h>
#include <linux/serial.h>
#include <sys/ioctl.h>
#include <termios.h>

#include "drivers/base/open_cause.h"

namespace kaori::serial {
namespace {

// Adapters that cannot do it say so, and are as they were.
void AskForLowLatency(int fd) {
  serial_struct settings{};
  if (::ioctl(fd, TIOCGSERIAL, &settings) != 0) return;
  settings.flags |= ASYNC_LOW_LATENCY;
  ::ioctl(fd, TIOCSSERIAL, &settings);
}

}  // namespace

Result<UniqueFd> OpenSerialLine(const std::string& path) {
  UniqueFd line(::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (!line.valid()) return Fail(CauseOfOpen(errno), "open the serial line " + path);
  if (::ioctl(line.get(), TIOCEXCL) != 0) return FailErrno("have the serial line " + path + " alone");
  termios mode{};
  if (::tcgetattr(line.get(), &mode) != 0) return FailErrno("set up the serial line " + path);
  ::cfmakeraw(&mode);
  mode.c_cflag = static_cast<tcflag_t>(CS8 | CREAD | CLOCAL);
  // With VMIN 1 a line without bytes says EAGAIN, and only one that hung up reads 0 bytes.
  mode.c_cc[VMIN] = 1;
  mode.c_cc[VTIME] = 0;
  ::cfsetispeed(&mode, B9600);
  ::cfsetospeed(&mode, B9600);
  if (::tcsetattr(line.get(), TCSANOW, &mode) != 0) return FailErrno("set up the serial line " + path);
  AskForLowLatency(line.get());
  ::tcflush(line.get(), TCIOFLUSH);
  return line;
}

}  // namespace kaori::serial
