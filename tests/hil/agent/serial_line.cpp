#include "tests/hil/agent/serial_line.h"

#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

#include <fmt/format.h>

#include "drivers/base/number.h"

namespace kaori::agent {

std::optional<Question> ParseQuestion(std::string_view line) {
  const std::size_t space = line.find(' ');
  const auto number = ParseNumber<std::uint32_t>(line.substr(0, space));
  if (!number || space == std::string_view::npos) return std::nullopt;
  return Question{*number, std::string(line.substr(space + 1))};
}

std::string AnswerTo(std::uint32_t number, const Result<std::string>& answer) {
  const std::string text = answer ? *answer : answer.error().message();
  return fmt::format("\x02{} {} {}\n{}", answer ? "OK" : "NO", number, text.size(), text);
}

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

std::optional<Question> SerialLine::Next() {
  std::string line;
  for (char letter = 0; ::read(line_.get(), &letter, 1) == 1;) {
    if (letter != '\n') {
      line += letter;
      continue;
    }
    if (auto question = ParseQuestion(line)) return question;
    line.clear();
  }
  return std::nullopt;
}

void SerialLine::Answer(std::uint32_t number, const Result<std::string>& answer) {
  const std::string whole = AnswerTo(number, answer);
  for (std::string_view rest = whole; !rest.empty();) {
    const ssize_t written = ::write(line_.get(), rest.data(), rest.size());
    if (written <= 0) return;
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace kaori::agent
