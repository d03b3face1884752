#include "drivers/base/log.h"

#include <unistd.h>

#include <string>

namespace kaori {
namespace {

std::string& Name() {
  static std::string name = "kaori";
  return name;
}

}  // namespace

void SetLogName(std::string_view name) { Name() = name; }

void LogLine(std::string_view line) {
  const std::string whole = fmt::format("{}: {}\n", Name(), line);
  // Nobody is left to tell when standard error itself fails.
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, whole.data(), whole.size());
}

}  // namespace kaori
