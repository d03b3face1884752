#include "drivers/base/log.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string>

namespace kaori {
namespace {

std::string& LogName() {
  static std::string name = "kaori";
  return name;
}

// As systemd.exec(5) asks: a program whose standard error was redirected since inherits the variable too.
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

void LogLines(Severity severity, std::string_view lines) {
  const std::string prefix = IsJournal(STDERR_FILENO) ? fmt::format("<{}>", static_cast<int>(severity)) : "";
  std::string whole;
  do {
    const auto end = std::min(lines.find('\n'), lines.size());
    whole += fmt::format("{}{}: {}\n", prefix, LogName(), lines.substr(0, end));
    lines.remove_prefix(std::min(end + 1, lines.size()));
  } while (!lines.empty());
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, whole.data(), whole.size());
}

}  // namespace kaori
