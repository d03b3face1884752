#include "tests/hil/agent/serial_line.h"

#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

#include <string_view>

#include <fmt/format.h>

namespace kaori::agent {

Result<SerialLine> SerialLine::Open(const std::string& device) {
  UniqueFd line(::open(device.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC));
  if (!line.valid()) return FailErrno("open " + device);
  termios settings{};
  if (::tcgetattr(line.get(), &settings) < 0) return FailErrno("read the settings of " + device);
  ::cfmakeraw(&settings);
  ::cfsetspeed(&settings, B115200);
  settings.c_cflag |= CLOCAL;
  if (::tcsetattr(line.get(), TCSANOW, &settings) < 0) return FailErrno("set " + device);
  return SerialLine(std::move(line));
}

std::optional<std::string> SerialLine::Next() {
  std::string line;
  for (char letter = 0; ::read(line_.get(), &letter, 1) == 1;) {
    if (letter == '\n') return line;
    line += letter;
  }
  return std::nullopt;
}

void SerialLine::Answer(const Result<std::string>& answer) {
  const std::string text = answer ? *answer : answer.error().message();
  const std::string whole = fmt::format("\x02{} {}\n{}", answer ? "OK" : "NO", text.size(), text);
  for (std::string_view rest = whole; !rest.empty();) {
    const ssize_t written = ::write(line_.get(), rest.data(), rest.size());
    if (written <= 0) return;
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace kaori::agent
