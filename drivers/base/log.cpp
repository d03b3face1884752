#include "drivers/base/log.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string>

namespace kaori {
namespace {

// A function's static, so that a line that a global's constructor logs finds the name built.
std::string& LogName() {
  static std::string name = "kaori";
  return name;
}

// As systemd.exec(5) asks: a program whose standard error was redirected since inherits the
// variable too, so that the device and the inode are compared. It is asked for each line: a
// supervisor may have replaced the descriptor by dup2(2).
bool IsJournal(int fd) {
  const char* const stream = std::getenv("JOURNAL_STREAM");
  struct stat status {};
  if (stream == nullptr || ::fstat(fd, &status) < 0) return false;
  return stream == fmt::format("{}:{}", status.st_dev, status.st_ino);
}

}  // namespace

void SetLogName(std::string_view name) {
  LogName() = name;
}

std::string LogPrefix(Severity severity) {
  const std::string rank = IsJournal(STDERR_FILENO) ? fmt::format("<{}>", static_cast<int>(severity)) : "";
  return fmt::format("{}{}: ", rank, LogName());
}

// What cannot be written is lost: a log that failed has nowhere to be told.
void LogLines(Severity severity, std::string_view lines) {
  const std::string prefix = LogPrefix(severity);
  std::string whole;
  // One write(2) for all lines: a pipe keeps up to 4096 bytes together
  // (PIPE_BUF), so that lines of several programs do not mix.
  do {
    const auto end = std::min(lines.find('\n'), lines.size());
    whole += fmt::format("{}{}\n", prefix, lines.substr(0, end));
    // An empty text still gives one line: the loop runs at least once.
    lines.remove_prefix(std::min(end + 1, lines.size()));
  } while (!lines.empty());
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, whole.data(), whole.size());
}

}  // namespace kaori
